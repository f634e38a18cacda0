// SPDX-License-Identifier: Apache-2.0
// Progress on the error output: a bar on a terminal; elsewhere a line now and then, or nothing.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace tools {

/// Where progress is told when the error output is no terminal.
enum class Elsewhere { lines, nothing };

class Progress {
 public:
  Progress(std::string what, std::uint64_t total, Elsewhere elsewhere = Elsewhere::lines);

  /// `done` of `total` are done. Cheap: writes only when the shown text changes.
  void show(std::uint64_t done);

  /// Ends the line when all is done.
  void finish();

  /// Ends the line where it is.
  void stop() const;

 private:
  std::string what_;
  std::uint64_t total_;
  std::uint64_t shown_percent_ = UINT64_MAX;
  bool terminal_;
  bool lines_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace tools
