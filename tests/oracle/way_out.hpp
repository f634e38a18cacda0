// SPDX-License-Identifier: Apache-2.0
// The shortest move of one shape of parts that parts it from another, searched for in double and proven in 113 bits.
//
// Along a direction two convex parts overlap for one stretch of the way. Planes bound it: across the normals of faces
// and the products of edges, and with a radius across some more. So each stretch is found in closed form, and is exact
// for polytopes. The way out along the direction ends where no stretch goes on. It leads through no front of a triangle
// that stops from its front alone.
#pragma once

#include <functional>
#include <span>

#include "meeting.hpp"
#include "quad.hpp"

namespace oracle {

struct WayOut {
  bool is_known = false;  // false where no direction leads out
  Quad depth = 0;
  Vec direction;  // unit
};

// Whether b, moved so far, lies inside of a although no two parts overlap.
using Holds = std::function<bool(const Vec& move)>;

// Of b. `hints`: directions to try; they need not be good. Whatever the search misses, after the move that is returned
// no two parts overlap in 113 bits. `holds` tells of a solid that b may be inside of.
[[nodiscard]] WayOut shortest_way_out(const Side& a, const Side& b, const Meeting& meeting, std::span<const Vec> hints,
                                      const Holds& holds = {});

}  // namespace oracle
