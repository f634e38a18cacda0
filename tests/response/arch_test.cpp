// SPDX-License-Identifier: Apache-2.0
// A half circle of 27 stones without mortar. It stands from a thickness of 0.1075 of the radius of its middle line
// (Milankovitch; Makris and Alexakis, Archive of Applied Mechanics 83, 2013).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "scene.hpp"

namespace {

using namespace response_test;

constexpr double radius = 10;

abut_part_id stone(Scene& scene, double from, double to, double thickness, bool is_abutment) {
  std::vector<Vector> corners;
  Vector middle;
  for (const double r : {radius - thickness / 2, radius + thickness / 2}) {
    for (const double angle : {from, to}) {
      for (const double y : {-0.5, 0.5}) {
        corners.push_back({r * std::cos(angle), y, r * std::sin(angle)});
        middle = middle + 0.125 * corners.back();
      }
    }
  }
  std::vector<double> xyz;
  for (const Vector& corner : corners) {
    const Vector local = corner - middle;
    xyz.insert(xyz.end(), {local.x, local.y, local.z});
  }
  const Shape shape = shape_from([&](abut_shape** out) { return abut_hull_create(xyz.data(), corners.size(), out); });
  const abut_pose pose{{middle.x, middle.y, middle.z}, no_turn};
  return is_abutment ? scene.place(shape, pose, ABUT_MOTION_STATIC) : scene.body(shape, pose, 1000);
}

// How far the stone that moves most is from where it was.
double drift_after(double thickness, double time) {
  constexpr int count = 27;
  constexpr double pi = std::numbers::pi, step = 1e-2;
  Scene scene({}, 1e-4);
  scene.material([](abut_contact_material& row) { row.friction_primary = row.friction_secondary = 0.9; });
  stone(scene, -0.1, 0, thickness, true);
  stone(scene, pi, pi + 0.1, thickness, true);
  std::vector<abut_part_id> parts;
  std::vector<abut_vec3> starts;
  for (int i = 0; i < count; ++i) {
    parts.push_back(stone(scene, i * pi / count, (i + 1) * pi / count, thickness, false));
    starts.push_back(scene.pose(parts.back()).position);
  }
  scene.step(step, static_cast<int>(std::lround(time / step)));
  double drift = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const abut_vec3 now = scene.pose(parts[i]).position, &start = starts[i];
    drift = std::max(drift, length({now.x - start.x, now.y - start.y, now.z - start.z}));
  }
  return drift;
}

TEST(Arch, StandsWhereItIsThickEnough) { EXPECT_LE(drift_after(0.115 * radius, 10), 1e-6 * radius); }

TEST(Arch, FallsWhereItIsThin) { EXPECT_GE(drift_after(0.1 * radius, 1.5), 0.1 * radius); }

}  // namespace
