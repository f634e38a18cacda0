// SPDX-License-Identifier: Apache-2.0
// What both methods begin and end with.
module;

#include <algorithm>
#include <cmath>
#include <utility>
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

// Sweeps bring impulses from body to body: through a stack whose masses differ by more than this, hardly at all.
constexpr double largest_ratio = 1e3;
// What is left to be of use, as a part of the speed.
constexpr double usable = 1e-2;

[[nodiscard]] double ratio_of_masses(const Problem& problem) {
  double least = problem.bodies.front().mass, most = least;
  for (const BodyMass& body : problem.bodies) {
    least = std::min(least, body.mass);
    most = std::max(most, body.mass);
  }
  return most / least;
}

// Sweeps; where they end with velocities of no use between masses that differ much, Newton's method from the same
// start. Steps of such an answer would drive bodies into each other.
SolverReport sweeps_or_newton(const Problem& problem, const SolverOptions& options, double speed, Solution& solution) {
  const Solution start = solution;
  const SolverReport swept = sweeps_of(problem, options, speed, solution);
  const bool is_of_use = swept.residuals.excess <= std::max(usable, options.tolerance) * speed;
  if (swept.is_converged || is_of_use || !(ratio_of_masses(problem) > largest_ratio)) return swept;
  Solution other = start;
  SolverReport report = rounds_of_newton(problem, options, speed, other);
  report.rounds += swept.rounds;
  if (!is_finite(other) || !(report.residuals.excess < swept.residuals.excess)) return swept;
  solution = std::move(other);
  return report;
}

}  // namespace

SolverReport solve(const Problem& problem, const SolverOptions& options, Solution& solution) {
  if (!options.is_warm) {
    solution.velocities = problem.free;
    solution.impulses.assign(problem.contacts.size(), Triple{});
  }
  const double speed = options.speed > 0 ? options.speed : free_speed(problem);
  const bool is_by_sweeps = options.method == Method::sweeps && problem.elements.empty();
  SolverReport report = is_by_sweeps ? sweeps_or_newton(problem, options, speed, solution)
                                     : rounds_of_newton(problem, options, speed, solution);
  report.is_finite = is_finite(solution);
  return report;
}

}  // namespace abut::response
