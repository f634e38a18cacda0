// SPDX-License-Identifier: Apache-2.0
// Checks of a contact problem on arrays, and the problem that the modules solve.
#ifndef ABUT_CAPI_PROBLEM_ARGUMENTS_HPP
#define ABUT_CAPI_PROBLEM_ARGUMENTS_HPP

#include <abut/response.h>

#include <array>
#include <vector>

import abut.response;

namespace abut::capi {

/// The frame that the rows of a contact stand in, and how much of a tangent impulse one of the round cone is.
struct ContactFrame {
  std::array<abut_vec3, 3> axes;  // t, s, n; units
  std::array<double, 3> scales;   // of t and s: friction by that of the cone; 1 of n
};

struct PreparedProblem {
  response::Problem problem;
  response::Solution solution;  // where the search begins, if anywhere
  std::vector<ContactFrame> frames;
  bool is_warm = false;
};

/// Reads a problem; writes this thread's message and answers the status where there is something to object to.
[[nodiscard]] abut_status prepare(const abut_contact_problem& given, PreparedProblem& out);
[[nodiscard]] abut_status check_options(const abut_solver_options& options) noexcept;

}  // namespace abut::capi

#endif
