// SPDX-License-Identifier: Apache-2.0
// A step from impact to impact: bodies follow their paths until the first two touch, and bounce there.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// Surfaces that leave each other faster than by this part of the slowest approach that bounces have parted.
constexpr double part_of_slow = 0.1;

// The velocity of a contact without what its gap adds.
[[nodiscard]] double parting_speed(const StepContact& contact, const std::vector<Row>& velocities) {
  return relative_velocity(contact.rows, velocities)[2] - contact.rows.offset;
}

[[nodiscard]] abut_vec3 between(const abut_vec3& start, const abut_vec3& end, double part) {
  return add(start, scale(subtract(end, start), part));
}

[[nodiscard]] std::vector<Row> velocities_of(const std::vector<Motion>& motions) {
  std::vector<Row> out;
  for (const Motion& its : motions) {
    out.push_back({its.linear.x, its.linear.y, its.linear.z, its.angular.x, its.angular.y, its.angular.z});
  }
  return out;
}

}  // namespace

// Newton's law for all rigid contacts of an island at once: who approaches at u leaves at restitution times u. Forces
// have no time to act. False where a velocity is not finite.
bool Simulation::bounce(Pass& pass) {
  const std::vector<Row> velocities = velocities_of(pass.motions);
  Pass impact{.motions = pass.motions, .contacts = {}, .islands = {}, .island_of = {}};
  bool is_any = false;
  for (StepContact contact : pass.contacts) {
    if (contact.rows.compliance > 0) continue;
    const double speed = parting_speed(contact, velocities);
    is_any = is_any || speed < -part_of_slow * contact.slow;
    contact.rows.drift[2] -= contact.rows.offset;
    contact.rows.offset = speed < -contact.slow ? contact.restitution * speed : 0;
    contact.rows.drift[2] += contact.rows.offset;
    contact.impulse = {};
    impact.contacts.push_back(contact);
  }
  if (!is_any) return true;
  if (!solve_islands(0, impact)) return false;
  for (std::size_t i = 0; i < pass.motions.size(); ++i) {
    Motion& its = pass.motions[i];
    its.linear = its.linear_before = impact.motions[i].linear;
    its.angular = its.angular_before = impact.motions[i].angular;
  }
  tell(impact);
  return true;
}

// Moves all bodies along their paths through `time`, which is at most `rest`, or up to the first impact. Velocities
// change evenly. Who is pushed by contacts moves by the velocity at the end all the time, so that contacts do no work
// on it.
abut_status Simulation::advance(double time, double rest, const Pass& pass, double& passed, bool& is_impact) {
  std::vector<abut_part_id> parts;
  std::vector<abut_velocity> velocities;
  std::vector<abut_acceleration> accelerations;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Motion& its = pass.motions[i];
    if (!its.is_awake) continue;
    const abut_vec3 linear = its.is_pushed ? its.linear : its.linear_before;
    const abut_vec3 angular = its.is_pushed ? its.angular : its.angular_before;
    const abut_vec3 gain = scale(subtract(its.linear, linear), 1 / rest);
    // Of a turn that keeps its momentum, and by torque.
    const abut_vec3 faster = add(accelerated(its.inertia, cross(times(its.inertia, angular), angular)),
                                 scale(subtract(its.angular, angular), 1 / rest));
    // The origin of the part circles around the centre of mass.
    const abut_vec3 arm = times(matrix_of(its.orientation), bodies_[i].mass.centre), around = cross(angular, arm);
    parts.push_back(bodies_[i].part);
    velocities.push_back({.linear = subtract(linear, around), .angular = angular});
    accelerations.push_back(
        {.linear = subtract(gain, add(cross(angular, around), cross(faster, arm))), .angular = faster});
  }
  double fraction = 1;
  const abut_status status = source_->advance(parts, velocities, accelerations, time, fraction, is_impact);
  if (status != ABUT_OK) return status;
  passed = fraction * time;
  // The world goes by turns that speed up evenly, which is right to the third order. Bodies turn as they do.
  std::vector<abut_pose> poses;
  velocities.clear();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Motion& its = pass.motions[i];
    if (!its.is_awake) continue;
    const abut_vec3 linear = between(its.linear_before, its.linear, passed / rest);
    const abut_vec3 angular = between(its.angular_before, its.angular, passed / rest);
    const abut_vec3 mean = its.is_pushed ? its.linear : between(its.linear_before, linear, 0.5);
    const abut_vec3 turn = its.is_pushed ? its.angular : angular;
    const Matrix& inertia = bodies_[i].mass.inertia;
    const Turning turned = turned_freely(inertia, {its.orientation, turn}, passed);
    const abut_quat orientation = normalized(product(cayley(scale(its.tilt, 0.5)), turned.orientation));
    // Angular momentum stays where nothing pushes.
    const abut_vec3 spin = its.is_pushed
                               ? accelerated(world_inertia(inertia, turned.orientation), times(its.inertia, angular))
                               : turned.angular;
    const abut_vec3 centre = add(add(its.centre, scale(mean, passed)), its.shift);
    const abut_vec3 arm = times(matrix_of(orientation), bodies_[i].mass.centre);
    poses.push_back({.position = subtract(centre, arm), .orientation = orientation});
    velocities.push_back({.linear = subtract(linear, cross(spin, arm)), .angular = spin});
  }
  return source_->move(parts, poses, velocities);
}

abut_status Simulation::step_by_impacts(double dt) {
  // With more impacts than these in a step, bodies go the rest of it without.
  constexpr int most_impacts = 64;
  contacts_.clear();
  islands_.clear();
  double rest = dt;
  for (int impacts = 0;; ++impacts) {
    Pass pass;
    if (const abut_status status = look(rest, pass); status != ABUT_OK) return status;
    const bool is_last = impacts == most_impacts;
    if (!is_last) {
      std::erase_if(pass.contacts, [](const StepContact& contact) { return contact.record.toi > 0; });
    }
    if (!bounce(pass)) return ABUT_NOT_CONVERGED;
    // Who parts is left alone, or it would be stopped at the end of its flight.
    std::vector<StepContact> parted;
    const std::vector<Row> before = velocities_of(pass.motions);
    std::erase_if(pass.contacts, [&](const StepContact& contact) {
      const bool parts = !is_last && parting_speed(contact, before) > part_of_slow * contact.slow;
      if (parts) parted.push_back(contact);
      return parts;
    });
    add_forces(rest, pass);
    if (!solve_islands(is_last ? rest : 0, pass)) return ABUT_NOT_CONVERGED;
    tell(pass);
    keep(rest, pass);
    if (is_last) {
      if (const abut_status status = write(rest, pass); status != ABUT_OK) return status;
      break;
    }
    // A pair that has just touched is followed again when it is apart. So a path ends where the pair is furthest apart.
    double time = rest;
    const std::vector<Row> after = velocities_of(pass.motions);
    for (const StepContact& contact : parted) {
      const double speed = parting_speed(contact, before), closing = (speed - parting_speed(contact, after)) / rest;
      if (closing > 0) time = std::min(time, speed / closing);
    }
    double passed = 0;
    bool is_impact = false;
    if (const abut_status status = advance(time, rest, pass, passed, is_impact); status != ABUT_OK) return status;
    if (!is_impact && time == rest) break;
    rest -= passed;
    if (!(rest > 0)) break;
  }
  finish(dt);
  std::vector<abut_part_id> parts;
  for (const Body& body : bodies_) parts.push_back(body.part);
  return source_->stop_accelerating(parts);
}

}  // namespace abut::response
