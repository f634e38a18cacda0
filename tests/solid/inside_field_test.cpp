// SPDX-License-Identifier: Apache-2.0
// A height field without solid ground, all of it inside a solid mesh: no triangle meets another one.
#include <limits>

#include "solids.hpp"

namespace {

using namespace solid;
using Axis = std::array<double, 3>;

constexpr double reach = 3;  // of the cube along each axis

ShapePtr field(std::uint32_t columns, std::uint32_t rows, const std::vector<double>& heights) {
  abut_height_field_desc desc;
  abut_height_field_desc_init(&desc, sizeof desc);
  desc.columns = columns;
  desc.rows = rows;
  desc.spacing_x = desc.spacing_y = 1;
  desc.heights = heights.data();
  return made([&](abut_shape** out) { return abut_height_field_create(&desc, out); });
}

Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Axis turned(const std::array<double, 4>& q, const Axis& v) {
  const Axis u{q[1], q[2], q[3]}, uv = cross(u, v), uuv = cross(u, uv);
  return {v[0] + 2 * (q[0] * uv[0] + uuv[0]), v[1] + 2 * (q[0] * uv[1] + uuv[1]), v[2] + 2 * (q[0] * uv[2] + uuv[2])};
}

// The least move of a rectangle out of the cube, by the separating axes of two convex bodies.
double least_move(const std::array<Axis, 4>& corners, const Axis& along, const Axis& across) {
  std::vector<Axis> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, cross(along, across)};
  for (std::size_t i = 0; i < 3; ++i) {
    axes.push_back(cross(axes[i], along));
    axes.push_back(cross(axes[i], across));
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Axis& axis : axes) {
    const double length = std::sqrt(dot(axis, axis));
    if (length < 1e-9) continue;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Axis& corner : corners) {
      low = std::min(low, dot(axis, corner));
      high = std::max(high, dot(axis, corner));
    }
    const double wide = reach * (std::abs(axis[0]) + std::abs(axis[1]) + std::abs(axis[2]));
    least = std::min({least, (wide - low) / length, (high + wide) / length});
  }
  return least;
}

// No shorter than any way out of the cube; the same as that of a mesh.
TEST(InsideField, DepthOfAFlatField) {
  const ShapePtr cube = mesh(box_surface(reach, reach, reach)), flat = field(3, 2, std::vector<double>(6, 0));
  // A field has a front.
  const ShapePtr same = mesh(
      {{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0}, {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}}, ABUT_SIDES_FRONT);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int scene = 0; scene < 30; ++scene) {
    SCOPED_TRACE("scene " + std::to_string(scene) + " of seed 7");
    std::array<double, 4> q{uniform(random), uniform(random), uniform(random), uniform(random)};
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (length < 0.1) continue;
    for (double& number : q) number /= length;
    const Axis place{uniform(random) / 2, uniform(random) / 2, uniform(random) / 2};
    const Axis along = turned(q, {1, 0, 0}), across = turned(q, {0, 1, 0});
    std::array<Axis, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        corners[i][k] = place[k] + (i % 2 != 0 ? 2 * along[k] : 0) + (i / 2 != 0 ? across[k] : 0);
      }
    }
    const abut_pose pose{{place[0], place[1], place[2]}, {q[0], q[1], q[2], q[3]}};
    const abut_distance found = distance(cube, flat, pose);
    EXPECT_LE(found.distance, -least_move(corners, along, across) + 1e-9);
    EXPECT_NEAR(found.distance, distance(cube, same, pose).distance, 1e-9);
    expect_parted(cube, flat, pose, found);
    EXPECT_NEAR(least_of(contacts(cube, flat, pose)), found.distance, 1e-9);
  }
}

// A column of holes leaves two pieces: the first is outside, the second inside, and both beside the wall.
TEST(InsideField, OnePieceOfTwo) {
  const double hole = std::nan("");
  const ShapePtr cube = mesh(box_surface(reach, reach, reach)),
                 halves = field(5, 2, {0, 0, hole, 0, 0, 0, 0, hole, 0, 0});
  const abut_pose pose = at(-4.5, -0.5, 0), here = at(0, 0, 0);
  uint32_t overlaps = 0;
  EXPECT_EQ(abut_pair_overlaps(cube.get(), &here, halves.get(), &pose, nullptr, &overlaps), ABUT_OK);
  EXPECT_EQ(overlaps, 1u);
  const abut_distance found = distance(cube, halves, pose);
  EXPECT_LT(found.distance, -1);
  expect_parted(cube, halves, pose, found);
  // Both outside.
  EXPECT_GT(distance(cube, halves, at(-8, -0.5, 0)).distance, 0.9);
}

}  // namespace
