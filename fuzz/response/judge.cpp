// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "problem.hpp"

namespace response_fuzzing {

namespace {

using response_test::Answer;
using response_test::World;

[[nodiscard]] bool is_finite(const Answer& answer) {
  const auto all = [](const std::vector<double>& numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  };
  return all(answer.velocities) && all(answer.impulses) && std::isfinite(answer.residuals.contact) &&
         std::isfinite(answer.residuals.motion) && std::isfinite(answer.residuals.dissipation);
}

// Velocities that cancel in the law: what the residual is measured against.
[[nodiscard]] double scale_of(const World& world, const Answer& answer) {
  double scale = answer.residuals.speed;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    scale = std::max({scale, length(answer.linear(i)), length(answer.angular(i)), length(world.bodies[i].angular)});
  }
  for (std::size_t k = 0; k < world.contacts.size(); ++k) {
    const auto& contact = world.contacts[k];
    const double impulse = length(answer.impulse(k));
    scale = std::max({scale, std::fabs(contact.offset), contact.compliance * impulse,
                      (1 + contact.friction) * world.weight(contact) * impulse});
    for (const std::uint32_t side : {contact.a, contact.b}) {
      if (side == ABUT_NO_BODY) continue;
      const double arm = length(contact.point - world.bodies[side].centre);
      scale = std::max({scale, arm * length(answer.angular(side)), arm * length(world.bodies[side].angular)});
    }
  }
  return scale;
}

// Contacts that are closed, rigid or not, and at rest but for the bodies: what they do takes energy away.
[[nodiscard]] bool only_takes_energy(const World& world) {
  return std::ranges::all_of(world.contacts, [](const response_test::Contact& contact) {
    return contact.offset >= 0 && length(contact.surface) == 0;
  });
}

}  // namespace

std::string finding_of(std::span<const std::uint8_t> bytes) {
  const Problem problem = problem_of(bytes);
  const World& world = problem.world;
  const Answer answer = world.solve(&problem.options);
  const std::string status = abut_status_name(answer.status);
  if (!problem.is_valid) {
    const bool is_refused = answer.status == ABUT_NOT_FINITE || answer.status == ABUT_OUT_OF_RANGE;
    return is_refused && !std::string(abut_last_error_message()).empty() ? "" : "bad input is answered with " + status;
  }
  if (answer.status != ABUT_OK) return "good input is answered with " + status + ": " + abut_last_error_message();
  if (!is_finite(answer)) return "an answer is not finite";
  // The judge measures in another norm, and its own sums round as well.
  const double scale = scale_of(world, answer), missed = world.worst_miss(answer);
  // A normal impulse that is off by a little lets friction be off by its coefficient times as much.
  double friction = 0;
  for (const response_test::Contact& contact : world.contacts) friction = std::max(friction, contact.friction);
  const double told = (1 + friction) * (answer.residuals.contact + answer.residuals.motion);
  if (!(missed <= 100 * told + 1e-8 * scale)) {
    return "an answer misses the law by " + std::to_string(missed) + ", told are " + std::to_string(told) + " of " +
           std::to_string(scale);
  }
  double before = 0;
  for (const response_test::Body& body : world.bodies) {
    before += body.mass * dot(body.linear, body.linear);
    before += body.inertia.x * body.angular.x * body.angular.x + body.inertia.y * body.angular.y * body.angular.y +
              body.inertia.z * body.angular.z * body.angular.z;
  }
  if (answer.residuals.is_converged == 1 && only_takes_energy(world) &&
      !(world.kinetic_energy(answer) <= 0.5 * before * (1 + 1e-6))) {
    return "energy grows from " + std::to_string(0.5 * before) + " to " + std::to_string(world.kinetic_energy(answer));
  }
  return "";
}

}  // namespace response_fuzzing
