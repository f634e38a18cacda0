// SPDX-License-Identifier: Apache-2.0
// The contact problem of response.h: checks arguments, keeps exceptions in, and hands on to abut.response.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/problem_arguments.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <span>

#include "defaults.hpp"

import abut.response;

namespace {

using abut::capi::check_options;
using abut::capi::PreparedProblem;
using abut::capi::refuse;
using abut::capi::refuse_null;

constexpr abut_solver_options usual_options{.struct_size = sizeof(abut_solver_options),
                                            .most_rounds = 200,
                                            .tolerance = 1e-9,
                                            .speed = 0,
                                            .solver = ABUT_SOLVER_NEWTON,
                                            .reserved = 0};

[[nodiscard]] abut_status solve(const abut_contact_problem& given, const abut_solver_options& options,
                                std::span<double> velocities, std::span<double> impulses, abut_residuals& out) {
  PreparedProblem prepared;
  if (const abut_status status = abut::capi::prepare(given, prepared); status != ABUT_OK) return status;
  const auto report = abut::response::solve(prepared.problem,
                                            {.tolerance = options.tolerance,
                                             .speed = options.speed,
                                             .most_rounds = options.most_rounds,
                                             .is_warm = prepared.is_warm,
                                             .method = abut::capi::method_of(options.solver)},
                                            prepared.solution);
  if (!report.is_finite) {
    return refuse(ABUT_NOT_CONVERGED,
                  "no finite velocities were found; masses, arms and compliances are too far apart in size");
  }
  for (std::size_t i = 0; i < prepared.solution.velocities.size(); ++i) {
    std::ranges::copy(prepared.solution.velocities[i], velocities.subspan(6 * i, 6).begin());
  }
  for (std::size_t k = 0; k < prepared.solution.impulses.size(); ++k) {
    const abut_vec3 impulse =
        abut::response::world_impulse(prepared.problem.contacts[k], prepared.solution.impulses[k]);
    const std::span<double> place = impulses.subspan(3 * k, 3);
    place[0] = impulse.x;
    place[1] = impulse.y;
    place[2] = impulse.z;
  }
  out = abut::response::residuals_of(report);
  return ABUT_OK;
}

}  // namespace

void abut_contact_problem_init(abut_contact_problem* problem, uint32_t struct_size) {
  abut::capi::fill_defaults(abut_contact_problem{}, struct_size, problem);
}

void abut_solver_options_init(abut_solver_options* options, uint32_t struct_size) {
  abut::capi::fill_defaults(usual_options, struct_size, options);
}

abut_status abut_contact_problem_solve(const abut_contact_problem* problem, const abut_solver_options* options,
                                       double* velocities, double* impulses, abut_residuals* out) {
  if (problem == nullptr) return refuse_null("problem");
  if (options != nullptr) {
    if (const abut_status status = check_options(*options); status != ABUT_OK) return status;
  }
  if (problem->body_count != 0 && velocities == nullptr) return refuse_null("velocities");
  if (problem->contact_count != 0 && impulses == nullptr) return refuse_null("impulses");
  if (out == nullptr) return refuse_null("out");
  // SAFETY: the caller answers for six numbers a body and three a contact.
  ABUT_UNSAFE_BEGIN
  const std::span<double> moving(velocities, std::size_t{6} * problem->body_count);
  const std::span<double> pushing(impulses, std::size_t{3} * problem->contact_count);
  ABUT_UNSAFE_END
  try {
    return solve(*problem, options == nullptr ? usual_options : *options, moving, pushing, *out);
  } catch (const std::bad_alloc&) {
    return refuse(ABUT_OUT_OF_MEMORY, "there is not enough memory for the contact problem");
  } catch (...) {
    return refuse(ABUT_INTERNAL, "the contact problem could not be solved");
  }
}
