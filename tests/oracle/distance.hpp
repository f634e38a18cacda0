// SPDX-License-Identifier: Apache-2.0
// Signed distance of two shapes by brute force over their features, in 113-bit floating point.
//
// Apart: the least distance of vertices, edges and faces. Overlapping: the largest separation (negative) over the
// normals of faces and the cross products of edges, which is exact for polytopes. Cores that touch, or that overlap
// in a common plane or line only, have depth 0. Radii are subtracted at the end.
#pragma once

#include <optional>
#include <vector>

#include "body.hpp"
#include "features.hpp"
#include "quad.hpp"

namespace oracle {

// A shape with its features, found once: convex pieces that share a radius, or a half-space.
struct Measured {
  std::vector<Features> pieces;
  double radius = 0;
  std::optional<HalfSpace> half_space;
  double size = 0;  // farthest extent from the local origin; 0 for half-spaces
};

[[nodiscard]] Measured measured(const Body& body);
[[nodiscard]] Measured measured(const HalfSpace& half_space);
[[nodiscard]] Measured measured(const Soup& soup);

struct Witness {
  Vec a;
  Vec b;
};

struct Answer {
  Quad distance = 0;               // negative: depth
  Vec normal;                      // unit, from a to b
  std::optional<Witness> witness;  // world frame; absent where the cores overlap in depth
  Quad core_distance = 0;          // without the radii
};

// Of triangle soups: the least over their triangles, each taken as a flat convex body. Not for two half-spaces.
[[nodiscard]] Answer signed_distance(const Measured& a, const Pose& pose_a, const Measured& b, const Pose& pose_b);

// The separation of two shapes along a unit direction from a to b: positive when a plane across it parts them.
[[nodiscard]] Quad separation_along(const Measured& a, const Pose& pose_a, const Measured& b, const Pose& pose_b,
                                    const Vec& direction);

// Signed distance of a point to a shape.
[[nodiscard]] Quad distance_to_point(const Measured& shape, const Pose& pose, const Vec& point);

}  // namespace oracle
