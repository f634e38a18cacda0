// SPDX-License-Identifier: Apache-2.0
#include "solid.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {

namespace {

constexpr Vec axis_x{1, 0, 0};
constexpr Vec axis_y{0, 1, 0};
constexpr Vec axis_z{0, 0, 1};

// The half sides count from the origin, which need not be the middle.
Point extents_of(const Body& body) {
  Point extents{};
  for (const Point& p : body.core) {
    for (std::size_t i = 0; i < 3; ++i) extents[i] = std::max(extents[i], std::abs(p[i]) + body.radius);
  }
  return extents;
}

}  // namespace

Solid solid_of(const Body& body) {
  Solid solid;
  const bool has_features = body.core.size() <= most_measured_points;
  const Rounded rounded{body, has_features ? measured(body) : Measured{}};
  solid.size = size_of(body);
  solid.extents = extents_of(body);
  solid.is_straight = has_features && !(body.radius > 0);
  solid.normals = {axis_x, axis_y, axis_z};
  for (const Features& piece : rounded.measured.pieces) {
    solid.normals.insert(solid.normals.end(), piece.normals.begin(), piece.normals.end());
    solid.edges.insert(solid.edges.end(), piece.directions.begin(), piece.directions.end());
  }
  solid.form = rounded;
  return solid;
}

Solid solid_of(const Box& box) {
  const Point& half = box.half;
  return {box, std::hypot(half[0], half[1], half[2]), half, true, {axis_x, axis_y, axis_z}, {axis_x, axis_y, axis_z},
          {}};
}

Solid solid_of(const Cylinder& cylinder) {
  const double radius = cylinder.radius;
  const double half = cylinder.half_height;
  return {cylinder, std::hypot(radius, half), {radius, radius, half}, false, {axis_x, axis_y, axis_z}, {axis_z}, {}};
}

// Along the normals of the slope, rim and apex are equally high: 2 * half_height * nz == radius * nxy.
Solid solid_of(const Cone& cone) {
  const double radius = cone.radius;
  const double half = cone.half_height;
  Solid solid{cone, std::hypot(radius, half), {radius, radius, half}, false, {axis_x, axis_y, axis_z}, {axis_z}, {}};
  const Vec slope = unit({quad(2) * quad(half), 0, quad(radius)});
  if (slope.x > 0) {
    solid.normals.push_back(slope);
    solid.creases.push_back({axis_z, slope.z});
  }
  return solid;
}

// Flat and thin ones have kinks, or nearly so, across their axes.
Solid solid_of(const Ellipsoid& ellipsoid) {
  const Point& radii = ellipsoid.radii;
  const double size = std::max({radii[0], radii[1], radii[2]});
  return {ellipsoid, size, radii, false, {axis_x, axis_y, axis_z}, {axis_x, axis_y, axis_z}, {}};
}

}  // namespace oracle
