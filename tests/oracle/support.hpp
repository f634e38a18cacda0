// SPDX-License-Identifier: Apache-2.0
// Support functions of convex solids, and the distance of a point to one, in closed form.
//
// A direction n, the support heights of two solids along it and a point on each prove a distance without any search:
// no point pair is closer than the separation along n, and the shapes are no further apart than the points are.
#pragma once

#include "quad.hpp"
#include "solid.hpp"

namespace oracle {

// Largest n.p over the points p of a solid, in its local frame; n has any length.
[[nodiscard]] Quad support(const Solid& solid, const Vec& n);
[[nodiscard]] double support(const Solid& solid, const Point& n);

// A point that lies furthest along n, in the local frame: the middle of the face or edge whose points are all within
// `slack`, an angle, of furthest.
[[nodiscard]] Vec support_point(const Solid& solid, const Vec& n, Quad slack = 0);

// Of a point in the local frame; zero inside.
[[nodiscard]] Quad distance_to_solid(const Solid& solid, const Vec& point);

// How far b has to go along the unit direction n to leave a; negative: the separation.
[[nodiscard]] Quad overlap_along(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b, const Vec& n);

}  // namespace oracle
