// SPDX-License-Identifier: Apache-2.0
// Checks of a contact problem on arrays, and the problem that the modules solve.
#ifndef ABUT_CAPI_PROBLEM_ARGUMENTS_HPP
#define ABUT_CAPI_PROBLEM_ARGUMENTS_HPP

#include <abut/response.h>

import abut.response;

namespace abut::capi {

struct PreparedProblem {
  response::Problem problem;
  response::Solution solution;  // where the search begins, if anywhere
  bool is_warm = false;
};

[[nodiscard]] inline response::Method method_of(abut_solver solver) noexcept {
  return solver == ABUT_SOLVER_SWEEPS ? response::Method::sweeps : response::Method::newton;
}

/// Reads a problem; writes this thread's message and answers the status where there is something to object to.
[[nodiscard]] abut_status prepare(const abut_contact_problem& given, PreparedProblem& out);
[[nodiscard]] abut_status check_options(const abut_solver_options& options) noexcept;

}  // namespace abut::capi

#endif
