// SPDX-License-Identifier: Apache-2.0
// Cores that overlap equally deep, but for parts in a million, along a whole ring of directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.convex.separation;
import abut.narrow.cores.difference;
import abut.narrow.polytope.depth_descent;
import abut.narrow.polytope.depth_minimum;
import abut.shapes.box;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.ellipsoid;
import abut.shapes.segment;

namespace {

using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr Real tolerance = 1e-9;  // of the lengths in a scene

template <class A, class B>
abut::CoreSeparation separation_of(const A& a, const B& b, const Pose& ab) {
  return abut::separate_cores(a, b, ab, abut::QuerySettings{}, abut::infinity);
}

template <class A, class B>
Real overlap_along(const A& a, const B& b, const Pose& ab, const Vec3& n) {
  return dot(n, a.support(n).point - ab * b.support(ab.rotation.undo(-n)).point);
}

// Over the ring of directions that lean out of the plane across Z by an angle of a given sine. For cores that vary by
// parts in a million, the steps are so small that the overlap changes by less than the tolerance.
template <class A, class B>
Real least_on_ring(const A& a, const B& b, const Pose& ab, Real sine) {
  const Real cosine = std::sqrt(1 - sine * sine);
  constexpr int count = 40000;
  Real least = abut::infinity;
  for (int i = 0; i < count; ++i) {
    const Real around = 2 * std::numbers::pi * i / count;
    least = std::min(least, overlap_along(a, b, ab, {cosine * std::cos(around), cosine * std::sin(around), sine}));
  }
  return least;
}

template <class A, class B>
void expect_depth(const A& a, const B& b, const Pose& ab, Real depth, int trial) {
  const abut::CoreSeparation found = separation_of(a, b, ab);
  const Real near = tolerance * (a.extent() + b.extent());
  EXPECT_NEAR(-found.distance, depth, near) << trial;
  EXPECT_NEAR(overlap_along(a, b, ab, found.normal), depth, near) << trial;
  const Vec3 between = found.point_b - found.point_a;
  EXPECT_NEAR(dot(between, found.normal), found.distance, near) << trial;
  // Along a surface points are known to the root of the bound at best.
  EXPECT_LE(norm(between - found.distance * found.normal), 1e-7) << trial;
  EXPECT_LE(found.lower, -depth + near) << trial;
  EXPECT_GE(found.upper, -depth - near) << trial;
}

TEST(DepthDescent, SpeckInACone) {
  const auto cone = test::made<abut::Cone>({1, 0.75});
  const Real slant = std::hypot(1.5, 1.0);
  test::Random random(5);
  for (int i = 0; i < 40; ++i) {
    const Real size = 1e-6 * random.uniform(0.2, 1);
    const auto box = test::made<abut::Box>({size, 2 * size, 0.5 * size});
    const Pose ab{random.rotation(), random.point(2e-6)};
    expect_depth(cone, box, ab, least_on_ring(cone, box, ab, 1 / slant), i);
  }
}

TEST(DepthDescent, NeedleAcrossACone) {
  const auto cone = test::made<abut::Cone>({1, 0.75});
  const auto needle = test::made<abut::Segment>({1e-6});
  const Real slant = std::hypot(1.5, 1.0);
  test::Random random(6);
  for (int i = 0; i < 40; ++i) {
    const Pose ab{random.rotation(), random.point(2e-6)};
    expect_depth(cone, needle, ab, least_on_ring(cone, needle, ab, 1 / slant), i);
  }
}

// The axes are `aside` apart, so both sides overlap by the sum of the radii less that.
TEST(DepthDescent, CylindersWhoseAxesAlmostMeet) {
  const auto a = test::made<abut::Cylinder>({0.5, 3}), b = test::made<abut::Cylinder>({0.25, 2});
  test::Random random(7);
  for (Real aside = 1e-9; aside < 1e-3; aside *= 10) {
    for (int i = 0; i < 8; ++i) {
      const Real around = random.uniform(0, 6.3);
      const Pose ab{abut::Rotation::identity(),
                    {aside * std::cos(around), aside * std::sin(around), random.uniform(-0.5, 0.5)}};
      expect_depth(a, b, ab, 0.75 - aside, i);
    }
  }
}

TEST(DepthDescent, CylindersWhoseAxesCrossFlatly) {
  const auto a = test::made<abut::Cylinder>({0.5, 3}), b = test::made<abut::Cylinder>({0.25, 2});
  test::Random random(8);
  for (Real lean = 1e-9; lean < 1e-3; lean *= 10) {
    for (int i = 0; i < 8; ++i) {
      const Real around = random.uniform(0, 6.3), sine = std::sin(0.5 * lean);
      const abut::Quat tilt{std::cos(0.5 * lean), sine * std::cos(around), sine * std::sin(around), 0};
      const Pose ab{abut::Rotation::from(tilt), {0, 0, random.uniform(-0.5, 0.5)}};
      expect_depth(a, b, ab, 0.75, i);
    }
  }
}

// Round but for one radius, and a needle along that one: the least overlap is along Z, where the needle ends.
TEST(DepthDescent, NeedleInAFlatBall) {
  const auto ball = test::made<abut::Ellipsoid>({1, 0.75, 1}), needle = test::made<abut::Ellipsoid>({1e-6, 1, 1e-6});
  for (const Real aside : {1e-9, 1e-7, 1e-6, 1e-5}) {
    // Opposite to the way in which the needle was moved.
    expect_depth(ball, needle, {abut::Rotation::identity(), {aside, 0, 0}}, 1 + 1e-6 - aside, 0);
  }
}

// No model has a minimum at the top of a ridge; the descent leaves it all the same.
TEST(DepthDescent, LeavesARidge) {
  const auto cylinder = test::made<abut::Cylinder>({0.5, 3}), other = test::made<abut::Cylinder>({0.25, 2});
  const Pose ab{abut::Rotation::identity(), {1e-5, 0, 0}};
  const abut::Descent found = abut::with_difference(cylinder, other, ab, 8, [](const abut::Difference& cores) {
    return abut::descend(cores, {-1, 0, 0}, tolerance, 1e-15);
  });
  EXPECT_NEAR(overlap_along(cylinder, other, ab, {-1, 0, 0}), 0.75 + 1e-5, tolerance);
  EXPECT_NEAR(found.depth, 0.75 - 1e-5, tolerance);
}

// A plate across the axis of a cylinder overlaps least along its own axis. One degree beside it the depth is larger
// by more than the plate is thick. So the minimum is narrow, and no side of it is smooth.
TEST(DepthDescent, PlateInACylinder) {
  const auto plate = test::made<abut::Ellipsoid>({1.6e-6, 5.7e-4, 1.8e-3});
  const auto cylinder = test::made<abut::Cylinder>({1.6, 1.6});
  for (const Real aside : {0.0, 1e-7, 1e-6}) {
    const Pose ab{abut::Rotation::identity(), {aside, 4e-8, 0}};
    expect_depth(plate, cylinder, ab, 1.6 + 1.6e-6 - aside, 0);
  }
}

}  // namespace
