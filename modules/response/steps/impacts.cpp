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
  out.reserve(motions.size());
  for (const Motion& its : motions) {
    out.push_back({its.linear.x, its.linear.y, its.linear.z, its.angular.x, its.angular.y, its.angular.z});
  }
  return out;
}

// Takes those out that part: they would be stopped at the end of their flight.
[[nodiscard]] std::vector<StepContact> taken_apart(Pass& pass, const std::vector<Row>& velocities) {
  std::vector<StepContact> parted;
  std::erase_if(pass.contacts, [&](const StepContact& contact) {
    const bool may_part = contact.link == 0 && contact.is_solved;
    const bool parts = may_part && parting_speed(contact, velocities) > part_of_slow * contact.slow;
    if (parts) parted.push_back(contact);
    return parts;
  });
  return parted;
}

// A pair that has just touched is followed again when it is apart. So a path ends where the first pair is furthest
// apart.
[[nodiscard]] double flight_of(const std::vector<StepContact>& parted, const std::vector<Row>& before,
                               const std::vector<Row>& after, double rest) {
  double time = rest;
  for (const StepContact& contact : parted) {
    const double speed = parting_speed(contact, before), closing = (speed - parting_speed(contact, after)) / rest;
    if (closing > 0) time = std::min(time, speed / closing);
  }
  return time;
}

}  // namespace

// Newton's law for all rigid contacts of an island at once: who approaches at u leaves at restitution times u. Forces
// have no time to act. False where a velocity is not finite.
bool Simulation::bounce(Pass& pass) {
  const std::vector<Row> velocities = velocities_of(pass.motions);
  Pass impact{.motions = pass.motions, .contacts = {}, .islands = {}, .island_of = {}, .bonds = {}};
  bool is_any = false;
  for (StepContact contact : pass.contacts) {
    if (contact.compliance > 0 || !contact.is_solved) continue;
    contact.given = 0;
    if (contact.link != 0) {
      // What holds with any force holds in an impact.
      if (std::isfinite(contact.rows.most)) continue;
      for (std::size_t i = 0; i < contact.opened.size(); ++i) contact.rows.drift[i] -= contact.opened[i];
      contact.impulse = {};
      impact.contacts.push_back(contact);
      continue;
    }
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
  tell(impact, 1);
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

// The rest of a step without impacts: paths through what is left of it are straight.
abut_status Simulation::end_at_once(double rest) {
  Pass pass;
  if (const abut_status status = look(rest, pass); status != ABUT_OK) return status;
  if (!bounce(pass)) return ABUT_NOT_CONVERGED;
  if (const abut_status status = add_forces(rest, pass); status != ABUT_OK) return status;
  if (!solve_islands(rest, pass)) return ABUT_NOT_CONVERGED;
  tell(pass, 1);
  keep(rest, pass);
  return write(rest, pass);
}

// One path, from the present to the first impact or to the end of the step. What is left of it after.
abut_status Simulation::follow(double& rest) {
  Pass pass;
  if (const abut_status status = look(rest, pass); status != ABUT_OK) return status;
  std::erase_if(pass.contacts, [](const StepContact& contact) { return contact.record.toi > 0; });
  if (!bounce(pass)) return ABUT_NOT_CONVERGED;
  const std::vector<Row> before = velocities_of(pass.motions);
  const std::vector<StepContact> parted = taken_apart(pass, before);
  if (const abut_status status = add_forces(rest, pass); status != ABUT_OK) return status;
  if (!solve_islands(0, pass)) return ABUT_NOT_CONVERGED;
  keep(rest, pass);
  const double time = flight_of(parted, before, velocities_of(pass.motions), rest);
  double passed = 0;
  bool is_impact = false;
  if (const abut_status status = advance(time, rest, pass, passed, is_impact); status != ABUT_OK) return status;
  // Impulses act evenly through the rest of the step, which the impact has cut short.
  tell(pass, passed / rest);
  const bool is_over = !is_impact && time == rest;
  rest = is_over ? 0 : rest - passed;
  return ABUT_OK;
}

abut_status Simulation::step_by_impacts(double dt) {
  constexpr int most_impacts = 64;
  contacts_.clear();
  islands_.clear();
  double rest = dt;
  for (int i = 0; i < most_impacts && rest > 0; ++i) {
    if (const abut_status status = follow(rest); status != ABUT_OK) return status;
  }
  if (rest > 0) {
    if (const abut_status status = end_at_once(rest); status != ABUT_OK) return status;
  }
  finish(dt);
  std::vector<abut_part_id> parts(bodies_.size());
  std::ranges::transform(bodies_, parts.begin(), [](const Body& body) { return body.part; });
  return source_->stop_accelerating(parts);
}

}  // namespace abut::response
