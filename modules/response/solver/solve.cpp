// SPDX-License-Identifier: Apache-2.0
// What both methods begin and end with.
module;

#include <algorithm>
#include <cmath>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// The largest speed of a body or of two surfaces in the free motion.
[[nodiscard]] double free_speed(const Problem& problem) {
  double speed = 0;
  for (const Row& v : problem.free) speed = std::max(speed, norm_of(v[0], v[1], v[2]));
  for (const ContactRows& contact : problem.contacts) {
    const Triple u = relative_velocity(contact, problem.free);
    speed = std::max(speed, norm_of(u[0], u[1], u[2] - contact.offset));
  }
  return speed;
}

[[nodiscard]] bool is_finite(const Solution& solution) {
  const auto all = [](const auto& numbers) {
    return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
  };
  return std::ranges::all_of(solution.velocities, all) && std::ranges::all_of(solution.impulses, all);
}

}  // namespace

SolverReport solve(const Problem& problem, const SolverOptions& options, Solution& solution) {
  if (!options.is_warm) {
    solution.velocities = problem.free;
    solution.impulses.assign(problem.contacts.size(), Triple{});
  }
  const double speed = options.speed > 0 ? options.speed : free_speed(problem);
  SolverReport report = options.method == Method::sweeps ? sweeps_of(problem, options, speed, solution)
                                                         : rounds_of_newton(problem, options, speed, solution);
  report.is_finite = is_finite(solution);
  return report;
}

}  // namespace abut::response
