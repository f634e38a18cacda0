// SPDX-License-Identifier: Apache-2.0
// A surface, part by part, against a convex shape or another surface: whether they meet, how far they are apart, and
// how deep each two parts are in each other.
//
// Bounds of the depth of two shapes made of parts. Their depth is the length of the shortest move that ends the
// overlap.
// - From below: a move that parts the shapes parts each two of their parts. So the depth of two parts, each taken as
//   convex, is a lower bound. Where a triangle stops from its front alone, a move through its front is no way out. Then
//   the depth counts where the least way out leads to the front: no other way out is shorter.
// - From above: any move after which no two parts overlap is a way out (way_out.hpp).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "body.hpp"
#include "features.hpp"
#include "quad.hpp"
#include "separation.hpp"

namespace oracle {

// A convex part in the world, relative to a common origin.
struct Part {
  Features hull;
  Vec normal;           // of a triangle: unit, or zero without area
  Point low{}, high{};  // a box around it, in double, grown by rounding
};

// A shape in parts.
struct Side {
  std::vector<Part> parts;
  Quad radius = 0;
  bool is_surface = false;
  bool is_one_sided = false;
  Quad size = 0;  // the farthest point from the origin, radius included
};

[[nodiscard]] Side side_of(const Soup& soup, bool is_one_sided, const Pose& pose, const Vec& origin);
[[nodiscard]] Side side_of(const Body& body, const Pose& pose, const Vec& origin);

// Two parts that are near each other, or overlap.
struct PartsMet {
  std::size_t a = 0, b = 0;
  Quad distance = 0;       // radii included
  Vec normal;              // from a to b, along the least way out
  bool is_allowed = true;  // false where that leads through the back of a triangle with one side
};

struct Meeting {
  Quad distance = 0;  // of the nearest or deepest two parts; radii included
  Vec normal;         // from a to b, unit, of these
  std::vector<PartsMet> met;
};

// `reach`: parts that are no further apart are met.
[[nodiscard]] Meeting meeting_of(const Side& a, const Side& b, double reach = 0);

// No way out is shorter; zero where nothing that counts is known to overlap.
[[nodiscard]] Quad least_depth(const Meeting& meeting);

// Whether a solid that a surface encloses holds a point.
using Inside = std::function<bool(const Vec& point)>;

// No way of b out of the solid that a encloses is shorter. Take a point of the core of b, inside at a distance r from
// the surface. The ball of the radius of b around it leaves by r and that radius at least.
[[nodiscard]] Quad depth_of_points(const Side& a, const Side& b, const Inside& is_inside);

// The distance of the nearest two parts after a move of b, if less than `limit`; else some number that is no less.
// Triangles with one side that are met from behind then hold nothing, unless `counts_backs`.
[[nodiscard]] Quad distance_after(const Side& a, const Side& b, const Vec& move, Quad limit, bool counts_backs = true);

// How far a box around each of two parts is apart, at least.
[[nodiscard]] double gap_of_boxes(const Part& a, const Part& b, const Point& move_of_b);

}  // namespace oracle
