// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "../../random_boxes.hpp"

import abut.math;
import abut.narrow.apart.box_cores;

namespace {

using abut::Pose;
using abut::Vec3;

constexpr double error = 1e-12;

void expect_nearest(const Vec3& half_a, const Vec3& half_b, const Pose& ab, const abut::NearPoints& near) {
  const Vec3 p = abut::vec3_of(near.on_a), q = abut::vec3_of(near.on_b);
  EXPECT_TRUE(test::is_inside(half_a, p, 0));
  EXPECT_TRUE(test::is_inside(half_b, ab.undo(q), 1e-14));
  EXPECT_LE(abut::norm(abut::vec3_of(near.between) - (q - p)), 1e-14);
  const double distance = std::sqrt(near.square);
  const double overreach = test::corners_overreach(test::corners_of(half_a, Pose::identity()),
                                                   test::corners_of(half_b, ab), (1 / distance) * (q - p), distance);
  EXPECT_LE(overreach, 4 * error);
  EXPECT_NEAR(overreach, near.gap / distance, 1e-14);
}

// Of a box and another core around the origin of its own frame, at random: how many pairs are proven.
// The others are left to GJK; that must stay the exception.
template <class HalfOfB, class NearPoints>
void expect_mostly_proven(std::uint64_t seed, double least_share, HalfOfB&& half_of_b, NearPoints&& near_points) {
  test::Random random(seed);
  std::size_t proven = 0, apart = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)), half_b = half_of_b(random);
    const Pose ab{random.rotation(), random.point(3)};
    const abut::NearPoints near = near_points(half_a, half_b, ab);
    if (near.square < 1e-4) {
      continue;
    }
    ++apart;
    if (abut::is_proven(near, error)) {
      ++proven;
      expect_nearest(half_a, half_b, ab, near);
    }
  }
  EXPECT_GT(apart, 2000u);
  EXPECT_GT(static_cast<double>(proven), least_share * static_cast<double>(apart));
}

TEST(BoxCores, NearPointsOfRandomBoxesAreProvenByTheirCorners) {
  expect_mostly_proven(
      11, 0.95, [](test::Random& random) { return abut::absolute(random.point(1)); },
      [](const Vec3& a, const Vec3& b, const Pose& ab) { return abut::near_points_of_boxes(a, b, ab, error, 0); });
}

TEST(BoxCores, NearPointsOfBoxAndSegmentAreProvenByTheirCorners) {
  expect_mostly_proven(
      12, 0.99, [](test::Random& random) { return Vec3{0, 0, random.uniform(0, 2)}; },
      [](const Vec3& box, const Vec3& rod, const Pose& ab) {
        return abut::near_points_of_segment(box, abut::lanes_of(ab.position), abut::lanes_of(ab.rotation.z), rod.z,
                                            error);
      });
}

TEST(BoxCores, ParallelFaces) {
  const Pose above{abut::Rotation::identity(), {0.5, 0.25, 3}};
  const abut::NearPoints near = abut::near_points_of_boxes({1, 1, 1}, {1, 1, 1}, above, error, 0);
  EXPECT_TRUE(abut::is_proven(near, error));
  EXPECT_EQ(near.square, 1);
  EXPECT_EQ(near.rounds, 1u);
}

TEST(BoxCores, PointsAndFlatBoxes) {
  const Pose apart{abut::Rotation::identity(), {2, 3, 6}};
  EXPECT_EQ(abut::near_points_of_boxes({0, 0, 0}, {0, 0, 0}, apart, error, 0).square, 49);
  EXPECT_EQ(abut::near_points_of_boxes({2, 0, 0}, {0, 3, 0}, apart, error, 0).square, 36);
  const abut::NearPoints point =
      abut::near_points_of_segment({2, 3, 1}, abut::lanes_of({0, 0, 5}), abut::lanes_of({0, 0, 1}), 0, error);
  EXPECT_EQ(point.square, 16);
  EXPECT_EQ(point.gap, 0);
}

TEST(BoxCores, OverlapIsDistanceZero) {
  const Pose inside{abut::Rotation::identity(), {0.1, -0.2, 0.3}};
  EXPECT_EQ(abut::near_points_of_boxes({1, 1, 1}, {0.5, 0.5, 0.5}, inside, error, 0).square, 0);
  const abut::NearPoints through =
      abut::near_points_of_segment({1, 1, 1}, abut::lanes_of({0.5, 0, 4}), abut::lanes_of({0, 0, 1}), 10, error);
  EXPECT_EQ(through.square, 0);
}

// Boxes that all but touch; who only asks for points further apart does not wait for the nearest.
TEST(BoxCores, NearerThanOfUseEndsAtOnce) {
  test::Random random(13);
  constexpr double gap = 1e-9, least = 1e-5;
  int spared = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = abut::absolute(random.point(1)), b = abut::absolute(random.point(1));
    Pose ab{random.rotation(), 8 * *abut::UnitVec3::make(random.point(1))};
    for (int step = 0; step < 4; ++step) {
      const abut::NearPoints apart = abut::near_points_of_boxes(a, b, ab, error, 0);
      ab.position += -(1 - gap / std::sqrt(apart.square)) * abut::vec3_of(apart.between);
    }
    const abut::NearPoints all = abut::near_points_of_boxes(a, b, ab, error, 0),
                           few = abut::near_points_of_boxes(a, b, ab, error, least);
    EXPECT_LE(few.rounds, all.rounds);
    EXPECT_LE(all.square, few.square * (1 + 1e-9));
    EXPECT_TRUE(few.rounds == all.rounds || few.square < least * least) << i;
    spared += few.rounds < all.rounds ? 1 : 0;
  }
  EXPECT_GT(spared, 100);
}

// Edges so nearly parallel that each step of the projections is all but as long as the one before.
TEST(BoxCores, NearlyParallelEdges) {
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const abut::Rotation turned = abut::Rotation::from({std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
    const abut::Rotation on_edge = abut::Rotation::from({std::cos(0.4), std::sin(0.4), 0, 0});
    const Pose ab{turned * on_edge, {0.3, 0, 4}};
    const abut::NearPoints near = abut::near_points_of_boxes({5, 1, 1}, {5, 1, 1}, ab, error, 0);
    if (abut::is_proven(near, error)) {
      expect_nearest({5, 1, 1}, {5, 1, 1}, ab, near);
    }
    EXPECT_TRUE(std::isfinite(near.square)) << angle;
  }
}

}  // namespace
