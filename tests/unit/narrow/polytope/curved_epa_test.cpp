// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.convex.separation;
import abut.narrow.cores.difference;
import abut.narrow.polytope.epa;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.ellipsoid;

namespace {

using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr Real error = 1e-9;

template <class A, class B>
abut::EpaResult depth_of(const A& a, const B& b, const Pose& ab) {
  const abut::GjkResult start = abut::gjk(a, b, ab, ab.position, 8, error, abut::infinity);
  EXPECT_TRUE(start.overlap);
  return abut::with_difference(a, b, ab, 8,
                               [&](const abut::Difference& cores) { return abut::epa(cores, error, start.simplex); });
}

template <class A, class B>
Real overlap_along(const A& a, const B& b, const Pose& ab, const Vec3& n) {
  return dot(n, a.support(n).point - ab * b.support(ab.rotation.undo(-n)).point);
}

// Even directions all over the sphere (Saff, Kuijlaars, "Distributing many points on a sphere", 1997).
template <class A, class B>
Real least_overlap(const A& a, const B& b, const Pose& ab, int count) {
  const Real golden = std::numbers::pi * (3 - std::sqrt(Real{5}));
  Real least = abut::infinity;
  for (int i = 0; i < count; ++i) {
    const Real z = 1 - (2 * i + 1) / Real(count), side = std::sqrt(1 - z * z);
    least = std::min(least, overlap_along(a, b, ab, {side * std::cos(golden * i), side * std::sin(golden * i), z}));
  }
  return least;
}

template <class A, class B>
void check_random(const A& a, const B& b, std::uint64_t seed) {
  test::Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const Pose ab{random.rotation(), random.point(0.4)};
    const abut::EpaResult found = depth_of(a, b, ab);
    EXPECT_LE(found.upper - found.lower, 2 * error) << i;
    EXPECT_NEAR(found.depth, overlap_along(a, b, ab, found.normal), error) << i;
    EXPECT_LE(found.depth, least_overlap(a, b, ab, 4000) + error) << i;
  }
}

TEST(CurvedEpa, NoDirectionHasLess) {
  check_random(test::made<abut::Cylinder>({0.5, 0.7}), test::made<abut::Cylinder>({0.4, 0.9}), 71);
  check_random(test::made<abut::Cylinder>({0.5, 0.7}), test::made<abut::Ellipsoid>({0.4, 0.6, 0.9}), 72);
  check_random(test::made<abut::Ellipsoid>({0.5, 0.7, 0.8}), test::made<abut::Ellipsoid>({0.4, 0.6, 0.9}), 73);
}

template <class A, class B>
abut::CoreSeparation separation_around_one_axis(const A& a, const B& b, Real up) {
  const Pose ab{abut::Rotation::identity(), {0, 0, up}};
  return abut::separate_cores(a, b, ab, abut::QuerySettings{}, abut::infinity);
}

// All directions around the axis are as good, which no polytope proves.
TEST(CurvedEpa, CylindersAroundOneAxis) {
  const abut::CoreSeparation found =
      separation_around_one_axis(test::made<abut::Cylinder>({0.5, 1}), test::made<abut::Cylinder>({0.25, 2}), 0);
  EXPECT_NEAR(-found.distance, 0.75, error);
  EXPECT_LE(found.upper - found.lower, error);
  EXPECT_NEAR(found.normal.z, 0, error);
}

// Along the normal of the side of the cone the base of the same cone is below, and its side above: both slants add up
// to 2 r h / sqrt(4 h^2 + r^2), half heights being h.
TEST(CurvedEpa, ConesThatCoincide) {
  const auto cone = test::made<abut::Cone>({0.5, 1});
  const abut::CoreSeparation found = separation_around_one_axis(cone, cone, 0);
  EXPECT_NEAR(-found.distance, 2 * 2 * 0.5 * 1 / std::sqrt(4 + 0.25), error);
  EXPECT_LE(found.upper - found.lower, error);
  EXPECT_NEAR(norm(found.point_b - found.point_a), -found.distance, error);
}

// The cone stands on top of the cylinder's middle. Its side is normal to (2 h, r), and the upper rim of the cylinder
// supports there.
TEST(CurvedEpa, ConeInACylinder) {
  const Real radius = 0.5, half_height = 1, up = 0.2, slant = std::hypot(2 * half_height, radius);
  const auto cone = test::made<abut::Cone>({radius, half_height});
  const auto cylinder = test::made<abut::Cylinder>({0.25, 0.5});
  const Vec3 n{2 * half_height / slant, 0, radius / slant};
  const abut::CoreSeparation found = separation_around_one_axis(cone, cylinder, up);
  const Real apex = n.z * half_height, rim = n.x * 0.25 + n.z * 0.5 - n.z * up;
  EXPECT_NEAR(-found.distance, apex + rim, error);
  EXPECT_LE(found.upper - found.lower, error);
  EXPECT_NEAR(norm(found.point_b - found.point_a), -found.distance, error);
}

}  // namespace
