// SPDX-License-Identifier: Apache-2.0
// Springs and tetrahedra of particles in a step. By implicit Euler: forces are those of the places at the end of the
// step, which Newton's method looks for around the contact problem. Each of its turns makes forces linear where the
// last one has ended.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

[[nodiscard]] std::uint32_t number_in(const Island& island, std::uint32_t body) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(island.bodies, body) - island.bodies.begin());
}

[[nodiscard]] std::array<double, 3> numbers_of(const abut_vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

void Simulation::add_springs(abut_geometry_id geometry, std::span<const Spring> springs) {
  for (Grains& its : grains_) {
    if (its.geometry.slot == geometry.slot) its.springs.insert(its.springs.end(), springs.begin(), springs.end());
  }
}

void Simulation::add_tetrahedra(abut_geometry_id geometry, std::span<const Tetrahedron> tetrahedra) {
  for (Grains& its : grains_) {
    if (its.geometry.slot != geometry.slot) continue;
    its.tetrahedra.insert(its.tetrahedra.end(), tetrahedra.begin(), tetrahedra.end());
  }
}

void Simulation::read_elements(std::size_t first, std::uint32_t grains, Pass& pass) const {
  const Grains& its = grains_[grains];
  const auto node = [&](std::uint32_t number) { return static_cast<std::uint32_t>(first + number); };
  for (std::uint32_t i = 0; i < its.springs.size(); ++i) {
    const Spring& spring = its.springs[i];
    pass.elements.push_back(
        {.grains = grains, .number = i, .count = 2, .nodes = {node(spring.a), node(spring.b), 0, 0}});
  }
  for (std::uint32_t i = 0; i < its.tetrahedra.size(); ++i) {
    const auto& [a, b, c, d] = its.tetrahedra[i].nodes;
    pass.elements.push_back({.grains = grains, .number = i, .count = 4, .nodes = {node(a), node(b), node(c), node(d)}});
  }
}

ElasticForce Simulation::force_of_element(const StepElement& element, const std::array<abut_vec3, 4>& places) const {
  const Grains& its = grains_[element.grains];
  return element.count == 2 ? force_of(its.springs[element.number], places)
                            : force_of(its.tetrahedra[element.number], places);
}

std::array<double, 144> Simulation::viscosity_of_element(const StepElement& element, const ElasticForce& force,
                                                         const std::array<abut_vec3, 4>& places) const {
  const Grains& its = grains_[element.grains];
  return element.count == 2 ? viscosity_of(its.springs[element.number], places)
                            : viscosity_of(its.tetrahedra[element.number], force);
}

// f(x + dt v) is f(end) - K (x + dt v - end), less what damping takes.
void Simulation::linearise(const Island& island, std::span<const std::uint32_t> elements,
                           const std::vector<abut_vec3>& ends, double dt, const Pass& pass, Problem& problem) const {
  problem.elements.clear();
  for (const std::uint32_t k : elements) {
    const StepElement& its = pass.elements[k];
    Element out;
    out.count = its.count;
    std::array<abut_vec3, 4> places{};
    std::array<double, 12> moved{};
    for (std::uint32_t i = 0; i < its.count; ++i) {
      const Motion& motion = pass.motions[its.nodes[i]];
      out.bodies[i] = motion.is_awake ? number_in(island, its.nodes[i]) : no_body;
      places[i] = motion.is_awake ? ends[out.bodies[i]] : motion.centre;
      const std::array<double, 3> way = numbers_of(subtract(places[i], motion.centre));
      for (std::size_t axis = 0; axis < 3; ++axis) moved[3 * i + axis] = way[axis];
    }
    const ElasticForce force = force_of_element(its, places);
    const std::array<double, 144> viscosity = viscosity_of_element(its, force, places);
    const std::size_t rows = 3 * std::size_t{its.count};
    // Forces follow from differences of coordinates.
    double largest = 0, stiffest = 0;
    for (const abut_vec3& place : places)
      largest = std::max({largest, std::fabs(place.x), std::fabs(place.y), std::fabs(place.z)});
    for (const double number : force.stiffness) stiffest = std::max(stiffest, std::fabs(number));
    out.size = dt * stiffest * largest;
    for (std::size_t i = 0; i < rows; ++i) {
      double sum = numbers_of(force.forces[i / 3])[i % 3];
      for (std::size_t j = 0; j < rows; ++j) {
        const std::size_t at = rows * i + j;
        sum += force.stiffness[at] * moved[j];
        out.change[at] = dt * (viscosity[at] + dt * force.stiffness[at]);
      }
      out.impulse[i] = dt * sum;
    }
    problem.elements.push_back(out);
  }
}

SolverReport Simulation::solve_with_elements(const Island& island, std::span<const std::uint32_t> elements, double dt,
                                             const Pass& pass, const SolverOptions& options, Problem& problem,
                                             Solution& solution) const {
  constexpr int most_turns = 30;
  std::vector<abut_vec3> starts;
  for (const std::uint32_t body : island.bodies) starts.push_back(pass.motions[body].centre);
  SolverOptions its = options;
  its.is_warm = true;
  solution.velocities = problem.free;
  SolverReport report;
  double least = std::numeric_limits<double>::infinity();
  Solution best = solution;
  std::vector<abut_vec3> ends = starts, best_ends = starts;
  linearise(island, elements, ends, dt, pass, problem);
  for (int turn = 0; turn < most_turns; ++turn) {
    SolverReport now = solve(problem, its, solution);
    if (!now.is_finite) return now;
    for (std::size_t i = 0; i < ends.size(); ++i)
      ends[i] = add(starts[i], scale(vector_of(solution.velocities[i], 0), dt));
    // What the law says where the bodies have come to, not where forces were linear.
    linearise(island, elements, ends, dt, pass, problem);
    now.residuals = residuals_of(problem, solution);
    now.is_converged = now.residuals.excess <= options.tolerance * now.speed;
    now.rounds += report.rounds;
    now.newton_steps += report.newton_steps;
    const bool is_better = now.residuals.excess < least;
    if (is_better) {
      least = now.residuals.excess;
      best = solution;
      best_ends = ends;
      report = now;
    } else {
      // Half the way back to where it was better.
      report.rounds = now.rounds;
      report.newton_steps = now.newton_steps;
      for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = scale(add(ends[i], best_ends[i]), 0.5);
      linearise(island, elements, ends, dt, pass, problem);
    }
    if (now.is_converged) break;
  }
  solution = std::move(best);
  return report;
}

}  // namespace abut::response
