// SPDX-License-Identifier: Apache-2.0
// Convex solids, curved ones included, described by plain numbers. Local frame, centred, along Z.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "body.hpp"
#include "distance.hpp"
#include "quad.hpp"

namespace oracle {

// Features are looked for up to this many points; larger hulls have support points only, like curved solids.
inline constexpr std::size_t most_measured_points = 48;

// Hull of points grown by a radius: point, segment, triangle, sphere, capsule, hull.
struct Rounded {
  Body body;
  Measured measured;  // without pieces where there are too many points
};

struct Box {
  Point half{};
};

struct Cylinder {
  double radius = 0;
  double half_height = 0;
};

// The base at z = -half_height, the apex at z = half_height.
struct Cone {
  double radius = 0;
  double half_height = 0;
};

struct Ellipsoid {
  Point radii{};
};

// A circle on the sphere of directions along which a support function has a kink: unit n with dot(n, axis) == height.
struct Crease {
  Vec axis;
  Quad height = 0;
};

struct Solid {
  std::variant<Rounded, Box, Cylinder, Cone, Ellipsoid> form;
  double size = 0;              // farthest extent from the local origin
  Point extents{};              // half sides of the box around it
  bool is_straight = false;     // a polytope: the least overlap of two lies at normals and products of edges
  std::vector<Vec> normals;     // of faces, and axes; either sign
  std::vector<Vec> edges;       // directions, either sign
  std::vector<Crease> creases;  // where no edge accounts for them
};

[[nodiscard]] Solid solid_of(const Body& body);
[[nodiscard]] Solid solid_of(const Box& box);
[[nodiscard]] Solid solid_of(const Cylinder& cylinder);
[[nodiscard]] Solid solid_of(const Cone& cone);
[[nodiscard]] Solid solid_of(const Ellipsoid& ellipsoid);

}  // namespace oracle
