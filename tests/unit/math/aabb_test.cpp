// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "../random_boxes.hpp"

import abut.math;

namespace {

using abut::Aabb;
using abut::CompactAabb;
using abut::Pose;
using abut::Vec3;

constexpr float largest = std::numeric_limits<float>::max();
constexpr float unbounded = std::numeric_limits<float>::infinity();

TEST(Aabb, EmptyGrowsToWhatItIncludes) {
  Aabb box = Aabb::empty();
  EXPECT_FALSE(box.is_bounded());
  box.include(Vec3{1, -2, 3});
  EXPECT_EQ(box.low, (Vec3{1, -2, 3}));
  EXPECT_EQ(box.high, (Vec3{1, -2, 3}));
  box.include(Aabb{{-1, 0, 0}, {0, 5, 1}});
  EXPECT_EQ(box.low, (Vec3{-1, -2, 0}));
  EXPECT_EQ(box.high, (Vec3{1, 5, 3}));
  box.include(Aabb::empty());
  EXPECT_EQ(box.low, (Vec3{-1, -2, 0}));
  EXPECT_EQ(box.high, (Vec3{1, 5, 3}));
  EXPECT_TRUE(box.is_bounded());
}

TEST(Aabb, BoundariesBelongToIt) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    const auto moved = [&](double by) {
      const Vec3 step{axis == 0 ? by : 0, axis == 1 ? by : 0, axis == 2 ? by : 0};
      return Aabb{box.low + step, box.high + step};
    };
    EXPECT_TRUE(box.overlaps(moved(1)));
    EXPECT_TRUE(box.overlaps(moved(-1)));
    EXPECT_FALSE(box.overlaps(moved(std::nextafter(1.0, 2.0))));
    EXPECT_FALSE(moved(std::nextafter(1.0, 2.0)).overlaps(box));
  }
  EXPECT_TRUE(box.overlaps(Aabb::everything()));
  EXPECT_FALSE(box.overlaps(Aabb::empty()));
}

TEST(Aabb, SmallFunctions) {
  const Aabb box = Aabb::around({1, 2, 3}, {0.5, 1, 2});
  EXPECT_EQ(box.low, (Vec3{0.5, 1, 1}));
  EXPECT_EQ(box.high, (Vec3{1.5, 3, 5}));
  EXPECT_EQ(box.centre(), (Vec3{1, 2, 3}));
  EXPECT_EQ(box.inflated(0.25).low, (Vec3{0.25, 0.75, 0.75}));
  EXPECT_EQ(box.inflated(0.25).high, (Vec3{1.75, 3.25, 5.25}));
  EXPECT_FALSE(Aabb::everything().is_bounded());
}

TEST(Aabb, SquaredDistanceIsToTheNearestPoint) {
  const Aabb box{{-1, -2, -3}, {1, 2, 3}};
  EXPECT_EQ(box.squared_distance({0.5, -1, 2}), 0);
  EXPECT_EQ(box.squared_distance({1, 2, 3}), 0);
  EXPECT_EQ(box.squared_distance({3, 0, 0}), 4);
  EXPECT_EQ(box.squared_distance({-2, 4, -5}), 1 + 4 + 4);
}

TEST(Aabb, TransformedIsTheBoxOfTheCorners) {
  test::Random random(51);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 centre = random.point(5), half{random.uniform(0, 2), random.uniform(0, 2), random.uniform(0, 2)};
    const Pose pose{random.rotation(), random.point(10)};
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (const Vec3& corner : test::corners_of(half, {abut::Rotation::identity(), centre})) {
      const Vec3 p = pose * corner;
      low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z)};
      high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z)};
    }
    const Aabb box = transformed(Aabb{centre - half, centre + half}, pose);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(box.low[axis], low[axis], 1e-14);
      EXPECT_NEAR(box.high[axis], high[axis], 1e-14);
    }
  }
}

TEST(Aabb, TransformedUnboundedIsEverything) {
  test::Random random(52);
  const Aabb half_space{{-abut::infinity, -abut::infinity, -abut::infinity}, {abut::infinity, abut::infinity, 0}};
  const Aabb box = transformed(half_space, {random.rotation(), {1, 2, 3}});
  EXPECT_EQ(box.low, (Vec3{-abut::infinity, -abut::infinity, -abut::infinity}));
  EXPECT_EQ(box.high, (Vec3{abut::infinity, abut::infinity, abut::infinity}));
}

// The four lanes are rounded alike.
float round_down(double value) {
  const abut::SingleLanes lanes = abut::round_down(abut::Lanes{value, 1, -value, value});
  EXPECT_TRUE(lanes[0] == lanes[3]);
  return lanes[0];
}
float round_up(double value) { return -round_down(-value); }

TEST(Rounding, IsToTheNextFloatOutward) {
  test::Random random(53);
  for (int i = 0; i < 5000; ++i) {
    const double value = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform(-160, 120)));
    const float below = round_down(value), above = round_up(value);
    EXPECT_LE(static_cast<double>(below), value);
    EXPECT_GE(static_cast<double>(above), value);
    EXPECT_GT(static_cast<double>(std::nextafter(below, unbounded)), value);
    EXPECT_LT(static_cast<double>(std::nextafter(above, -unbounded)), value);
  }
}

TEST(Rounding, ExactValuesStay) {
  for (const float value : {0.0f, 1.0f, -0.375f, 16777216.0f, largest, -largest}) {
    EXPECT_EQ(round_down(static_cast<double>(value)), value);
    EXPECT_EQ(round_up(static_cast<double>(value)), value);
  }
}

TEST(Rounding, BeyondTheLargestFloatIsStillOutward) {
  EXPECT_EQ(round_down(1e60), largest);
  EXPECT_EQ(round_up(1e60), unbounded);
  EXPECT_EQ(round_down(-1e60), -unbounded);
  EXPECT_EQ(round_up(-1e60), -largest);
}

// The difference to the origin is taken in long double, which has eleven bits more.
TEST(CompactAabb, HoldsTheBoxAndHardlyMore) {
  test::Random random(54);
  for (int i = 0; i < 3000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(random.uniform(-10, 40)));
    const Vec3 origin = random.point(size), centre = random.point(size),
               half{random.uniform(0, 2), random.uniform(0, 2), 1};
    const Aabb box{centre - half, centre + half};
    const CompactAabb small = compact(box, origin);
    for (int axis = 0; axis < 3; ++axis) {
      const long double low = static_cast<long double>(box.low[axis]) - static_cast<long double>(origin[axis]);
      const long double high = static_cast<long double>(box.high[axis]) - static_cast<long double>(origin[axis]);
      const auto got_low = static_cast<long double>(small.low[static_cast<std::size_t>(axis)]);
      const auto got_high = static_cast<long double>(small.high[static_cast<std::size_t>(axis)]);
      EXPECT_LE(got_low, low);
      EXPECT_GE(got_high, high);
      // Two units of a float and some of the double coordinates.
      const long double slack =
          2.5e-7L * std::fabs(low) + 2.5e-7L * std::fabs(high) + 1e-15L * static_cast<long double>(size);
      EXPECT_GE(got_low, low - slack);
      EXPECT_LE(got_high, high + slack);
    }
  }
}

TEST(CompactAabb, UnboundedSidesStayUnbounded) {
  const CompactAabb all = compact(Aabb::everything(), {1, 2, 3});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(all.low[axis], -unbounded);
    EXPECT_EQ(all.high[axis], unbounded);
  }
  const CompactAabb half = abut::compact({{-abut::infinity, 0, 0}, {1, 1, abut::infinity}}, {0, 0, 0});
  EXPECT_EQ(half.low[0], -unbounded);
  EXPECT_TRUE(std::isfinite(half.high[0]));
  EXPECT_EQ(half.high[2], unbounded);
}

TEST(CompactAabb, OverlapIsClosedOnEverySide) {
  const CompactAabb box{{0, 0, 0}, {1, 1, 1}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      CompactAabb other = box;
      other.low[axis] += sign;
      other.high[axis] += sign;
      EXPECT_TRUE(box.overlaps(other));
      other.low[axis] += sign * 1e-6f;
      other.high[axis] += sign * 1e-6f;
      EXPECT_FALSE(box.overlaps(other));
      EXPECT_FALSE(other.overlaps(box));
    }
  }
}

TEST(CompactAabb, ContainsWhatDoesNotReachOver) {
  const CompactAabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(box.contains(box));
  EXPECT_TRUE(box.contains({{0.5f, 0, 0}, {1, 0.5f, 1}}));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CompactAabb lower = box, higher = box;
    lower.low[axis] = -1e-7f;
    higher.high[axis] = 1.0000002f;
    EXPECT_FALSE(box.contains(lower));
    EXPECT_FALSE(box.contains(higher));
  }
}

}  // namespace
