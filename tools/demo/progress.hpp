// Progress on the error output: a bar on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace demo {

class Progress {
 public:
  Progress(std::string what, std::uint64_t total);

  /// `done` of `total` are done. Cheap: writes only when the shown text changes.
  void show(std::uint64_t done);

  /// Ends the line.
  void finish();

 private:
  std::string what_;
  std::uint64_t total_;
  std::uint64_t shown_percent_ = UINT64_MAX;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace demo
