// SPDX-License-Identifier: Apache-2.0
// What the oracle measures: convex bodies, half-spaces and triangle soups, described by plain numbers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "quad.hpp"

namespace oracle {

using Point = std::array<double, 3>;

// The convex hull of some points, grown by a radius. Local frame.
struct Body {
  std::vector<Point> core;
  double radius = 0;
};

// All points p with dot(normal, p) <= offset * |normal| in the local frame of a pose.
struct HalfSpace {
  Point normal{0, 0, 1};
  double offset = 0;
};

// Triangles without inside, each three indices into the points.
struct Soup {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

[[nodiscard]] Body make_sphere(double radius);
[[nodiscard]] Body make_capsule(double radius, double half_height);  // along local Z
[[nodiscard]] Body make_box(double x, double y, double z);           // half extents
[[nodiscard]] Body make_hull(std::vector<Point> points);

// Largest distance of a core point from the local origin, plus the radius.
[[nodiscard]] double size_of(const Body& body);
[[nodiscard]] double size_of(const Soup& soup);

}  // namespace oracle
