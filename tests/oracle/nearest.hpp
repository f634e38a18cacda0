// SPDX-License-Identifier: Apache-2.0
// Distance of two convex solids by GJK in 113-bit floating point: support points and nothing else, so that it serves
// curved solids and hulls of thousands of points alike.
//
// Both ends of the interval prove themselves: two points of the solids are no closer than the upper end, and a slab as
// wide as the lower end parts them. A simplex that is too thin for its arithmetic only widens the interval.
// Source: Gilbert, Johnson, Keerthi, IEEE J. Robotics and Automation 4(2):193 (1988).
#pragma once

#include "quad.hpp"
#include "solid.hpp"

namespace oracle {

struct Nearest {
  bool is_known = false;  // false where the cores (solids without their radii) overlap or touch
  Quad lower = 0;         // of the signed distance, radii included
  Quad upper = 0;
  Vec normal;  // unit, from a to b
};

[[nodiscard]] Nearest nearest(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b);

}  // namespace oracle
