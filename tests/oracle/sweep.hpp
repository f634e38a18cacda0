// SPDX-License-Identifier: Apache-2.0
// The least overlap of two solids over all directions, searched for without any knowledge of the pair.
//
// Every direction gives an upper bound of the depth, so the result is one whatever the search misses; how tight it is
// depends on the search. It looks at the directions where the minimum can be a kink: normals of faces, cross products
// of edges. It looks along the circles where the overlap has a kink: across an edge, the slope of a cone. And it looks
// all over the sphere, evenly, and evenly for a body of the same proportions. The best of these are refined.
#pragma once

#include "solid.hpp"
#include "quad.hpp"

namespace oracle {

struct LeastOverlap {
  Quad overlap = 0;
  Vec direction;  // unit, from a to b
};

// `hint` is one more direction to start from; it need not be good.
[[nodiscard]] LeastOverlap least_overlap(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b,
                                         const Vec& hint);

}  // namespace oracle
