// SPDX-License-Identifier: Apache-2.0
// Parts that move through a step.
#pragma once
#include <cmath>

#include "support.hpp"

namespace abut_test {

#define ABUT_NEEDS_MOTION() \
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "this build is without the feature motion"

inline abut_geometry_options with_flags(abut_geometry_flags flags) {
  abut_geometry_options options = default_geometry_options();
  options.flags = flags;
  return options;
}

inline std::vector<abut_step_impact> impacts_of(const abut_universe* universe) {
  return copy_of(abut_universe_impacts, universe);
}

inline abut_vec3 sum(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline abut_vec3 times(double s, const abut_vec3& v) { return {s * v.x, s * v.y, s * v.z}; }
inline double length(const abut_vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

inline abut_quat product(const abut_quat& a, const abut_quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

inline abut_quat turned_by(const abut_vec3& turn) {
  const double angle = length(turn), share = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
  return {std::cos(angle / 2), share * turn.x, share * turn.y, share * turn.z};
}

// Where a part is after a time, by the definition of its way alone.
struct Moving {
  abut_pose start = identity;
  abut_velocity velocity{{0, 0, 0}, {0, 0, 0}};
  abut_acceleration acceleration{{0, 0, 0}, {0, 0, 0}};

  abut_pose at(double t) const {
    const abut_vec3 way = sum(times(t, velocity.linear), times(t * t / 2, acceleration.linear));
    const abut_vec3 turn = sum(times(t, velocity.angular), times(t * t / 2, acceleration.angular));
    return {sum(start.position, way), product(turned_by(turn), start.orientation)};
  }
};

inline abut_part_id add_moving(Universe& universe, const abut_shape* shape, const Moving& moving,
                               abut_geometry_flags flags, abut_motion motion = ABUT_MOTION_DYNAMIC) {
  const abut_part_id part = universe.add_part(moving.start, motion);
  universe.add_geometry(part, shape, with_flags(flags));
  require(abut_part_set_velocity(universe, part, &moving.velocity));
  require(abut_part_set_acceleration(universe, part, &moving.acceleration));
  return part;
}

}  // namespace abut_test
