// SPDX-License-Identifier: Apache-2.0
// Invariants of one contact.
#include <algorithm>
#include <cmath>

#include "judge.hpp"

namespace universe_calls {
namespace {

double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
abut_vec3 minus(const abut_vec3& a, const abut_vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// v + 2 w (u x v) + 2 u x (u x v), with u the vector part.
abut_vec3 rotated(const abut_quat& q, const abut_vec3& v) {
  const abut_vec3 u{q.x, q.y, q.z}, t = cross(u, v), tt = cross(u, t);
  return {v.x + 2 * (q.w * t.x + tt.x), v.y + 2 * (q.w * t.y + tt.y), v.z + 2 * (q.w * t.z + tt.z)};
}

abut_vec3 into(const abut_pose& pose, const abut_vec3& point) {
  const abut_quat& q = pose.orientation;
  return rotated({q.w, -q.x, -q.y, -q.z}, minus(point, pose.position));
}

// Coordinates of the sequences stay below 32; a thousand roundings at that
// size.
constexpr double tolerance = 1e-11;

// How far a point is from the surface of a box; the other shapes are left to
// the differential checks.
void judge_point(const World& world, const Geometry& geometry, const abut_vec3& point, const char* name) {
  if (!geometry.shape.is_box) {
    return;
  }
  const abut_vec3 local = into(geometry.local.pose, into(world.parts.at(geometry.part).placed.pose, point));
  const Triple& half = geometry.shape.half;
  const double outside =
      std::max({std::fabs(local.x) - half[0], std::fabs(local.y) - half[1], std::fabs(local.z) - half[2]});
  require(std::fabs(outside) <= tolerance, std::string(name) + " is " + std::to_string(outside) + " off its box");
}

}  // namespace

void judge_contact(const abut_contact& contact) {
  require(std::fabs(dot(contact.normal, contact.normal) - 1) <= 1e-12, "a normal is not of length one");
  const double along = dot(minus(contact.point_b, contact.point_a), contact.normal);
  require(std::fabs(along - contact.distance) <= tolerance, "a distance is not that of the points along the normal");
  require(contact.toi == 0, "a discrete contact has a time");
}

void judge_points(const World& world, const Geometry& a, const Geometry& b, const abut_contact& contact) {
  const abut_policy& policy = world.policy_of(a, b);
  const double reach = policy.tolerance < 0 ? a.options.tolerance + b.options.tolerance : policy.tolerance;
  const double limit = world.mode == ABUT_TOLERANCE_MARGIN ? reach : -reach;
  require(reach == 0 ? contact.distance <= 0 : contact.distance < limit,
          "a contact is reported that the tolerance rules out");
  judge_point(world, a, contact.point_a, "point_a");
  judge_point(world, b, contact.point_b, "point_b");
  const auto flags = (a.options.flags | b.options.flags) & ABUT_GEOMETRY_SENSOR;
  require(contact.flags == (flags != 0 ? std::uint32_t{ABUT_CONTACT_SENSOR} : 0),
          "the sensor flag of a contact is wrong");
  require(contact.material_a == a.options.material && contact.material_b == b.options.material,
          "a contact has other materials");
}

}  // namespace universe_calls
