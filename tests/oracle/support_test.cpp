// SPDX-License-Identifier: Apache-2.0
// Support functions, distances of points and least overlaps of solids against values worked out by hand.
#include "support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "sweep.hpp"

namespace {

using oracle::Box;
using oracle::Cone;
using oracle::Cylinder;
using oracle::Ellipsoid;
using oracle::make_capsule;
using oracle::make_hull;
using oracle::make_sphere;
using oracle::Point;
using oracle::Pose;
using oracle::quad;
using oracle::Quad;
using oracle::Solid;
using oracle::solid_of;
using oracle::Vec;

Vec vec(double x, double y, double z) { return {quad(x), quad(y), quad(z)}; }

void expect_near(Quad got, Quad expected, double tolerance) {
  EXPECT_LE(static_cast<double>(oracle::absolute(got - expected)), tolerance)
      << static_cast<double>(got) << " against " << static_cast<double>(expected);
}

// Good to the last digits of 113 bits.
void expect_equal(Quad got, Quad expected) { expect_near(got, expected, 1e-31); }

std::vector<Solid> one_of_each() {
  return {solid_of(make_hull({{0, 0, 0}})),
          solid_of(make_hull({{0, 0, -1}, {0, 0, 1}})),
          solid_of(make_hull({{1, 0, 0}, {0, 2, 0}, {0, 0, 3}})),
          solid_of(make_sphere(0.5)),
          solid_of(make_capsule(0.25, 1)),
          solid_of(make_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})),
          solid_of(Box{{1, 2, 3}}),
          solid_of(Cylinder{0.5, 1}),
          solid_of(Cylinder{0, 1}),
          solid_of(Cylinder{1, 0}),
          solid_of(Cone{0.5, 1}),
          solid_of(Cone{0, 1}),
          solid_of(Cone{1, 0}),
          solid_of(Ellipsoid{{1, 0.5, 0.25}}),
          solid_of(Ellipsoid{{1e-6, 1e-6, 1}}),
          solid_of(Ellipsoid{{1, 0.5, 0}}),
          solid_of(Ellipsoid{{0, 0, 1}}),
          solid_of(Ellipsoid{{0, 0, 0}})};
}

TEST(Support, HasTheHeightsWorkedOutByHand) {
  const Vec n = vec(2, 3, 6);  // of length 7
  expect_equal(support(solid_of(make_hull({{0, 0, 0}})), n), 0);
  expect_equal(support(solid_of(make_hull({{0, 0, -1.5}, {0, 0, 1.5}})), n), 9);
  expect_equal(support(solid_of(make_hull({{1, 0, 0}, {0, 2, 0}, {-1, -1, -1}})), n), 6);
  expect_equal(support(solid_of(make_sphere(0.5)), n), quad(3.5));
  expect_equal(support(solid_of(make_capsule(0.5, 2)), n), quad(15.5));
  expect_equal(support(solid_of(Box{{1, 2, 3}}), -n), 26);
  const Vec m = vec(3, -4, -12);  // 5 across the axis
  expect_equal(support(solid_of(Cylinder{2, 0.5}), m), 16);
  expect_equal(support(solid_of(Cone{2, 0.5}), m), 16);
  expect_equal(support(solid_of(Cone{2, 0.5}), vec(3, 4, 12)), 6);
  expect_equal(support(solid_of(Cone{2, 0.5}), vec(3, 4, 2)), 9);
  expect_equal(support(solid_of(Ellipsoid{{1, 1.5, 0.5}}), vec(2, 4, 6)), 7);
  expect_equal(support(solid_of(Ellipsoid{{0, 0, 0.5}}), m), 6);
}

TEST(Support, GrowsWithTheLengthOfTheDirection) {
  for (const Solid& solid : one_of_each()) {
    expect_equal(support(solid, vec(3, -1, 2)), 4 * support(solid, vec(0.75, -0.25, 0.5)));
    expect_equal(support(solid, vec(0, 0, 0)), 0);
  }
}

TEST(Support, IsTheSameInBothNumberTypes) {
  for (const Solid& solid : one_of_each()) {
    EXPECT_NEAR(support(solid, Point{0.5, -0.25, 0.75}), static_cast<double>(support(solid, vec(0.5, -0.25, 0.75))),
                1e-15);
  }
}

TEST(Support, IsReachedByAPointOfTheSolid) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Solid& solid : one_of_each()) {
    for (int i = 0; i < 40; ++i) {
      const Vec n = oracle::unit(vec(uniform(random), uniform(random), uniform(random)));
      const Vec furthest = support_point(solid, n);
      expect_equal(dot(furthest, n), support(solid, n));
      expect_equal(distance_to_solid(solid, furthest), 0);
      EXPECT_LE(static_cast<double>(oracle::length(furthest)), solid.size * (1 + 1e-15));
    }
  }
}

TEST(Support, PointIsTheMiddleOfItsFaceOrEdge) {
  const auto expect_at = [](const Vec& got, const Vec& expected) { expect_equal(length(got - expected), 0); };
  expect_at(support_point(solid_of(Box{{1, 2, 3}}), vec(0, 2, 0)), vec(0, 2, 0));
  expect_at(support_point(solid_of(Cylinder{1, 2}), vec(0, 0, -1)), vec(0, 0, -2));
  expect_at(support_point(solid_of(Cylinder{1, 2}), vec(0, 3, 0)), vec(0, 1, 0));
  expect_at(support_point(solid_of(Cylinder{1, 2}), vec(1e-9, 0, 1), quad(1e-8)), vec(0, 0, 2));
  expect_at(support_point(solid_of(Cone{1, 2}), vec(0, 0, -1)), vec(0, 0, -2));
  expect_at(support_point(solid_of(Cone{1, 2}), vec(4, 0, 1)), vec(0.5, 0, 0));
  expect_at(support_point(solid_of(make_hull({{0, 0, 0}, {1, 0, 0}, {0, 0, -1}})), vec(0, 0, 1)), vec(0.5, 0, 0));
}

// No point of the solid is higher along n than the support: what is, is at least so far away.
TEST(Support, BoundsDistancesFromBelow) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-4, 4);
  for (const Solid& solid : one_of_each()) {
    for (int i = 0; i < 60; ++i) {
      const Vec p = vec(uniform(random), uniform(random), uniform(random));
      const Vec n = oracle::unit(vec(uniform(random), uniform(random), uniform(random)));
      EXPECT_LE(static_cast<double>(dot(p, n) - support(solid, n) - distance_to_solid(solid, p)), 1e-30);
    }
  }
}

// Out along the normal from a point of the surface, the distance is the way gone.
TEST(PointDistance, GrowsAlongTheNormal) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Solid& solid : one_of_each()) {
    for (int i = 0; i < 60; ++i) {
      const Vec n = oracle::unit(vec(uniform(random), uniform(random), uniform(random)));
      const double away = std::pow(10, 6 * uniform(random));
      const Vec point = support_point(solid, n) + n * quad(away);
      expect_near(distance_to_solid(solid, point), quad(away), 1e-29 * (1 + away));
    }
  }
}

TEST(PointDistance, HasTheValuesWorkedOutByHand) {
  expect_equal(distance_to_solid(solid_of(make_hull({{0, 0, 0}})), vec(2, 3, -6)), 7);
  expect_equal(distance_to_solid(solid_of(make_hull({{0, 0, -1}, {0, 0, 1}})), vec(3, 0, 5)), 5);
  expect_equal(distance_to_solid(solid_of(make_hull({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}})), vec(1, 1, -2)), 2);
  expect_equal(distance_to_solid(solid_of(make_hull({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}})), vec(2, -3, 4)), 5);
  expect_equal(distance_to_solid(solid_of(make_sphere(2)), vec(3, 4, 0)), 3);
  expect_equal(distance_to_solid(solid_of(make_capsule(1, 2)), vec(3, 0, 6)), 4);
  expect_equal(distance_to_solid(solid_of(Box{{1, 2, 3}}), vec(-3, 5, 9)), 7);
  expect_equal(distance_to_solid(solid_of(Cylinder{5, 1}), vec(6, 8, 13)), 13);
  expect_equal(distance_to_solid(solid_of(Cylinder{5, 1}), vec(3, 4, 3)), 2);
  const Solid cone = solid_of(Cone{6, 4});  // its slope falls 8 on 6
  expect_equal(distance_to_solid(cone, vec(0, 0, 7)), 3);
  expect_equal(distance_to_solid(cone, vec(3, 4, -9)), 5);
  expect_equal(distance_to_solid(cone, vec(9, 0, -8)), 5);
  expect_equal(distance_to_solid(cone, vec(0, 7, 3)), 5);  // at a right angle to the middle of the slope
}

TEST(PointDistance, OfEllipsoidsAgreesWithSpheresAndAxes) {
  expect_equal(distance_to_solid(solid_of(Ellipsoid{{2, 2, 2}}), vec(2, 3, 6)), 5);
  const Solid solid = solid_of(Ellipsoid{{3, 2, 1}});
  expect_equal(distance_to_solid(solid, vec(5, 0, 0)), 2);
  expect_equal(distance_to_solid(solid, vec(0, 5, 0)), 3);
  expect_equal(distance_to_solid(solid, vec(0, 0, -5)), 4);
  expect_equal(distance_to_solid(solid_of(Ellipsoid{{3, 3, 0}}), vec(0, 6, -4)), 5);
  expect_equal(distance_to_solid(solid_of(Ellipsoid{{3, 3, 0}}), vec(0, 1, -4)), 4);
  expect_equal(distance_to_solid(solid_of(Ellipsoid{{0, 0, 2}}), vec(3, 0, 6)), 5);
  expect_equal(distance_to_solid(solid_of(Ellipsoid{{0, 0, 0}}), vec(2, 3, 6)), 7);
}

TEST(PointDistance, IsZeroInside) {
  expect_equal(
      distance_to_solid(solid_of(make_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})), vec(0.25, 0.25, 0.25)), 0);
  expect_equal(distance_to_solid(solid_of(Box{{1, 2, 3}}), vec(1, -2, 3)), 0);
  expect_equal(distance_to_solid(solid_of(Cylinder{5, 1}), vec(3, 4, 1)), 0);
  expect_equal(distance_to_solid(solid_of(Cone{6, 4}), vec(3, 0, 0)), 0);
  expect_equal(distance_to_solid(solid_of(Cone{6, 4}), vec(0, 6, -4)), 0);
  expect_equal(distance_to_solid(solid_of(Cone{6, 0}), vec(0, 6, 0)), 0);
  expect_equal(distance_to_solid(solid_of(Cone{6, 0}), vec(0, 7, 0)), 1);
  expect_equal(distance_to_solid(solid_of(Ellipsoid{{3, 2, 1}}), vec(1, 1, 0.5)), 0);
}

Pose at(double x, double y, double z) { return Pose::from({x, y, z}, {1, 0, 0, 0}); }
Pose turned(const Point& position, const std::array<double, 4>& wxyz) { return Pose::from(position, wxyz); }

TEST(Overlap, CountsThePlaces) {
  const Solid ball = solid_of(make_sphere(1));
  const Solid cylinder = solid_of(Cylinder{1, 2});
  expect_equal(overlap_along(ball, at(1, 0, 0), cylinder, at(6, 0, 0), vec(1, 0, 0)), -3);
  expect_equal(overlap_along(ball, at(0, 0, 1), cylinder, at(0, 0, 0), vec(0, 0, -1)), 2);
  expect_equal(overlap_along(ball, at(0, 0, 1), cylinder, turned({0, 5, 1}, {1, 1, 0, 0}), vec(0, 1, 0)), -2);
}

double depth(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b) {
  return static_cast<double>(least_overlap(a, pose_a, b, pose_b, vec(0.6, 0, 0.8)).overlap);
}

TEST(LeastOverlap, IsTheDepthWorkedOutByHand) {
  const Solid cylinder = solid_of(Cylinder{1, 2});
  const Solid cone = solid_of(Cone{6, 4});
  const Solid ball = solid_of(make_sphere(0.5));
  EXPECT_NEAR(depth(cylinder, at(0, 0, 0), cylinder, at(0.6, 0.8, 0.25)), 1, 1e-14);
  EXPECT_NEAR(depth(cylinder, at(0, 0, 0), cylinder, at(0, 0, 3.5)), 0.5, 1e-14);
  EXPECT_NEAR(depth(cylinder, at(0, 0, 0), cylinder, turned({0.2, 0, 1.5}, {1, 1, 0, 0})), 1.5, 1e-14);
  EXPECT_NEAR(depth(cylinder, at(0, 0, 0), ball, at(1.2, 0.9, 0)), 0, 1e-14);
  EXPECT_NEAR(depth(cone, at(0, 0, 0), ball, at(3, 0, 0)), 0.5, 1e-14);  // its centre on the slope
  EXPECT_NEAR(depth(cone, at(0, 0, 0), ball, at(0, 2, -3.75)), 0.75, 1e-14);
  EXPECT_NEAR(depth(solid_of(Ellipsoid{{3, 2, 1}}), at(0, 0, 0), ball, at(0, 0, 0)), 1.5, 1e-14);
  EXPECT_NEAR(depth(solid_of(Ellipsoid{{1, 1e-6, 1}}), at(0, 0, 0), solid_of(Ellipsoid{{1e-6, 1e-6, 1}}), at(0, 0, 0)),
              2e-6, 1e-14);
  EXPECT_NEAR(depth(solid_of(Box{{1, 2, 3}}), at(0, 0, 0), solid_of(Box{{1, 2, 3}}), at(0, 3.5, 0)), 0.5, 1e-14);
}

// Neither directions near the one found nor any others are better.
TEST(LeastOverlap, IsNotAboveNearbyDirections) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::vector<Solid> solids = one_of_each();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Pose pose_a = turned({0, 0, 0}, {1, uniform(random), uniform(random), uniform(random)});
      const Pose pose_b = turned({0.1 * uniform(random), 0, 0}, {1, uniform(random), uniform(random), uniform(random)});
      const auto least = least_overlap(solids[i], pose_a, solids[j], pose_b, vec(1, 0, 0));
      expect_equal(overlap_along(solids[i], pose_a, solids[j], pose_b, least.direction), least.overlap);
      for (int k = 0; k < 100; ++k) {
        const Vec offset = vec(uniform(random), uniform(random), uniform(random));
        const Vec n = oracle::unit(k % 2 == 0 ? offset : least.direction + offset * quad(1e-4));
        const Quad there = overlap_along(solids[i], pose_a, solids[j], pose_b, n);
        EXPECT_LE(static_cast<double>(least.overlap - there), 1e-13) << i << " " << j;
      }
    }
  }
}

}  // namespace
