// SPDX-License-Identifier: Apache-2.0
// Floors that are flat, cut into triangles in many ways, and convex bodies of which the support function is known.
#pragma once

#include <abut/abut.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scenes.hpp"

namespace property {

using Vec = std::array<double, 3>;

inline constexpr abut_pose identity{{0, 0, 0}, {1, 0, 0, 0}};

inline Vec plus(const Vec& u, const Vec& v) { return {u[0] + v[0], u[1] + v[1], u[2] + v[2]}; }
inline Vec times(double s, const Vec& v) { return {s * v[0], s * v[1], s * v[2]}; }
inline double dot(const Vec& u, const Vec& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
inline double length(const Vec& v) { return std::sqrt(dot(v, v)); }
inline Vec vec(const abut_vec3& v) { return {v.x, v.y, v.z}; }

// The columns of the rotation of a quaternion.
inline std::array<Vec, 3> axes_of(const abut_quat& q) {
  return {{{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)},
           {2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)},
           {2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}}};
}
inline Vec turned(const abut_quat& q, const Vec& v) {
  const auto [x, y, z] = axes_of(q);
  return plus(plus(times(v[0], x), times(v[1], y)), times(v[2], z));
}
inline Vec turned_back(const abut_quat& q, const Vec& v) {
  const auto [x, y, z] = axes_of(q);
  return {dot(x, v), dot(y, v), dot(z, v)};
}
inline Vec placed(const abut_pose& pose, const Vec& v) { return plus(vec(pose.position), turned(pose.orientation, v)); }
inline abut_quat unit(double w, double x, double y, double z) {
  const double size = std::sqrt(w * w + x * x + y * y + z * z);
  return {w / size, x / size, y / size, z / size};
}

struct Body {
  std::string name;
  ShapePtr shape;
  double radius;                              // of the rounding of the core
  std::function<double(const Vec&)> support;  // the largest n.p over its points, in its frame
};

[[nodiscard]] Body ball(double r);
[[nodiscard]] Body capsule(const std::string& name, double r, double h);
[[nodiscard]] Body box(const std::string& name, double x, double y, double z);
[[nodiscard]] Body hull(const std::string& name, const std::vector<Vec>& points);
// One or more of each kind, also thin ones.
[[nodiscard]] std::vector<Body> convex_bodies(Random& random);

enum class FloorKind { mesh, uv_grid, height_field };
enum class FloorDamage { none, slivers, no_area };

// A square floor of `size` to each side in the plane that a pose turns the plane z = 0 to, in its own frame.
struct FlatFloor {
  FloorKind kind = FloorKind::mesh;
  abut_sides sides = ABUT_SIDES_BOTH;
  std::uint32_t cells = 8;
  double size = 8;
  abut_pose frame = identity;
  bool as_float = false;
  bool shuffled = false;
  FloorDamage damage = FloorDamage::none;
};

struct Ground {
  ShapePtr shape;
  std::vector<Vec> vertices;
  Vec normal;
  double offset;
  double blur;  // by how much vertices are beside the plane
};

[[nodiscard]] std::string text_of(const FlatFloor& floor);
[[nodiscard]] ShapePtr mesh_of(const std::vector<Vec>& vertices, const std::vector<std::uint32_t>& triangles,
                               FloorKind kind, abut_sides sides);
[[nodiscard]] ShapePtr field_of(std::uint32_t columns, double spacing, const std::vector<double>& heights,
                                abut_below below);
[[nodiscard]] Ground ground_of(const FlatFloor& floor, Random& random);
// Of all kinds, sides, sizes and damages.
[[nodiscard]] std::vector<FlatFloor> flat_floors(Random& random);

}  // namespace property
