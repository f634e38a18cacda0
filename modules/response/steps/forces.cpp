// SPDX-License-Identifier: Apache-2.0
// Velocities without contacts, by the integrator of each group, and what springs of contacts do in a step.
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

Yield yield_of(const StepContact& contact, double dt) {
  const double gap = contact.record.distance;
  if (contact.compliance == 0) return {.compliance = 0, .offset = std::max(gap, 0.0) / dt};
  const double stiffness = 1 / contact.compliance, whole = dt * stiffness + contact.damping;
  return {.compliance = 1 / (dt * whole), .offset = stiffness * gap / whole};
}

namespace {

// The same with gap and velocity at the middle of the step: f = -k (g + dt (u0 + u1) / 4) - d (u0 + u1) / 2.
[[nodiscard]] Yield midpoint_yield_of(const StepContact& contact, double speed, double dt) {
  const double stiffness = 1 / contact.compliance, whole = dt * stiffness / 2 + contact.damping;
  const double compliance = 2 / (dt * whole);
  return {.compliance = compliance, .offset = speed + compliance * dt * stiffness * contact.record.distance};
}

// The impulse of a spring whose force is that at the start of the step.
[[nodiscard]] double explicit_impulse_of(const StepContact& contact, double speed, double dt) {
  return std::max(0.0, -dt * (contact.record.distance / contact.compliance + contact.damping * speed));
}

void change(Motion& its, const Row& impulse) {
  const Row gain = velocity_of_impulse({.mass = its.mass, .inertia = its.inertia}, impulse);
  its.linear = add(its.linear, vector_of(gain, 0));
  its.angular = add(its.angular, vector_of(gain, 3));
}

// The impulse along the normal that no solver looks for.
void give(const StepContact& contact, std::vector<Motion>& motions) {
  for (const BodyRows& its : contact.rows.bodies) {
    Row impulse = its.rows[2];
    for (double& number : impulse) number *= contact.given;
    change(motions[its.body], impulse);
  }
}

}  // namespace

// All bodies that touch or are linked go by the greatest integrator among them.
void Simulation::choose_integrators(Pass& pass) const {
  const std::vector<Island> groups = islands_of(pass.motions.size(), joined_by(pass.contacts));
  for (const Island& group : groups) {
    abut_integrator greatest = ABUT_INTEGRATOR_STATIC;
    for (const std::uint32_t body : group.bodies) greatest = std::max(greatest, pass.motions[body].integrator);
    for (const std::uint32_t body : group.bodies) pass.motions[body].integrator = greatest;
  }
}

abut_status Simulation::push_at(const Body& body, const Motion& its, double time, Push& out) const {
  abut_vec3 force = body.force, torque = body.torque;
  if (field_) {
    const abut_status status = field_(body.part, {.position = its.centre, .orientation = its.orientation},
                                      {.linear = its.linear, .angular = its.angular}, time, force, torque);
    if (status != ABUT_OK) return status;
  }
  out.linear = add(options_.gravity, scale(force, 1 / its.mass));
  out.angular = accelerated(its.inertia, torque);
  return ABUT_OK;
}

namespace {

// A part of a step without forces of contacts, from a state and by velocities and accelerations that may be others.
[[nodiscard]] Motion moved(const Motion& start, const Matrix& inertia, const abut_vec3& linear, const abut_vec3& gain,
                           const abut_vec3& angular_gain, double time) {
  Motion out = start;
  out.centre = add(start.centre, scale(linear, time));
  out.linear = add(start.linear, scale(gain, time));
  const Turning turned = turned_freely(inertia, {start.orientation, start.angular}, time);
  out.orientation = turned.orientation;
  out.inertia = world_inertia(inertia, out.orientation);
  out.angular = add(turned.angular, scale(angular_gain, time));
  return out;
}

}  // namespace

// Turns without torque keep angular momentum, and come when bodies move.
abut_status Simulation::accelerate(const Body& body, double dt, Motion& its) const {
  Push first;
  if (const abut_status status = push_at(body, its, time_, first); status != ABUT_OK) return status;
  Push mean = first;
  its.bend = {};
  if (field_ && its.integrator == ABUT_INTEGRATOR_MIDPOINT) {
    const Motion middle = moved(its, body.mass.inertia, its.linear, first.linear, first.angular, dt / 2);
    if (const abut_status status = push_at(body, middle, time_ + dt / 2, mean); status != ABUT_OK) return status;
  }
  if (field_ && its.integrator == ABUT_INTEGRATOR_RK4) {
    Push second, third, fourth;
    const Matrix& inertia = body.mass.inertia;
    const Motion at_second = moved(its, inertia, its.linear, first.linear, first.angular, dt / 2);
    abut_status status = push_at(body, at_second, time_ + dt / 2, second);
    if (status != ABUT_OK) return status;
    const Motion at_third = moved(its, inertia, at_second.linear, second.linear, second.angular, dt / 2);
    status = push_at(body, at_third, time_ + dt / 2, third);
    if (status != ABUT_OK) return status;
    const Motion at_fourth = moved(its, inertia, at_third.linear, third.linear, third.angular, dt);
    status = push_at(body, at_fourth, time_ + dt, fourth);
    if (status != ABUT_OK) return status;
    const auto mean_of = [](const abut_vec3& a, const abut_vec3& b, const abut_vec3& c, const abut_vec3& d) {
      return scale(add(add(a, d), scale(add(b, c), 2)), 1.0 / 6);
    };
    mean = {.linear = mean_of(first.linear, second.linear, third.linear, fourth.linear),
            .angular = mean_of(first.angular, second.angular, third.angular, fourth.angular)};
    // The path is v0 dt + (a1 + a2 + a3) dt^2 / 6; half of the mean acceleration is what the ends give.
    const abut_vec3 along = scale(add(add(first.linear, second.linear), third.linear), 1.0 / 6);
    its.bend = scale(subtract(along, scale(mean.linear, 0.5)), dt);
  }
  // By the new velocity, as far as the field goes: symplectic, so that its springs keep their energy on average.
  if (field_ && its.integrator == ABUT_INTEGRATOR_IMPLICIT) {
    const abut_vec3 constant = add(options_.gravity, scale(body.force, 1 / its.mass));
    its.bend = scale(subtract(first.linear, constant), dt / 2);
  }
  its.linear = add(its.linear, scale(mean.linear, dt));
  its.angular = add(its.angular, scale(mean.angular, dt));
  return ABUT_OK;
}

abut_status Simulation::add_forces(double dt, Pass& pass) const {
  choose_integrators(pass);
  std::vector<Row> before(pass.motions.size());
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = row_of(pass.motions[i].linear, pass.motions[i].angular);
  for (StepContact& contact : pass.contacts) {
    if (contact.link != 0 || contact.response == Response::custom || !contact.is_solved) continue;
    const Motion& its = pass.motions[contact.rows.bodies.front().body];
    const double speed = relative_velocity(contact.rows, before)[2];
    Yield yield = yield_of(contact, dt);
    if (contact.compliance > 0 && its.integrator < ABUT_INTEGRATOR_MIDPOINT) {
      contact.given += explicit_impulse_of(contact, speed, dt);
      contact.is_solved = false;
      continue;
    }
    // From outside, the middle of the step would be reached with energy that no spring has stored.
    contact.is_middle =
        contact.compliance > 0 && its.integrator == ABUT_INTEGRATOR_MIDPOINT && contact.record.distance <= 0;
    if (contact.is_middle) yield = midpoint_yield_of(contact, speed, dt);
    contact.rows.compliance = yield.compliance;
    contact.rows.offset = yield.offset;
    contact.rows.drift[2] += yield.offset;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Motion& its = pass.motions[i];
    if (!its.is_awake) continue;
    if (const abut_status status = accelerate(bodies_[i], dt, its); status != ABUT_OK) return status;
  }
  for (std::size_t i = bodies_.size(); i < pass.motions.size(); ++i) {
    Motion& its = pass.motions[i];
    if (its.is_awake) its.linear = add(its.linear, scale(options_.gravity, dt));
  }
  for (const StepContact& contact : pass.contacts) {
    if (contact.given != 0) give(contact, pass.motions);
  }
  return ABUT_OK;
}

}  // namespace abut::response
