// SPDX-License-Identifier: Apache-2.0
// Points in solid meshes that are bent inward, beside the closed form of a prism.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../support.hpp"

namespace {

using namespace abut_test;
using Corner = std::array<double, 2>;

// A polygon, counter-clockwise, from z = -1 to 1; `ears`: triangles that fill it.
struct Prism {
  std::vector<Corner> corners;
  std::vector<std::uint32_t> ears;

  Shape make() const {
    const auto count = static_cast<std::uint32_t>(corners.size());
    std::vector<double> xyz;
    for (const double z : {-1.0, 1.0}) {
      for (const Corner& corner : corners) xyz.insert(xyz.end(), {corner[0], corner[1], z});
    }
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t j = (i + 1) % count;
      triangles.insert(triangles.end(), {i, j, j + count, i, j + count, i + count});
    }
    for (std::size_t i = 0; i < ears.size(); i += 3) {
      triangles.insert(triangles.end(),
                       {ears[i] + count, ears[i + 1] + count, ears[i + 2] + count, ears[i], ears[i + 2], ears[i + 1]});
    }
    return make_of_kind("mesh", {2}, xyz, triangles);
  }
  double to_border(double x, double y) const {
    double least = 1e9;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
      const double dx = to[0] - from[0], dy = to[1] - from[1];
      const double along = std::clamp(((x - from[0]) * dx + (y - from[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      least = std::min(least, std::hypot(x - from[0] - along * dx, y - from[1] - along * dy));
    }
    return least;
  }
  bool holds(double x, double y) const {
    bool is_in = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
      if ((from[1] > y) != (to[1] > y) && x < (to[0] - from[0]) * (y - from[1]) / (to[1] - from[1]) + from[0]) {
        is_in = !is_in;
      }
    }
    return is_in;
  }
};

// Points on a lattice, many of them straight behind an edge, and none on the surface.
void expect_distances(const Prism& prism) {
  const Shape solid = prism.make(), point = make_of_kind("point", {});
  std::size_t inside = 0;
  for (int i = -5; i <= 45; i += 2) {
    for (int j = -5; j <= 45; ++j) {
      for (const double z : {-1.2, -0.9, -0.4, 0.0, 0.3, 0.95}) {
        const double x = 0.05 * i, y = 0.05 * j, beside = prism.to_border(x, y);
        if (beside < 1e-9) continue;
        const bool is_over = prism.holds(x, y), is_in = is_over && std::abs(z) < 1;
        const double above = std::max(std::abs(z) - 1, 0.0);
        const double truth = is_in ? -std::min(beside, 1 - std::abs(z)) : std::hypot(is_over ? 0 : beside, above);
        EXPECT_NEAR(distance_of(solid, identity, point, at(x, y, z)), truth, 1e-12) << x << ' ' << y << ' ' << z;
        inside += is_in ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 1000U);
}

TEST(PointInASolid, IsAsDeepAsTheSurfaceIsNear) {
  expect_distances({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {0, 1, 3, 1, 2, 3, 0, 3, 5, 3, 4, 5}});
  expect_distances({{{0, 0}, {2, 0}, {2, 2}, {1, 0.7}, {0, 2}}, {0, 1, 3, 1, 2, 3, 0, 3, 4}});
}

}  // namespace
