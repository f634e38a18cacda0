// SPDX-License-Identifier: Apache-2.0
// What the benchmarks give to every library: solids, placements, and the seeded numbers behind them.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

namespace bench {

using Point = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // scalar first

// The turn by q, then that by p.
[[nodiscard]] inline Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

// By the axis times the angle.
[[nodiscard]] inline Quaternion turn_by(const Point& turn) {
  const double angle = std::hypot(turn[0], turn[1], turn[2]);
  const double share = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
  return {std::cos(angle / 2), share * turn[0], share * turn[1], share * turn[2]};
}

enum class Kind : std::uint8_t {
  sphere,
  box,
  capsule,
  plane,
  hull32,
  hull200,
  cylinder,
  cone,
  ellipsoid,
  hull,
  triangle,
  mesh,
  height_field,
  solid_mesh,
  distance_field,
  particles,
  composite,
  point
};

[[nodiscard]] constexpr std::string_view kind_name(Kind kind) {
  constexpr std::array<std::string_view, 18> names{
      "sphere",       "box",        "capsule",        "plane",     "hull32",    "hull200",
      "cylinder",     "cone",       "ellipsoid",      "hull",      "triangle",  "mesh",
      "height_field", "solid_mesh", "distance_field", "particles", "composite", "point"};
  return names[static_cast<std::size_t>(kind)];
}
[[nodiscard]] constexpr bool is_hull(Kind kind) {
  return kind == Kind::hull32 || kind == Kind::hull200 || kind == Kind::hull;
}

[[nodiscard]] constexpr bool is_surface(Kind kind) { return kind == Kind::mesh || kind == Kind::height_field; }

[[nodiscard]] constexpr bool is_mesh(Kind kind) { return kind == Kind::mesh || kind == Kind::solid_mesh; }

// Ground whose size says nothing about the pair.
[[nodiscard]] constexpr bool is_endless(Kind kind) {
  return kind == Kind::plane || is_surface(kind) || kind == Kind::distance_field;
}

// What peers of convex solids cannot be asked about.
[[nodiscard]] constexpr bool is_bounded_and_convex(Kind kind) {
  return kind != Kind::plane && !is_surface(kind) && kind != Kind::solid_mesh && kind != Kind::distance_field &&
         kind != Kind::particles && kind != Kind::composite;
}

// Sphere: radius. Box: half extents. Capsule, cylinder, cone: radius and half height, along z, the apex of the
// cone above. Ellipsoid: radii. Plane: the half-space below z = 0. Triangle: its corners. Hull: its vertices and
// its surface, counter-clockwise seen from outside; hull32 and hull200 are made of so many points, hull of any. Mesh
// and height field: a square terrain. Sizes: samples of a side, and the spacing. The corner of the samples is the
// origin. Solid mesh: a closed surface with its inside. Distance field: the half-space below z = 0 as far as its
// samples go; sizes: samples of a side, and the spacing; the middle of its square is the origin. Particles: balls of
// one radius. Composite: boxes of the same half extents, at the points.
struct Solid {
  Kind kind = Kind::sphere;
  Point sizes{};
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
};

struct Placement {
  Point position{};
  Quaternion orientation{1, 0, 0, 0};  // unit
};

// The same numbers on every platform, which the distributions of the standard library do not promise.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  [[nodiscard]] std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }

  [[nodiscard]] Point direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi), radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
  }
  // Uniform over all rotations (Shoemake 1992).
  [[nodiscard]] Quaternion orientation() {
    const double share = uniform(0, 1), s = uniform(0, 2 * std::numbers::pi), t = uniform(0, 2 * std::numbers::pi);
    const double p = std::sqrt(1 - share), q = std::sqrt(share);
    return {p * std::sin(s), p * std::cos(s), q * std::sin(t), q * std::cos(t)};
  }

 private:
  std::mt19937_64 engine_;
};

// A solid of about unit size. A hull gets points on a perturbed sphere; its surface is left to the caller.
[[nodiscard]] inline Solid random_solid(Kind kind, Random& random) {
  Solid solid{kind, {}, {}, {}};
  if (is_hull(kind)) {
    const Point axes{random.uniform(0.4, 0.8), random.uniform(0.4, 0.8), random.uniform(0.4, 0.8)};
    const std::size_t count = kind == Kind::hull32 ? 32 : 200;
    const double roughness = kind == Kind::hull32 ? 0.03 : 0.003;
    while (solid.points.size() < count) {
      const Point direction = random.direction();
      const double radius = random.uniform(1 - roughness, 1 + roughness);
      solid.points.push_back(
          {radius * axes[0] * direction[0], radius * axes[1] * direction[1], radius * axes[2] * direction[2]});
    }
  } else if (kind != Kind::point) {
    solid.sizes = {random.uniform(0.3, 0.7), random.uniform(0.3, 0.7), random.uniform(0.3, 0.7)};
  }
  return solid;
}

// Triangles of a square of `side` points along each side. Row by row, X fastest, and each cell split from its first
// corner to its last.
inline void add_cells(Solid& solid, int side) {
  for (int j = 0; j + 1 < side; ++j) {
    for (int i = 0; i + 1 < side; ++i) {
      const int first = j * side + i, last = first + side + 1;
      solid.triangles.push_back({first, first + 1, last});
      solid.triangles.push_back({first, last, last - 1});
    }
  }
}

// Hills of two lengths, rough in the small: 131,072 triangles, of which about forty meet a solid of random_solid.
[[nodiscard]] inline Solid terrain(Kind kind, Random& random) {
  constexpr int side = 257;
  constexpr double spacing = 0.25;
  Solid solid{kind, {side, spacing, 0}, {}, {}};
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double z = 0.75 * std::sin(0.11 * i) * std::cos(0.13 * j) + 0.15 * std::sin(0.5 * i + 0.3 * j) +
                       random.uniform(-0.025, 0.025);
      solid.points.push_back({spacing * i, spacing * j, z});
    }
  }
  add_cells(solid, side);
  return solid;
}

// Radius of a ball around the origin that holds the solid; of a plane 0.
[[nodiscard]] inline double bounding_radius(const Solid& solid) {
  double square = 0;
  switch (solid.kind) {
    case Kind::sphere: return solid.sizes[0];
    case Kind::box: return std::hypot(solid.sizes[0], solid.sizes[1], solid.sizes[2]);
    case Kind::capsule: return solid.sizes[0] + solid.sizes[1];
    case Kind::cylinder:
    case Kind::cone: return std::hypot(solid.sizes[0], solid.sizes[1]);
    case Kind::ellipsoid: return std::fmax(solid.sizes[0], std::fmax(solid.sizes[1], solid.sizes[2]));
    case Kind::plane:
    case Kind::point: return 0;
    case Kind::mesh:
    case Kind::height_field:
    case Kind::distance_field: return solid.sizes[0] * solid.sizes[1];
    case Kind::particles: square = solid.sizes[0] * solid.sizes[0]; break;
    case Kind::solid_mesh:
    case Kind::composite:
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull:
    case Kind::triangle:
      for (const Point& p : solid.points) {
        square = std::fmax(square, p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      }
      return std::sqrt(square);
  }
  return 0;
}

}  // namespace bench
