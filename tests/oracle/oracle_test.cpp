// SPDX-License-Identifier: Apache-2.0
// The oracle against closed forms and against independent reference values.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "distance.hpp"
#include "known_failures.hpp"

namespace {

using oracle::Answer;
using oracle::Body;
using oracle::make_box;
using oracle::make_capsule;
using oracle::make_hull;
using oracle::make_sphere;
using oracle::measured;
using oracle::Pose;
using oracle::quad;
using oracle::Quad;
using oracle::Vec;

Pose at(double x, double y, double z) { return Pose::from({x, y, z}, {1, 0, 0, 0}); }

Answer distance(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b) {
  return oracle::signed_distance(measured(a), pose_a, measured(b), pose_b);
}

double apart(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b) {
  return static_cast<double>(distance(a, pose_a, b, pose_b).distance);
}

TEST(Quad, SquareRootIsGoodTo113Bits) {
  for (const Quad value : {quad(2), quad(1e-300) * quad(1e-300), quad(1e300) * quad(1e10), quad(0.3)}) {
    const Quad root = oracle::square_root(value);
    EXPECT_LT(static_cast<double>(oracle::absolute(root * root - value) / value), 1e-33);
  }
  EXPECT_EQ(static_cast<double>(oracle::square_root(0)), 0.0);
}

TEST(Oracle, SpheresAreCentreDistanceMinusRadii) {
  EXPECT_EQ(apart(make_sphere(1), at(0, 0, 0), make_sphere(2), at(3, 4, 0)), 2.0);
  EXPECT_EQ(apart(make_sphere(3), at(0, 0, 0), make_sphere(4), at(3, 4, 0)), -2.0);
  EXPECT_EQ(apart(make_sphere(3), at(1, 1, 1), make_sphere(4), at(1, 1, 1)), -7.0);
}

TEST(Oracle, WitnessesOfSpheresLieOnTheLineOfCentres) {
  const Answer answer = distance(make_sphere(1), at(0, 0, 0), make_sphere(2), at(10, 0, 0));
  ASSERT_TRUE(answer.witness);
  EXPECT_EQ(static_cast<double>(answer.witness->a.x), 1.0);
  EXPECT_EQ(static_cast<double>(answer.witness->b.x), 8.0);
  EXPECT_EQ(static_cast<double>(answer.normal.x), 1.0);
}

TEST(Oracle, AlignedBoxesAreApartByTheCornerDistance) {
  EXPECT_EQ(apart(make_box(1, 1, 1), at(0, 0, 0), make_box(1, 1, 1), at(5, 0, 0)), 3.0);
  EXPECT_EQ(apart(make_box(1, 1, 1), at(0, 0, 0), make_box(1, 1, 1), at(5, 6, 0)), 5.0);
  EXPECT_EQ(apart(make_box(1, 1, 1), at(0, 0, 0), make_box(1, 1, 1), at(3, 4, 4)), 3.0);
}

TEST(Oracle, AlignedBoxesOverlapByTheLeastAxis) {
  EXPECT_EQ(apart(make_box(1, 1, 1), at(0, 0, 0), make_box(1, 1, 1), at(1.5, 0.25, 0)), -0.5);
  EXPECT_EQ(apart(make_box(1, 2, 3), at(0, 0, 0), make_box(1, 2, 3), at(0, 0, 0)), -2.0);
}

// Edges along y of the lower and along x of the upper box face each other.
Pose quarter_about(int axis, double x, double y, double z) {
  const double half = std::numbers::pi / 8;
  std::array<double, 4> q{std::cos(half), 0, 0, 0};
  q.at(static_cast<std::size_t>(axis)) = std::sin(half);
  return Pose::from({x, y, z}, q);
}

TEST(Oracle, RotatedBoxesMeetEdgeToEdge) {
  const double diagonal = std::numbers::sqrt2;
  for (const double gap : {1.0, 1e-6, 0.0, -1e-3, -0.25}) {
    const double between = apart(make_box(1, 1, 1), quarter_about(2, 0, 0, 0), make_box(1, 1, 1),
                                 quarter_about(1, 0, 2 * diagonal + gap, 0));
    // The second box rests flat in y; only the first stands on its edge.
    EXPECT_NEAR(between, gap + diagonal - 1, 1e-15);
    const double edges = apart(make_box(1, 1, 1), quarter_about(2, 0, 0, 0), make_box(1, 1, 1),
                               quarter_about(1, 0, 0, 2 * diagonal + gap));
    EXPECT_NEAR(edges, gap, 1e-15);
  }
}

TEST(Oracle, SphereInsideBoxIsAsDeepAsTheNearestFace) {
  EXPECT_EQ(apart(make_box(1, 2, 3), at(0, 0, 0), make_sphere(0.25), at(0.5, 0, 0)), -0.75);
  EXPECT_EQ(apart(make_sphere(0.25), at(0, 0, 0), make_box(1, 2, 3), at(0, 0, 0)), -1.25);
}

TEST(Oracle, CapsulesMeetAcrossTheirAxes) {
  const Pose lying = Pose::from({0, 0.5, 0}, {1, 0, 1, 0});
  EXPECT_EQ(apart(make_capsule(0.25, 2), at(0, 0, 0), make_capsule(0.125, 2), lying), 0.125);
  EXPECT_EQ(apart(make_capsule(0.25, 2), at(0, 0, 0), make_capsule(0.125, 2), at(0, 0, 1)), -0.375);
  EXPECT_EQ(apart(make_capsule(0.25, 2), at(0, 0, 0), make_capsule(0.125, 2), at(0, 0, 6)), 1.625);
}

TEST(Oracle, FlatCoresInOnePlaneHaveNoDepth) {
  const Body triangle = make_hull({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  EXPECT_EQ(apart(triangle, at(0, 0, 0), triangle, at(1, 1, 0)), 0.0);
  EXPECT_EQ(apart(triangle, at(0, 0, 0), triangle, at(10, 0, 0)), 6.0);
  EXPECT_EQ(apart(make_hull({{1, 1, 0}}), at(0, 0, 0), triangle, at(0, 0, 0)), 0.0);
  EXPECT_EQ(apart(make_hull({{1, 1, 0}}), at(0, 0, 0), make_hull({{1, 1, 0}}), at(0, 0, 0)), 0.0);
  EXPECT_EQ(apart(make_hull({{0, 0, 0}, {1, 0, 0}}), at(0, 0, 0), make_hull({{0.5, 0, 0}, {3, 0, 0}}), at(0, 0, 0)),
            0.0);
  EXPECT_EQ(apart(make_hull({{0, 0, 0}, {1, 0, 0}}), at(0, 0, 0), make_hull({{2, 0, 0}, {3, 0, 0}}), at(0, 0, 0)), 1.0);
}

TEST(Oracle, SegmentThroughTriangleIsAsDeepAsTheLeastWayOut) {
  const Body triangle = make_hull({{-8, -8, 0}, {8, -8, 0}, {0, 8, 0}});
  EXPECT_EQ(apart(triangle, at(0, 0, 0), make_hull({{0, 0, -1}, {0, 0, 0.5}}), at(0, 0, 0)), -0.5);
  const Body needle = make_hull({{0, 0, -100}, {0, 0, 100}});
  EXPECT_NEAR(apart(triangle, at(0, -7, 0), needle, at(0, 0, 0)), -1 / std::sqrt(5.0), 1e-15);
}

TEST(Oracle, HalfSpaceMeasuresTheLowestPoint) {
  const auto ground = measured(oracle::HalfSpace{{0, 0, 2}, 1});
  const Answer answer = oracle::signed_distance(ground, at(0, 0, 1), measured(make_sphere(0.5)), at(3, 4, 2.25));
  EXPECT_EQ(static_cast<double>(answer.distance), -0.25);
  EXPECT_EQ(static_cast<double>(answer.normal.z), 1.0);
  const Answer back = oracle::signed_distance(measured(make_sphere(0.5)), at(3, 4, 2.25), ground, at(0, 0, 1));
  EXPECT_EQ(static_cast<double>(back.distance), -0.25);
  EXPECT_EQ(static_cast<double>(back.normal.z), -1.0);
}

TEST(Oracle, SoupIsAsFarAsItsNearestTriangle) {
  const oracle::Soup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}},
                          {{{0, 1, 2}}, {{3, 4, 5}}}};
  const Answer answer =
      oracle::signed_distance(measured(soup), at(0, 0, 0), measured(make_sphere(1)), at(5.25, 5.25, 8));
  EXPECT_EQ(static_cast<double>(answer.distance), 2.0);
}

// The separation along any direction is a lower bound of the signed distance, and along the normal it is reached.
TEST(Oracle, DistanceIsTheLargestSeparationOverAllDirections) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 60; ++round) {
    std::vector<oracle::Point> points;
    for (int i = 0; i < 10; ++i) points.push_back({uniform(random), uniform(random), uniform(random)});
    const auto a = measured(make_hull(points));
    const auto b = measured(make_box(0.5, 0.3, 0.2));
    const double reach = round % 2 == 0 ? 0.8 : 2.5;
    const Pose pose_a = Pose::from({0, 0, 0}, {1, uniform(random), uniform(random), uniform(random)});
    const Pose pose_b = Pose::from({reach * uniform(random), reach * uniform(random), reach * uniform(random)},
                                   {1, uniform(random), uniform(random), uniform(random)});
    const Answer answer = oracle::signed_distance(a, pose_a, b, pose_b);
    const Quad reached = oracle::separation_along(a, pose_a, b, pose_b, answer.normal);
    EXPECT_LT(static_cast<double>(oracle::absolute(reached - answer.distance)), 1e-28);
    for (int i = 0; i < 300; ++i) {
      Vec direction{quad(uniform(random)), quad(uniform(random)), quad(uniform(random))};
      if (i % 2 == 0) direction = answer.normal + direction * quad(1e-3);
      const Quad separation = oracle::separation_along(a, pose_a, b, pose_b, oracle::unit(direction));
      EXPECT_LE(static_cast<double>(separation - answer.distance), 1e-28);
    }
  }
}

// Coordinates with few bits, so that differences of points are exact; `flat` levels many of them to nearly one plane.
std::vector<oracle::Point> coarse_points(std::mt19937_64& random, int count, bool flat) {
  const auto step = [&random](double unit) { return unit * (static_cast<double>(random() % 17) - 8); };
  std::vector<oracle::Point> points;
  for (int i = 0; i < count; ++i) {
    points.push_back({step(0.125), step(0.125), flat && i > 0 ? step(0x1p-20) : step(0.125)});
  }
  return points;
}

// The signed distance of two bodies is that of the origin to the hull of all differences of their points. That takes
// another way through the code: vertices against faces only.
TEST(Oracle, DistanceIsThatOfTheOriginToTheMinkowskiDifference) {
  std::mt19937_64 random(5);
  int overlapping = 0;
  for (int round = 0; round < 80; ++round) {
    const auto a = coarse_points(random, 5, round % 3 == 1);
    const auto b = coarse_points(random, 4, round % 3 != 0);
    const oracle::Point offset{0.125 * static_cast<double>(round % 11), 0, 0.0625 * static_cast<double>(round % 5)};
    std::vector<oracle::Point> differences;
    for (const auto& p : a) {
      for (const auto& q : b) {
        differences.push_back({p[0] - q[0] - offset[0], p[1] - q[1] - offset[1], p[2] - q[2] - offset[2]});
      }
    }
    const Answer direct = distance(make_hull(a), at(0, 0, 0), make_hull(b), at(offset[0], offset[1], offset[2]));
    const Answer other = distance(make_hull(differences), at(0, 0, 0), make_sphere(0), at(0, 0, 0));
    EXPECT_LT(static_cast<double>(oracle::absolute(direct.distance - other.distance)), 1e-28)
        << "round " << round << ": " << static_cast<double>(direct.distance) << " against "
        << static_cast<double>(other.distance);
    overlapping += direct.distance < 0 ? 1 : 0;
  }
  EXPECT_GT(overlapping, 20);
  EXPECT_LT(overlapping, 60);
}

TEST(Oracle, AgreesWithTheReferencesOfKnownFailures) {
  const auto rows = oracle::read_known_failures(ABUT_TEST_DATA "/known_failures.jsonl");
  std::size_t asked = 0;
  for (const auto& row : rows) {
    const auto a = row.a ? oracle::solid_of(*row.a) : std::nullopt;
    const auto b = row.b ? oracle::solid_of(*row.b) : std::nullopt;
    if (!row.distance || !a || !b) continue;
    const auto* rounded_a = std::get_if<oracle::Rounded>(&a->form);
    const auto* rounded_b = std::get_if<oracle::Rounded>(&b->form);
    if (rounded_a == nullptr || rounded_b == nullptr) continue;
    ++asked;
    const Answer answer =
        distance(rounded_a->body, oracle::pose_of(row.pose_a), rounded_b->body, oracle::pose_of(row.pose_b));
    const double error = static_cast<double>(oracle::absolute(answer.distance - *row.distance));
    EXPECT_LT(error, 1e-20 * (a->size + b->size + static_cast<double>(oracle::absolute(*row.distance))))
        << row.id << " oracle " << static_cast<double>(answer.distance) << " reference "
        << static_cast<double>(*row.distance);
  }
  EXPECT_EQ(asked, 58u);
}

}  // namespace
