#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "../made.hpp"
#include "random_boxes.hpp"

import abut.core;
import abut.math;
import abut.shape;
import abut.shape.cylinder;
import abut.shape.plane;
import abut.narrowphase.half_space;

namespace {

using abut::Cylinder;
using abut::Plane;
using abut::Vec3;
using test::made;

constexpr double radius = 0.5, half_height = 1;

Plane ground() { return made<Plane>({0, 0, 1, 0}); }
Cylinder can() { return made<Cylinder>({radius, half_height}); }

abut::Manifold contacts(const abut::Pose& pose, double margin) {
  abut::QuerySettings settings;
  settings.margin = margin;
  abut::Manifold points;
  EXPECT_EQ(abut::half_space_contacts(ground(), can(), pose, settings, points), abut::Outcome::ok);
  std::set<std::uint64_t> ids;
  for (const abut::ContactPoint& point : points) {
    EXPECT_TRUE(ids.insert(point.id).second) << "one id, two points";
    EXPECT_EQ(point.normal, (Vec3{0, 0, 1}));
    EXPECT_NEAR(point.point_a.z, 0, 1e-15);
    EXPECT_NEAR(point.point_b.z, point.distance, 1e-15);
    EXPECT_LE(point.distance, margin);
  }
  return points;
}

TEST(HalfSpace, StandingCylinderTouchesAtItsRim) {
  for (const bool upright : {true, false}) {
    const abut::Rotation turn = upright ? abut::Rotation::identity() : abut::Rotation{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    const abut::Manifold points = contacts({turn, {3, 4, half_height - 0.01}}, 0);
    ASSERT_EQ(points.size(), 16u);
    std::set<std::uint32_t> corners;
    for (const abut::ContactPoint& point : points) {
      EXPECT_NEAR(point.distance, -0.01, 1e-15);
      EXPECT_NEAR(std::hypot(point.point_b.x - 3, point.point_b.y - 4), radius, 1e-15);
      EXPECT_EQ(point.feature_b.kind, abut::FeatureKind::vertex);
      corners.insert(point.feature_b.index);
    }
    EXPECT_EQ(*corners.begin(), upright ? 16u : 0u);
    EXPECT_EQ(*corners.rbegin(), upright ? 31u : 15u);
  }
}

TEST(HalfSpace, LyingCylinderTouchesAtTwoPoints) {
  test::Random random(401);
  for (int i = 0; i < 200; ++i) {
    // The axis across the plane's normal, turned about both.
    const double yaw = random.uniform(0, 2 * std::numbers::pi), roll = random.uniform(0, 2 * std::numbers::pi);
    const Vec3 along{std::cos(yaw), std::sin(yaw), 0}, across{-std::sin(yaw), std::cos(yaw), 0}, up{0, 0, 1};
    const Vec3 first = std::cos(roll) * across + std::sin(roll) * up, second = std::cos(roll) * up - std::sin(roll) * across;
    const abut::Rotation turn{first, second, along};
    const abut::Manifold points = contacts({turn, {3, 4, radius - 0.01}}, 0);
    ASSERT_EQ(points.size(), 2u) << "seed 401, turn " << i;
    for (const abut::ContactPoint& point : points) {
      EXPECT_NEAR(point.distance, -0.01, 1e-15) << "seed 401, turn " << i;
      const Vec3 end = Vec3{3, 4, -0.01} + (point.feature_b.index == 32 ? -half_height : half_height) * along;
      EXPECT_LE(largest_magnitude(point.point_b - end), 4e-15) << "seed 401, turn " << i;
    }
    EXPECT_EQ(points[0].feature_b, (abut::Feature{abut::FeatureKind::vertex, 32}));
    EXPECT_EQ(points[1].feature_b, (abut::Feature{abut::FeatureKind::vertex, 33}));
  }
}

// The lowest point of a rim lies somewhere between two of its corners.
TEST(HalfSpace, TiltedCylinderTouchesAtItsLowestPoint) {
  test::Random random(402);
  int between = 0;
  for (int i = 0; i < 2000; ++i) {
    const abut::Pose pose{random.rotation(), random.point(1) + Vec3{0, 0, 1}};
    const Vec3 axis = pose.rotation.z, upwards = (axis.z > 0 ? 1 : -1) * axis;
    // The part of the normal across the axis.
    const Vec3 level{-upwards.z * upwards.x, -upwards.z * upwards.y, 1 - upwards.z * upwards.z};
    const Vec3 lowest = pose.position - half_height * upwards - (radius / std::sqrt(dot(level, level))) * level;
    const double around = std::atan2(dot(pose.rotation.y, level), dot(pose.rotation.x, level));
    const double to_corner = std::fabs(std::remainder(around, std::numbers::pi / 8));
    for (const double margin : {10.0, lowest.z + 1e-9}) {
      const abut::Manifold points = contacts(pose, margin);
      double least = abut::infinity, off = abut::infinity;
      for (const abut::ContactPoint& point : points) {
        least = std::fmin(least, point.distance);
        off = std::fmin(off, largest_magnitude(point.point_b - lowest));
      }
      EXPECT_NEAR(least, lowest.z, 1e-12) << "seed 402, turn " << i;
      EXPECT_LE(off, 1e-12) << "seed 402, turn " << i;
    }
    between += std::fabs(axis.z) > 0.8 && to_corner > 0.05 ? 1 : 0;
    abut::Distance distance{};
    EXPECT_EQ(abut::half_space_distance(ground(), can(), pose, {}, distance), abut::Outcome::ok);
    EXPECT_NEAR(distance.distance, lowest.z, 1e-14) << "seed 402, turn " << i;
    EXPECT_LE(largest_magnitude(distance.point_b - lowest), 1e-12) << "seed 402, turn " << i;
  }
  EXPECT_GT(between, 100);
}

TEST(HalfSpace, NothingBeyondTheMargin) {
  const abut::Pose pose{abut::Rotation::identity(), {0, 0, half_height + 0.5}};
  EXPECT_TRUE(contacts(pose, 0.4).empty());
  EXPECT_EQ(contacts(pose, 0.6).size(), 16u);
}

}  // namespace
