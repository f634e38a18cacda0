// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.sphere;

namespace {

using abut::Pose;
using abut::Vec3;

template <class A, class B>
abut::GjkResult between(const A& a, const B& b, const Pose& ab, double limit = abut::infinity) {
  return abut::gjk(a, b, ab, ab.position, 10, 1e-12, limit);
}

TEST(Gjk, RandomBoxesAreProvenByTheirCorners) {
  test::Random random(41);
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = abut::absolute(random.point(1));
    const Pose ab{random.rotation(), random.point(3)};
    const abut::GjkResult found = between(test::made<abut::Box>({half_a.x, half_a.y, half_a.z}),
                                          test::made<abut::Box>({half_b.x, half_b.y, half_b.z}), ab);
    EXPECT_LE(found.iterations, 12u);
    if (found.overlap) {
      continue;
    }
    ++apart;
    const double overreach = test::corners_overreach(test::corners_of(half_a, Pose::identity()),
                                                     test::corners_of(half_b, ab), found.normal, found.upper);
    EXPECT_LE(std::fabs(overreach), 1e-11);
    EXPECT_LE(found.lower, found.upper);
    EXPECT_LE(found.upper - found.lower, 1.1e-12);
    EXPECT_LE(abut::norm(found.closest + found.upper * found.normal), 1e-12);
  }
  EXPECT_GT(apart, 1500);
}

TEST(Gjk, CoresOfRoundedShapes) {
  const auto ball = test::made<abut::Sphere>({1});
  const auto rod = test::made<abut::Capsule>({0.5, 2});
  const Pose aside{abut::Rotation::identity(), {3, 0, 4}};
  EXPECT_EQ(between(ball, ball, aside).upper, 5);
  EXPECT_NEAR(between(ball, rod, aside).upper, std::sqrt(9.0 + 4.0), 1e-15);
  EXPECT_EQ(between(rod, rod, aside).upper, 3);
}

TEST(Gjk, StopsWhenItKnowsThatTheCoresAreFar) {
  const auto box = test::made<abut::Box>({1, 1, 1});
  const Pose far{abut::Rotation::from({0.9, 0.1, 0.3, 0.2}), {8, 1, 2}};
  const abut::GjkResult early = between(box, box, far, 1.0), full = between(box, box, far);
  EXPECT_TRUE(early.beyond);
  EXPECT_GT(early.lower, 1);
  EXPECT_LE(early.lower, full.upper);
  EXPECT_LE(early.iterations, full.iterations);
  EXPECT_FALSE(between(box, box, far, 100.0).beyond);
}

TEST(Gjk, OverlapAndTouch) {
  const auto box = test::made<abut::Box>({1, 1, 1});
  EXPECT_TRUE(between(box, box, Pose::identity()).overlap);
  EXPECT_TRUE(between(box, box, {abut::Rotation::identity(), {2, 0, 0}}).overlap);
  EXPECT_TRUE(between(box, box, {abut::Rotation::identity(), {1.9, 1.9, 1.9}}).overlap);
  const abut::GjkResult apart = between(box, box, {abut::Rotation::identity(), {2 + 1e-9, 0, 0}});
  EXPECT_FALSE(apart.overlap);
  EXPECT_NEAR(apart.upper, 1e-9, 1e-15);
}

TEST(Gjk, StartsFromAnyDirection) {
  const auto box = test::made<abut::Box>({1, 2, 3});
  const Pose ab{abut::Rotation::from({0.5, 0.4, 0.3, 0.2}), {6, 1, 2}};
  const double expected = between(box, box, ab).upper;
  test::Random random(42);
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(abut::gjk(box, box, ab, random.point(1), 10, 1e-12, abut::infinity).upper, expected, 1e-12);
  }
  EXPECT_NEAR(abut::gjk(box, box, ab, {0, 0, 0}, 10, 1e-12, abut::infinity).upper, expected, 1e-12);
}

// Boxes nearer to each other than the bound: unproven, they would pass for an overlap.
TEST(Gjk, ACoarseBoundHoldsOnceTheCoresAreProvenApart) {
  test::Random random(43);
  constexpr double coarse = 1e-2, fine = 1e-12;
  int near = 0, pass_for_overlaps = 0;
  while (near < 500) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = abut::absolute(random.point(1));
    const auto a = test::made<abut::Box>({half_a.x, half_a.y, half_a.z}),
               b = test::made<abut::Box>({half_b.x, half_b.y, half_b.z});
    Pose ab{random.rotation(), random.point(3)};
    const abut::GjkResult apart = between(a, b, ab);
    if (apart.overlap || apart.upper < 0.1) {
      continue;
    }
    ++near;
    const double gap = std::pow(10, random.uniform(-6, -2.5));
    ab.position += -(apart.upper - gap) * apart.normal;
    const abut::GjkResult found = abut::gjk(a, b, ab, ab.position, 10, coarse, abut::infinity, fine);
    ASSERT_FALSE(found.overlap) << gap;
    EXPECT_LE(found.lower, gap + 1e-12);
    EXPECT_GE(found.upper, gap - 1e-12);
    EXPECT_LE(found.upper - found.lower, coarse);
    pass_for_overlaps += abut::gjk(a, b, ab, ab.position, 10, coarse, abut::infinity).overlap ? 1 : 0;
  }
  EXPECT_GT(pass_for_overlaps, 0);
}

}  // namespace
