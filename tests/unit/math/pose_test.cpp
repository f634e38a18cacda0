// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "../random_boxes.hpp"

import abut.math;

namespace {

using abut::Pose;
using abut::Quat;
using abut::Rotation;
using abut::Vec3;

void expect_near(const Vec3& a, const Vec3& b, double slack) {
  EXPECT_NEAR(a.x, b.x, slack);
  EXPECT_NEAR(a.y, b.y, slack);
  EXPECT_NEAR(a.z, b.z, slack);
}

// Rodrigues' formula: the turn of v about a unit axis.
Vec3 turned(const Vec3& axis, double angle, const Vec3& v) {
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
}

TEST(Quaternion, NormalizedHasLengthOne) {
  const auto unit = normalized(Quat{2, -4, 4, 8});
  ASSERT_TRUE(unit.has_value());
  EXPECT_NEAR(unit->w, 0.2, 1e-16);
  EXPECT_NEAR(unit->x, -0.4, 1e-16);
  EXPECT_NEAR(unit->y, 0.4, 1e-16);
  EXPECT_NEAR(unit->z, 0.8, 2e-16);
}

TEST(Quaternion, NothingWithoutALength) {
  EXPECT_FALSE(normalized(Quat{0, 0, 0, 0}).has_value());
  EXPECT_FALSE(normalized(Quat{std::numeric_limits<double>::infinity(), 0, 0, 0}).has_value());
  EXPECT_FALSE(normalized(Quat{1, std::numeric_limits<double>::quiet_NaN(), 0, 0}).has_value());
}

TEST(Rotation, ColumnsAreTheImagesOfTheAxes) {
  const double half = std::numbers::pi / 4;
  const Rotation quarter = Rotation::from({std::cos(half), 0, 0, std::sin(half)});  // about Z
  expect_near(quarter.x, {0, 1, 0}, 1e-15);
  expect_near(quarter.y, {-1, 0, 0}, 1e-15);
  expect_near(quarter.z, {0, 0, 1}, 1e-15);
  const Rotation identity = Rotation::identity();
  EXPECT_EQ((identity * Vec3{1, 2, 3}), (Vec3{1, 2, 3}));
}

TEST(Rotation, TurnsByTheAngleOfItsQuaternion) {
  test::Random random(41);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 towards = random.point(1), v = random.point(5);
    const double length = std::sqrt(dot(towards, towards)), angle = random.uniform(-6, 6);
    if (length < 0.01) {
      continue;
    }
    const Vec3 axis = (1 / length) * towards;
    // Quaternions of any length mean the same turn.
    const double w = random.uniform(0.01, 100), s = w * std::sin(angle / 2);
    const Rotation rotation = Rotation::from({w * std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z});
    expect_near(rotation * v, turned(axis, angle, v), 2e-14);
  }
}

TEST(Rotation, UndoAndInverseTakeBack) {
  test::Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const Rotation rotation = random.rotation();
    const Vec3 v = random.point(5);
    expect_near(rotation.undo(rotation * v), v, 1e-14);
    expect_near(rotation.inverse() * (rotation * v), v, 1e-14);
    const Rotation none = rotation * rotation.inverse();
    expect_near(none.x, {1, 0, 0}, 4e-15);
    expect_near(none.y, {0, 1, 0}, 4e-15);
    expect_near(none.z, {0, 0, 1}, 4e-15);
  }
}

TEST(Rotation, ProductTurnsByTheRightOneFirst) {
  test::Random random(43);
  for (int i = 0; i < 1000; ++i) {
    const Rotation a = random.rotation(), b = random.rotation();
    const Vec3 v = random.point(5);
    expect_near((a * b) * v, a * (b * v), 2e-14);
  }
}

TEST(Pose, TurnsThenMoves) {
  const Pose pose{Rotation{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {10, 20, 30}};
  EXPECT_EQ((pose * Vec3{1, 2, 3}), (Vec3{8, 21, 33}));
  EXPECT_EQ(pose.undo({8, 21, 33}), (Vec3{1, 2, 3}));
  EXPECT_EQ((Pose::identity() * Vec3{1, 2, 3}), (Vec3{1, 2, 3}));
}

TEST(Pose, ProductInverseAndUndoFitTogether) {
  test::Random random(44);
  for (int i = 0; i < 1000; ++i) {
    const Pose a{random.rotation(), random.point(10)}, b{random.rotation(), random.point(10)};
    const Vec3 p = random.point(5);
    expect_near((a * b) * p, a * (b * p), 1e-13);
    expect_near(a.undo(a * p), p, 1e-13);
    expect_near(a.inverse() * (a * p), p, 1e-13);
  }
}

TEST(Pose, RelativeIsThePoseInTheFrameOfTheFirst) {
  test::Random random(45);
  for (int i = 0; i < 1000; ++i) {
    const Pose a{random.rotation(), random.point(10)}, b{random.rotation(), random.point(10)};
    const Vec3 p = random.point(5);
    expect_near(a * (relative(a, b) * p), b * p, 1e-13);
  }
}

// Positions far out are exact multiples of 2^-10 here, so their difference is exact. Nothing of the size of rounding at
// 1e9 may remain.
TEST(Pose, RelativeLosesNothingFarFromTheOrigin) {
  test::Random random(46);
  for (int i = 0; i < 1000; ++i) {
    const Rotation rotation = random.rotation();
    const Vec3 far{std::ldexp(std::floor(random.uniform(-1e9, 1e9)), 3), 8e9, -8e9};
    const Vec3 offset{std::ldexp(std::floor(random.uniform(-5e3, 5e3)), -10), 0.5, -0.25};
    const Pose a{rotation, far}, b{rotation, far + offset};
    expect_near(relative(a, b).position, rotation.undo(offset), 1e-14);
  }
}

}  // namespace
