// SPDX-License-Identifier: Apache-2.0
// What happens when the user ends the program early.
#pragma once

#include <cstdint>

#include <csignal>

#include "failures.hpp"

namespace cli {

/// The user ended the program.
class Interrupted : public Failure {
 public:
  using Failure::Failure;
};

/// While one lives, SIGINT, SIGTERM and SIGHUP end the program at the next step, so that files that are not complete
/// go away. A second one ends it at once. A reader that goes away is a failure to write, for the same reason.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  [[nodiscard]] bool has_come() const;

  /// Throws Interrupted if a signal has come.
  void check(std::uint64_t step, std::uint64_t steps) const;
};

}  // namespace cli
