// SPDX-License-Identifier: Apache-2.0
// Impulses of each island, and a push apart where rigid bodies overlap.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

std::vector<std::vector<std::uint32_t>> joined_by(const std::vector<StepContact>& contacts) {
  std::vector<std::vector<std::uint32_t>> out;
  out.reserve(contacts.size());
  for (const StepContact& contact : contacts) {
    std::vector<std::uint32_t>& bodies = out.emplace_back();
    for (const BodyRows& its : contact.rows.bodies) bodies.push_back(its.body);
    if (!contact.is_solved && contact.given == 0) bodies.resize(1);
  }
  return out;
}

namespace {

// Numbers of bodies within the island.
void renumber(ContactRows& rows, const Island& island) {
  for (BodyRows& its : rows.bodies)
    its.body = static_cast<std::uint32_t>(std::ranges::lower_bound(island.bodies, its.body) - island.bodies.begin());
}

}  // namespace

abut_residuals residuals_of(const SolverReport& report) {
  return {.contact = report.residuals.contact,
          .motion = report.residuals.motion,
          .dissipation = report.residuals.dissipation,
          .speed = report.speed,
          .rounds = report.rounds,
          .newton_steps = report.newton_steps,
          .is_converged = report.is_converged ? 1U : 0U,
          .reserved = 0};
}

// Velocities and impulses of an island, and a push apart. False where they are not finite.
bool Simulation::solve_island(const Island& island, std::span<const std::uint32_t> elements, double ahead, Pass& pass,
                              abut_response_island& told) const {
  std::vector<Motion>& motions = pass.motions;
  std::vector<StepContact>& contacts = pass.contacts;
  told.body_count = static_cast<std::uint32_t>(island.bodies.size());
  told.contact_count = static_cast<std::uint32_t>(island.contacts.size());
  std::vector<std::uint32_t> solved_contacts = island.contacts;
  std::erase_if(solved_contacts, [&](std::uint32_t k) { return !contacts[k].is_solved; });
  told.integrator = motions[island.bodies.front()].integrator;
  told.residuals.is_converged = 1;
  if (solved_contacts.empty() && elements.empty()) return true;
  Problem problem;
  Solution solution;
  for (const std::uint32_t body : island.bodies) {
    const Motion& motion = motions[body];
    problem.bodies.push_back({.mass = motion.mass, .inertia = motion.inertia});
    problem.free.push_back(row_of(motion.linear, motion.angular));
  }
  for (const std::uint32_t k : solved_contacts) {
    ContactRows rows = contacts[k].rows;
    renumber(rows, island);
    rows.weight = weight_of(rows, problem.bodies);
    const Triple start = allowed(rows, contacts[k].impulse);
    if (contacts[k].response == Response::augmented && ahead > 0 && contacts[k].compliance == 0) {
      rows.compliance = contacts[k].epsilon * rows.weight;
      rows.drift[2] -= rows.compliance * start[2];
    }
    problem.contacts.push_back(rows);
    solution.impulses.push_back(start);
  }
  const auto pushes = [](const Triple& impulse) { return impulse[0] != 0 || impulse[1] != 0 || impulse[2] != 0; };
  const bool is_warm = std::ranges::any_of(solution.impulses, pushes);
  if (is_warm) solution.velocities = velocities_of(problem, solution.impulses);
  const SolverOptions options{.tolerance = options_.tolerance,
                              .speed = 0,
                              .most_rounds = options_.most_rounds,
                              .is_warm = is_warm,
                              .method = options_.solver == ABUT_SOLVER_SWEEPS ? Method::sweeps : Method::newton};
  const SolverReport solved = elements.empty()
                                  ? solve(problem, options, solution)
                                  : solve_with_elements(island, elements, ahead, pass, options, problem, solution);
  for (const std::uint32_t k : elements) {
    for (std::uint32_t i = 0; i < pass.elements[k].count; ++i) motions[pass.elements[k].nodes[i]].is_pushed = true;
  }
  told.residuals = residuals_of(solved);
  if (!solved.is_finite) return false;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    Motion& motion = motions[island.bodies[i]];
    motion.linear = vector_of(solution.velocities[i], 0);
    motion.angular = vector_of(solution.velocities[i], 3);
  }
  for (std::size_t k = 0; k < solved_contacts.size(); ++k) {
    StepContact& contact = contacts[solved_contacts[k]];
    contact.impulse = solution.impulses[k];
    contact.velocity = relative_velocity(problem.contacts[k], solution.velocities);
    contact.velocity[2] -= problem.contacts[k].drift[2] - contact.rows.drift[2] + contact.rows.offset;
    contact.gap = contact.record.distance + ahead * contact.velocity[2];
    if (!pushes(contact.impulse)) continue;
    for (const BodyRows& its : contact.rows.bodies)
      motions[its.body].is_pushed = motions[its.body].is_pushed || !contact.is_middle;
  }
  return move_apart(island, solved_contacts, problem, pass);
}

// Rigid contacts that overlap at the end of the step are opened by the least moves, which change no velocity and tear
// no rigid link.
bool Simulation::move_apart(const Island& island, const std::vector<std::uint32_t>& solved_contacts,
                            const Problem& solved, Pass& pass) const {
  Problem problem{.bodies = solved.bodies, .free = std::vector<Row>(solved.bodies.size()), .contacts = {}};
  double deepest = 0;
  for (std::size_t k = 0; k < solved_contacts.size(); ++k) {
    const StepContact& contact = pass.contacts[solved_contacts[k]];
    ContactRows rows = solved.contacts[k];
    if (contact.compliance > 0) continue;
    rows.friction = rows.compliance = 0;
    rows.drift = {};
    rows.most = std::numeric_limits<double>::infinity();
    if (rows.law == Law::contact) {
      rows.offset = contact.gap + options_.slop;
      rows.drift[2] = rows.offset;
      deepest = std::max(deepest, -rows.offset);
    }
    problem.contacts.push_back(rows);
  }
  if (!(deepest > 0)) return true;
  Solution moves;
  const SolverReport report = solve(problem,
                                    {.tolerance = options_.tolerance,
                                     .speed = deepest,
                                     .most_rounds = options_.most_rounds,
                                     .is_warm = false,
                                     .method = Method::newton},
                                    moves);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    Motion& motion = pass.motions[island.bodies[i]];
    motion.shift = vector_of(moves.velocities[i], 0);
    motion.tilt = vector_of(moves.velocities[i], 3);
  }
  return report.is_finite;
}

bool Simulation::solve_islands(double ahead, Pass& pass) const {
  std::vector<std::vector<std::uint32_t>> joined = joined_by(pass.contacts);
  const auto first_element = static_cast<std::uint32_t>(joined.size());
  // Elements that have a node which moves.
  std::vector<std::uint32_t> moving_elements;
  for (std::uint32_t k = 0; k < pass.elements.size(); ++k) {
    std::vector<std::uint32_t> moving(pass.elements[k].nodes.begin(),
                                      pass.elements[k].nodes.begin() + pass.elements[k].count);
    std::erase_if(moving, [&](std::uint32_t node) { return !pass.motions[node].is_awake; });
    if (moving.empty()) continue;
    joined.push_back(std::move(moving));
    moving_elements.push_back(k);
  }
  std::vector<Island> islands = islands_of(pass.motions.size(), joined);
  std::erase_if(islands, [](const Island& island) { return island.contacts.empty(); });
  std::vector<std::vector<std::uint32_t>> elements(islands.size());
  for (std::size_t i = 0; i < islands.size(); ++i) {
    for (const std::uint32_t k : islands[i].contacts) {
      if (k >= first_element) elements[i].push_back(moving_elements[k - first_element]);
    }
    std::erase_if(islands[i].contacts, [&](std::uint32_t k) { return k >= first_element; });
  }
  pass.islands.assign(islands.size(), {});
  pass.island_of.assign(pass.contacts.size(), 0);
  for (std::uint32_t i = 0; i < islands.size(); ++i) {
    for (const std::uint32_t k : islands[i].contacts) pass.island_of[k] = i;
  }
  // Islands share nothing, and each is solved by one thread, so that bits do not depend on their number.
  std::vector<char> is_solved(islands.size());
  share_jobs(islands.size(), options_.threads, [&](std::size_t i) {
    is_solved[i] = solve_island(islands[i], elements[i], ahead, pass, pass.islands[i]) ? 1 : 0;
  });
  return std::ranges::all_of(is_solved, [](char its) { return its != 0; });
}

}  // namespace abut::response
