// SPDX-License-Identifier: Apache-2.0
// Why the program ends, and its exit status for each.
#pragma once

#include "common/owners.hpp"

namespace cli {

using namespace tools;

/// What the program answers to its caller.
enum class Status : int {
  done = 0,
  bad_input = 1,       ///< the arguments or the scene
  library_failed = 2,  ///< a call of abut failed on a scene that it had taken, or memory ran out
  bad_output = 3,      ///< a file could not be written
  odd = 4,             ///< something about the scene will surprise
  interrupted = 130    ///< a signal ended the program, as shells count it
};

class BadInput : public Failure {
 public:
  using Failure::Failure;
};

class BadOutput : public Failure {
 public:
  using Failure::Failure;
};

/// Whether a failing call speaks of what it was given, and not of memory or of a defect.
[[nodiscard]] constexpr bool blames_input(abut_status status) {
  return status != ABUT_OUT_OF_MEMORY && status != ABUT_INTERNAL && status != ABUT_NOT_CONVERGED;
}

/// Refuses what the scene says at a place of it, with the last message of the library.
inline void check_scene(abut_status status, const std::string& path) {
  if (status != ABUT_OK && blames_input(status)) {
    throw BadInput(path + ": the library says: " + abut_last_error_message());
  }
  tools::check(status, path.c_str());
}

}  // namespace cli
