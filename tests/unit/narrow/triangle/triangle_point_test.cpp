// SPDX-License-Identifier: Apache-2.0
// The point of a triangle nearest to another one, where two corners of the triangle are one: that of a segment.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.triangle.triangle_point;

namespace {

using abut::Vec3;

TEST(TrianglePoint, IsThatOfASegmentWhereTwoCornersAreOne) {
  test::Random random(291);
  for (int round = 0; round < 300; ++round) {
    const Vec3 p = random.point(1), q = random.point(1), point = random.point(2), along = q - p;
    const double share = std::clamp(dot(point - p, along) / squared_norm(along), 0.0, 1.0);
    const Vec3 expected = p + share * along;
    for (const std::array<Vec3, 3>& corners :
         {std::array{p, p, q}, std::array{p, q, p}, std::array{q, p, p}, std::array{q, q, p}}) {
      const auto [from, way] = abut::nearest_way({corners[0], corners[1], corners[2]}, point);
      EXPECT_LT(norm(from - expected), 1e-12) << "round " << round;
      EXPECT_LT(norm(way - (point - expected)), 1e-12) << "round " << round;
    }
  }
}

// Rounding leaves corners on a line an area or none.
TEST(TrianglePoint, HasAWayFromCornersOnALine) {
  test::Random random(292);
  for (int round = 0; round < 3000; ++round) {
    const Vec3 start = random.point(1), along = random.point(1), point = random.point(2);
    const auto at = [&](double share) { return start + share * along; };
    const auto [from, way] = abut::nearest_way({at(0), at(random.uniform(-1, 1)), at(random.uniform(-1, 1))}, point);
    EXPECT_TRUE(is_finite(from) && is_finite(way)) << "round " << round;
  }
}

}  // namespace
