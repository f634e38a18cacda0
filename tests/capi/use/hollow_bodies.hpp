// SPDX-License-Identifier: Apache-2.0
// Bodies with cavities, for tests of holes.
#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "support.hpp"

namespace abut_test {

inline double deepest(const std::vector<abut_contact>& contacts) {
  double least = std::numeric_limits<double>::infinity();
  for (const abut_contact& contact : contacts) least = std::min(least, contact.distance);
  return least;
}

// A block of half size 2 with a cavity of about half size 1 in it.
inline Shape hollow(const abut_shape* hole, const abut_pose& pose = identity) {
  const Shape block = make_box(2, 2, 2);
  return make_composite({block, hole}, {identity, pose});
}
inline Shape sphere_hole(double radius) { return make_of_kind("sphere_hole", {radius}); }
inline Shape cylinder_hole(double radius, double half_height, double open) {
  return make_of_kind("cylinder_hole", {radius, half_height, open});
}
inline Shape box_hole(double x, double y, double z, double open) { return make_of_kind("box_hole", {x, y, z, open}); }

}  // namespace abut_test
