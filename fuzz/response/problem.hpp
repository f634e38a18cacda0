// SPDX-License-Identifier: Apache-2.0
// A contact problem of given bytes, and what has to hold of its answer whatever they are.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "world.hpp"

namespace response_fuzzing {

struct Problem {
  response_test::World world;
  abut_solver_options options;
  bool is_valid = true;  // whether the interface has to accept it
};

// A byte a size: most are between a largest one and 1e-12 of it, some are 0, and one may be no number that is accepted.
[[nodiscard]] Problem problem_of(std::span<const std::uint8_t> bytes);

// Empty, or what is wrong with the answer.
[[nodiscard]] std::string finding_of(std::span<const std::uint8_t> bytes);

}  // namespace response_fuzzing
