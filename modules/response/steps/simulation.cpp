// SPDX-License-Identifier: Apache-2.0
// Bodies, and the order of a step: contacts, forces, impulses of each island, motion.
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

namespace {

[[nodiscard]] auto key_of(const abut_part_id& part) { return std::tuple(part.slot, part.generation); }

}  // namespace

Matrix world_inertia(const Matrix& inertia, const abut_quat& orientation) {
  const Matrix turn = matrix_of(orientation);
  Matrix out = product(product(turn, inertia), transposed(turn));
  for (const auto& [i, j] : {std::pair(1U, 3U), std::pair(2U, 6U), std::pair(5U, 7U)}) out[i] = out[j];
  return out;
}

abut_vec3 accelerated(const Matrix& inertia, const abut_vec3& torque) {
  return vector_of(velocity_of_impulse({.mass = 1, .inertia = inertia}, row_of({}, torque)), 3);
}

Body* Simulation::find(abut_part_id part) {
  const auto place =
      std::ranges::lower_bound(bodies_, key_of(part), {}, [](const Body& body) { return key_of(body.part); });
  return place != bodies_.end() && key_of(place->part) == key_of(part) ? &*place : nullptr;
}
const Body* Simulation::find(abut_part_id part) const {
  const auto place =
      std::ranges::lower_bound(bodies_, key_of(part), {}, [](const Body& body) { return key_of(body.part); });
  return place != bodies_.end() && key_of(place->part) == key_of(part) ? &*place : nullptr;
}

void Simulation::add_body(abut_part_id part, const MassProperties& mass, abut_integrator integrator) {
  if (Body* const body = find(part); body != nullptr) {
    body->mass = mass;
    body->integrator = integrator;
    return;
  }
  const auto place =
      std::ranges::lower_bound(bodies_, key_of(part), {}, [](const Body& body) { return key_of(body.part); });
  bodies_.insert(place, Body{.part = part, .mass = mass, .integrator = integrator});
}

bool Simulation::remove_body(abut_part_id part) {
  return std::erase_if(bodies_, [&](const Body& body) { return key_of(body.part) == key_of(part); }) > 0;
}

std::optional<MassProperties> Simulation::mass_of(abut_part_id part) const {
  const Body* const body = find(part);
  return body == nullptr ? std::nullopt : std::optional(body->mass);
}

abut_status Simulation::push(abut_part_id part, const abut_vec3& force, const std::optional<abut_vec3>& at) {
  Body& body = *find(part);
  Motion motion;
  if (const abut_status status = read(body, motion); status != ABUT_OK) return status;
  body.force = add(body.force, force);
  if (at) body.torque = add(body.torque, cross(subtract(*at, motion.centre), force));
  return ABUT_OK;
}

void Simulation::twist(abut_part_id part, const abut_vec3& torque) {
  Body& body = *find(part);
  body.torque = add(body.torque, torque);
}

// Where a body is and how it moves now.
abut_status Simulation::read(const Body& body, Motion& out) const {
  abut_pose pose;
  abut_velocity velocity;
  if (const abut_status status = source_->pose(body.part, pose); status != ABUT_OK) return status;
  if (const abut_status status = source_->velocity(body.part, velocity); status != ABUT_OK) return status;
  const abut_vec3 arm = times(matrix_of(normalized(pose.orientation)), body.mass.centre);
  out.orientation = normalized(pose.orientation);
  out.centre = add(pose.position, arm);
  out.linear = out.linear_before = add(velocity.linear, cross(velocity.angular, arm));
  out.angular = out.angular_before = velocity.angular;
  out.mass = body.mass.mass;
  out.inertia = world_inertia(body.mass.inertia, out.orientation);
  if (const abut_status status = source_->is_awake(body.part, out.is_awake); status != ABUT_OK) return status;
  out.is_awake = out.is_awake && body.integrator != ABUT_INTEGRATOR_STATIC;
  out.integrator = body.integrator;
  return ABUT_OK;
}

// Bodies move, and the world is told.
abut_status Simulation::write(double dt, const Pass& pass) {
  std::vector<abut_part_id> parts;
  std::vector<abut_pose> poses;
  std::vector<abut_velocity> velocities;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    const Motion& its = pass.motions[i];
    if (!its.is_awake) continue;
    // Constant forces are exact by the mean velocity. Where contacts push, the velocity at the end is the one that they
    // allow.
    const bool takes_end = its.is_pushed || its.integrator == ABUT_INTEGRATOR_EULER;
    const abut_vec3 free = add(scale(add(its.linear_before, its.linear), 0.5), its.bend);
    const abut_vec3 mean = takes_end ? its.linear : free;
    const Turning turned = turned_freely(body.mass.inertia, {its.orientation, its.angular}, dt);
    const abut_quat orientation = normalized(product(cayley(scale(its.tilt, 0.5)), turned.orientation));
    const abut_vec3 centre = add(add(its.centre, scale(mean, dt)), its.shift);
    const abut_vec3 arm = times(matrix_of(orientation), body.mass.centre);
    parts.push_back(body.part);
    poses.push_back({.position = subtract(centre, arm), .orientation = orientation});
    velocities.push_back({.linear = subtract(its.linear, cross(turned.angular, arm)), .angular = turned.angular});
  }
  if (const abut_status status = source_->move(parts, poses, velocities); status != ABUT_OK) return status;
  return write_particles(dt, pass);
}

abut_status Simulation::step(double dt) {
  std::erase_if(bodies_, [&](const Body& body) { return !source_->has(body.part); });
  std::erase_if(grains_, [&](const Grains& its) { return !source_->has(its.geometry); });
  std::erase_if(surfaces_,
                [&](const Surface& its) { return !source_->has(its.geometry) || !source_->has(its.carrier); });
  const auto has_ended = [&](const Anchor& anchor) { return anchor.part.slot != 0 && !source_->has(anchor.part); };
  std::erase_if(links_, [&](const Link& link) { return has_ended(link.a) || has_ended(link.b); });
  return (options_.flags & ABUT_RESPONSE_IMPACTS) != 0 ? step_by_impacts(dt) : step_at_once(dt);
}

abut_status Simulation::step_at_once(double dt) {
  Pass pass;
  if (const abut_status status = look(dt, pass); status != ABUT_OK) return status;
  if (const abut_status status = add_forces(dt, pass); status != ABUT_OK) return status;
  if (!solve_islands(dt, pass)) return ABUT_NOT_CONVERGED;
  contacts_.clear();
  islands_.clear();
  tell(pass, 1);
  keep(dt, pass);
  // Last, because all before may fail for want of memory.
  if (const abut_status status = write(dt, pass); status != ABUT_OK) return status;
  finish(dt);
  return ABUT_OK;
}

namespace {

[[nodiscard]] double elastic_energy(const Grains& particles) {
  const auto place = [&](std::uint32_t node) {
    const std::size_t first = 3 * std::size_t{node};
    return abut_vec3{particles.xyz[first], particles.xyz[first + 1], particles.xyz[first + 2]};
  };
  double sum = 0;
  for (const Spring& its : particles.springs) sum += force_of(its, {place(its.a), place(its.b)}).energy;
  for (const Tetrahedron& its : particles.tetrahedra) {
    const auto& [a, b, c, d] = its.nodes;
    sum += force_of(its, {place(a), place(b), place(c), place(d)}).energy;
  }
  return sum;
}

}  // namespace

abut_status Simulation::energy(abut_energy& out) const {
  abut_energy sum{};
  for (const Body& body : bodies_) {
    if (!source_->has(body.part)) continue;
    Motion its;
    if (const abut_status status = read(body, its); status != ABUT_OK) return status;
    const double mass = body.mass.mass;
    const abut_vec3 momentum = scale(its.linear, mass);
    const abut_vec3 spin = times(world_inertia(body.mass.inertia, its.orientation), its.angular);
    sum.kinetic += 0.5 * (dot(its.linear, momentum) + dot(its.angular, spin));
    sum.potential -= mass * dot(options_.gravity, its.centre);
    sum.linear_momentum = add(sum.linear_momentum, momentum);
    sum.angular_momentum = add(sum.angular_momentum, add(cross(its.centre, momentum), spin));
  }
  for (const Grains& particles : grains_) {
    for (std::size_t i = 0; i < particles.masses.size(); ++i) {
      const double mass = particles.masses[i];
      const std::size_t first = 3 * i;
      const abut_vec3 place{particles.xyz[first], particles.xyz[first + 1], particles.xyz[first + 2]};
      const abut_vec3 linear{particles.velocities[first], particles.velocities[first + 1],
                             particles.velocities[first + 2]};
      sum.kinetic += 0.5 * mass * dot(linear, linear);
      sum.potential -= mass * dot(options_.gravity, place);
      sum.linear_momentum = add(sum.linear_momentum, scale(linear, mass));
      sum.angular_momentum = add(sum.angular_momentum, scale(cross(place, linear), mass));
    }
    sum.potential += elastic_energy(particles);
  }
  out = sum;
  return ABUT_OK;
}

}  // namespace abut::response
