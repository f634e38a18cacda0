// SPDX-License-Identifier: Apache-2.0
// Pairs of near points against all pairs.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.trees.grids.particle_grid;

namespace {

using abut::HashGrid;
using abut::Vec3;
using Pairs = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;

Pairs of_all(const std::vector<Vec3>& points, double reach) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    for (std::uint32_t j = i + 1; j < points.size(); ++j) {
      if (abut::squared_norm(points[j] - points[i]) <= reach * reach) {
        pairs.insert({i, j});
      }
    }
  }
  return pairs;
}

Pairs of_grid(const std::vector<Vec3>& points, double cell, double reach) {
  Pairs pairs;
  HashGrid(points, cell).visit_pairs(reach, [&](const HashGrid::Item& a, const HashGrid::Item& b) {
    pairs.insert(std::minmax(a.index, b.index));
  });
  return pairs;
}

// Volumes, areas and lines; reaches below the side of a cell, at it, of several cells, and of all.
TEST(ParticleGrid, VisitsEveryTwoNearPointsOnce) {
  constexpr std::uint64_t seed = 31;
  SCOPED_TRACE(seed);
  test::Random random(seed);
  for (const Vec3& size : std::vector<Vec3>{{1, 1, 1}, {3, 2, 0}, {0, 9, 0}, {0, 0, 0}, {50, 0.1, 0.1}}) {
    std::vector<Vec3> points;
    for (int i = 0; i < 500; ++i) {
      const Vec3 share = random.point(1);
      points.push_back(Vec3{1e3, -7, 0} + Vec3{share.x * size.x, share.y * size.y, share.z * size.z});
    }
    points.push_back(points.front());
    for (const double reach : {0.0, 0.01, 0.1, 0.3, 0.5, 2.0, 1e9}) {
      for (const double cell : {0.1, 0.5}) {
        EXPECT_EQ(of_grid(points, cell, reach), of_all(points, reach)) << reach << ' ' << cell;
      }
    }
  }
}

// Points on the corners of cells, which rounding may put into either of two.
TEST(ParticleGrid, VisitsPointsOnTheCornersOfCells) {
  for (const double step : {0.1, 1.0 / 3, 1.0}) {
    std::vector<Vec3> points;
    for (int i = 0; i < 512; ++i) {
      points.push_back({step * (i % 8), step * (i / 8 % 8), step * (i / 64)});
    }
    for (const double reach : {step, 2 * step, 1.5 * step}) {
      EXPECT_EQ(of_grid(points, step, reach), of_all(points, reach)) << step << ' ' << reach;
    }
  }
}

TEST(ParticleGrid, OnePointHasNoPair) { EXPECT_TRUE(of_grid({{1, 2, 3}}, 1, 10).empty()); }

}  // namespace
