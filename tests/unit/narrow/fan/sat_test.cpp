// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.sphere;

namespace {

using abut::Pose;
using abut::Vec3;

// A rod against a box is a box without width against a box.
TEST(Sat, CapsuleCoreIsABoxWithoutWidth) {
  test::Random random(71);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 half = abut::absolute(random.point(1)) + Vec3{0.01, 0.01, 0.01};
    const double length = random.uniform(0.01, 2);
    const Pose ab{random.rotation(), random.point(1.5)};
    const auto found =
        abut::sat(test::made<abut::Box>({half.x, half.y, half.z}), test::made<abut::Capsule>({1, length}), ab, 0);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->axes, 6u);
    const std::vector<Vec3> a = test::corners_of(half, Pose::identity()), b = test::corners_of({0, 0, length}, ab);
    EXPECT_NEAR(-test::corners_overreach(a, b, found->normal, 0), found->separation, 1e-14);
    // More axes, those of the sides that a rod does not have, can only separate further when apart.
    const double of_boxes = abut::sat_of_boxes(half, {0, 0, length}, ab, 0, abut::infinity).separation;
    if (of_boxes < 0) {
      EXPECT_NEAR(found->separation, of_boxes, 1e-14);
    } else {
      EXPECT_LE(found->separation, of_boxes + 1e-14);
    }
  }
}

TEST(Sat, NothingBetweenPointsOrParallelRods) {
  const auto ball = test::made<abut::Sphere>({1});
  const auto rod = test::made<abut::Capsule>({1, 2});
  EXPECT_FALSE(abut::sat(ball, ball, Pose::identity(), 0).has_value());
  EXPECT_FALSE(abut::sat(rod, ball, Pose::identity(), 0).has_value());
  EXPECT_FALSE(abut::sat(rod, rod, Pose::identity(), 0).has_value());
  const abut::Rotation crossed = abut::Rotation::from({std::sqrt(0.5), std::sqrt(0.5), 0, 0});
  const auto found = abut::sat(rod, rod, {crossed, {0, 0, 0}}, 0);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->separation, 0);
  EXPECT_TRUE(found->features.are_edges());
}

// However small the angle between two edges, the normal across them leads along neither: their lengths would multiply
// that.
TEST(Sat, NormalAcrossNearlyParallelEdgesIsAcrossBoth) {
  test::Random random(72);
  for (int i = 0; i < 4000; ++i) {
    const double angle = std::pow(10, random.uniform(-13, -1));
    const Vec3 a = random.point(1), b = a + angle * random.point(1), product = cross(a, b);
    const Vec3 n = abut::unit_across_edges(a, b, product, abut::squared_norm(product));
    EXPECT_NEAR(abut::norm(n), 1, 1e-15);
    EXPECT_NEAR(dot(n, a), 0, 1e-12) << angle;
    EXPECT_NEAR(dot(n, b), 0, 1e-12) << angle;
  }
}

}  // namespace
