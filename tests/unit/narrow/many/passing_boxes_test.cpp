// SPDX-License-Identifier: Apache-2.0
// Boxes around triangles meet on a way where they do at some of many times.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.many.passing_boxes;

namespace {

using abut::FourTriangles;
using abut::Real;
using abut::TriangleCorners;
using abut::Vec3;

TriangleCorners random_triangle(test::Random& random, Real apart) {
  const Vec3 at = random.point(apart);
  return {at + random.point(1), at + random.point(1), at + random.point(1)};
}

// How far the boxes are apart along the axis that parts them furthest; negative where they overlap.
Real gap_at(const TriangleCorners& a, const TriangleCorners& b, const abut::Rotation& of_b, const Vec3& moved) {
  Real gap = -abut::infinity;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, of_b.x, of_b.y, of_b.z}) {
    const auto [low_a, high_a] = std::minmax({dot(axis, a[0]), dot(axis, a[1]), dot(axis, a[2])});
    const auto [low_b, high_b] =
        std::minmax({dot(axis, b[0] + moved), dot(axis, b[1] + moved), dot(axis, b[2] + moved)});
    gap = std::max({gap, low_a - high_b, low_b - high_a});
  }
  return gap;
}

TEST(PassingBoxes, MeetWhereTheyDoAtSomeTime) {
  test::Random random(29);
  int met = 0, passed = 0;
  for (int i = 0; i < 400; ++i) {
    const std::array<TriangleCorners, 4> first{random_triangle(random, 1), random_triangle(random, 1),
                                               random_triangle(random, 1), random_triangle(random, 1)},
        second{random_triangle(random, 1), random_triangle(random, 1), random_triangle(random, 1),
               random_triangle(random, 1)};
    const abut::Rotation of_second = random.rotation();
    // Along one axis, along none, and any other way.
    const Vec3 way = i % 10 == 0 ? Vec3{0, 3, 0} : i % 10 == 1 ? Vec3{0, 0, 0} : random.point(3);
    const Real slack = i % 3 == 0 ? 0.1 : 0;
    const auto bits =
        abut::PassingBoxes(of_second).meet(FourTriangles::of(first, {}), FourTriangles::of(second, {}), way, slack);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      constexpr int times = 500;
      Real least = abut::infinity;
      for (int time = 0; time <= times; ++time) {
        least = std::min(least, gap_at(first[lane], second[lane], of_second, (time / Real{times}) * way));
      }
      const bool is_met = (bits >> lane & 1) != 0;
      met += is_met ? 1 : 0;
      passed += is_met ? 0 : 1;
      // Between two times the boxes get no nearer than half of a step.
      const Real step = norm(way) / times;
      EXPECT_TRUE(is_met || least > slack) << "case " << i << ", pair " << lane;
      EXPECT_TRUE(!is_met || least <= slack + step) << "case " << i << ", pair " << lane;
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(passed, 300);
}

}  // namespace
