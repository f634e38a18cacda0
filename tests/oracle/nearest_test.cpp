// SPDX-License-Identifier: Apache-2.0
// Distances from support points against distances from features, values worked out by hand, and known failures.
#include "nearest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "known_failures.hpp"
#include "support.hpp"
#include "sweep.hpp"

namespace {

using oracle::nearest;
using oracle::Nearest;
using oracle::Point;
using oracle::Pose;
using oracle::quad;
using oracle::Quad;
using oracle::Solid;
using oracle::solid_of;

Pose at(double x, double y, double z) { return Pose::from({x, y, z}, {1, 0, 0, 0}); }

// Good to the last digits of 113 bits, from below and from above.
void expect_proved(const Nearest& got, Quad expected, double tolerance) {
  EXPECT_TRUE(got.is_known);
  EXPECT_LE(static_cast<double>(got.lower - expected), tolerance);
  EXPECT_LE(static_cast<double>(expected - got.upper), tolerance);
  EXPECT_LE(static_cast<double>(got.upper - got.lower), tolerance);
}

TEST(Nearest, AgreesWithFeatures) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int apart = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Point> a;
    std::vector<Point> b;
    const double thin = round % 3 == 0 ? 1e-6 : 1;
    for (int i = 0; i < 8; ++i) {
      a.push_back({uniform(random), uniform(random), uniform(random)});
      b.push_back({uniform(random), thin * uniform(random), thin * uniform(random)});
    }
    const Pose turned = Pose::from({2 * uniform(random), 2 * uniform(random), 2 * uniform(random)},
                                   {uniform(random), uniform(random), uniform(random), uniform(random)});
    const oracle::Answer exact = oracle::signed_distance(oracle::measured(oracle::make_hull(a)), at(0, 0, 0),
                                                         oracle::measured(oracle::make_hull(b)), turned);
    const Nearest got = nearest(solid_of(oracle::make_hull(a)), at(0, 0, 0), solid_of(oracle::make_hull(b)), turned);
    EXPECT_EQ(got.is_known, exact.distance > 0) << "round " << round;
    if (got.is_known) expect_proved(got, exact.distance, 1e-22);
    apart += got.is_known ? 1 : 0;
  }
  EXPECT_GT(apart, 15);
  EXPECT_LT(apart, 55);
}

TEST(Nearest, HasTheValuesWorkedOutByHand) {
  const Solid ball = solid_of(oracle::Ellipsoid{{0.5, 0.5, 0.5}});
  const Solid egg = solid_of(oracle::Ellipsoid{{0.5, 1, 2}});
  const Solid cylinder = solid_of(oracle::Cylinder{0.5, 1});
  const Solid cone = solid_of(oracle::Cone{0.5, 1});
  const Solid sphere = solid_of(oracle::make_sphere(0.5));
  expect_proved(nearest(ball, at(0, 0, 0), ball, at(3, 4, 12)), 12, 1e-20);
  expect_proved(nearest(ball, at(0, 0, 0), sphere, at(3, 4, 12)), 12, 1e-20);
  expect_proved(nearest(egg, at(0, 0, 0), cylinder, at(0, 0, 3.25)), quad(0.25), 1e-20);
  expect_proved(nearest(cylinder, at(0, 0, 0), cylinder, at(3, 4, 0.5)), 4, 1e-20);
  expect_proved(nearest(cone, at(0, 0, 0), cone, at(0, 0, 2.5)), quad(0.5), 1e-20);
  // The rims face each other: 3 to the side, 4 up.
  expect_proved(nearest(cylinder, at(0, 0, 0), cone, at(4, 0, 6)), 5, 1e-20);
}

TEST(Nearest, SubtractsRadiiAlsoWhereTheyOverlap) {
  const Solid sphere = solid_of(oracle::make_sphere(0.5));
  expect_proved(nearest(sphere, at(0, 0, 0), solid_of(oracle::Cylinder{0.5, 1}), at(0, 0, 1.25)), quad(-0.25), 1e-20);
}

TEST(Nearest, KnowsNothingWhereCoresMeet) {
  const Solid cylinder = solid_of(oracle::Cylinder{0.5, 1});
  EXPECT_FALSE(nearest(cylinder, at(0, 0, 0), cylinder, at(0, 0, 0)).is_known);
  EXPECT_FALSE(nearest(cylinder, at(0, 0, 0), cylinder, at(0, 0, 2)).is_known);
  EXPECT_FALSE(nearest(cylinder, at(0, 0, 0), solid_of(oracle::Cone{0.5, 1}), at(0.25, 0, 0)).is_known);
}

TEST(Nearest, MeasuresHullsOfManyPoints) {
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) points.push_back({std::cos(i), std::sin(i), i % 2 == 0 ? -0.5 : 0.5});
  const Solid hull = solid_of(oracle::make_hull(points));
  expect_proved(nearest(hull, at(0, 0, 0), solid_of(oracle::make_sphere(0.25)), at(0, 0, 1.5)), quad(0.75), 1e-20);
  EXPECT_LE(static_cast<double>(oracle::distance_to_solid(hull, {0, 0, quad(0.75)})), 0.25 + 1e-20);
  EXPECT_GE(static_cast<double>(oracle::distance_to_solid(hull, {0, 0, quad(0.75)})), 0.25 - 1e-20);
  EXPECT_EQ(static_cast<double>(oracle::distance_to_solid(hull, {0, 0, quad(0.25)})), 0);
}

// Curved shapes have references too: by the distance where cores are apart, otherwise by the depth that a search finds,
// which is never less than the true one.
TEST(Nearest, AgreesWithTheReferencesOfKnownFailures) {
  int apart = 0;
  int overlapping = 0;
  for (const auto& row : oracle::read_known_failures(ABUT_TEST_DATA "/known_failures.jsonl")) {
    if (!row.distance) continue;
    const auto a = solid_of(*row.a);
    const auto b = solid_of(*row.b);
    if (!a || !b || (row.a->type != "cylinder" && row.b->type != "cylinder" && row.b->type != "ellipsoid")) continue;
    const Pose pose_a = oracle::pose_of(row.pose_a);
    const Pose pose_b = oracle::pose_of(row.pose_b);
    const Nearest got = nearest(*a, pose_a, *b, pose_b);
    if (got.is_known) {
      expect_proved(got, *row.distance, 1e-20 * (a->size + b->size));
      ++apart;
    } else {
      const Quad found = oracle::least_overlap(*a, pose_a, *b, pose_b, {0, 0, 1}).overlap;
      EXPECT_NEAR(static_cast<double>(found + *row.distance), 0, 1e-15 * (a->size + b->size)) << row.id;
      ++overlapping;
    }
  }
  EXPECT_EQ(apart, 7);
  EXPECT_EQ(overlapping, 2);
}

}  // namespace
