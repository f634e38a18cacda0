// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

import abut.math;

namespace {

using abut::UnitVec3;
using abut::Vec3;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double drawn(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; }
Vec3 drawn_point(std::mt19937_64& random) {
  const double x = drawn(random), y = drawn(random), z = drawn(random);
  return {x, y, z};
}

TEST(Vec3, ArithmeticIsByCoordinate) {
  const Vec3 a{1, 2, 3}, b{10, 20, 40};
  EXPECT_EQ(a + b, (Vec3{11, 22, 43}));
  EXPECT_EQ(b - a, (Vec3{9, 18, 37}));
  EXPECT_EQ(-a, (Vec3{-1, -2, -3}));
  EXPECT_EQ(2 * a, (Vec3{2, 4, 6}));
  EXPECT_EQ(a * 2, (Vec3{2, 4, 6}));
  EXPECT_EQ(dot(a, b), 10 + 40 + 120);
  EXPECT_EQ(squared_norm(a), 14);
  Vec3 sum = a;
  sum += b;
  EXPECT_EQ(sum, (Vec3{11, 22, 43}));
}

TEST(Vec3, CrossProductIsRightHanded) {
  EXPECT_EQ(abut::cross({1, 0, 0}, {0, 1, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(abut::cross({0, 1, 0}, {0, 0, 1}), (Vec3{1, 0, 0}));
  EXPECT_EQ(abut::cross({0, 0, 1}, {1, 0, 0}), (Vec3{0, 1, 0}));
  EXPECT_EQ(abut::cross({2, 3, 5}, {7, 11, 13}), (Vec3{-16, 9, 1}));
}

TEST(Vec3, IndexIsTheAxis) {
  const Vec3 a{4, 5, 6};
  EXPECT_EQ(a[0], 4);
  EXPECT_EQ(a[1], 5);
  EXPECT_EQ(a[2], 6);
}

TEST(Vec3, ExtremesAreByCoordinate) {
  const Vec3 a{1, -5, 3}, b{2, -7, 3};
  EXPECT_EQ(minimum(a, b), (Vec3{1, -7, 3}));
  EXPECT_EQ(maximum(a, b), (Vec3{2, -5, 3}));
  EXPECT_EQ(abut::absolute(Vec3{-1, 2, -3}), (Vec3{1, 2, 3}));
  EXPECT_EQ(abut::largest_magnitude({1, -5, 3}), 5);
  EXPECT_EQ(abut::largest_magnitude({1, 2, -3}), 3);
}

TEST(Vec3, FiniteMeansAllThree) {
  EXPECT_TRUE(abut::is_finite(Vec3{1, 2, 3}));
  for (const double bad : {infinite, -infinite, not_a_number}) {
    EXPECT_FALSE(is_finite(Vec3{bad, 0, 0}));
    EXPECT_FALSE(is_finite(Vec3{0, bad, 0}));
    EXPECT_FALSE(is_finite(Vec3{0, 0, bad}));
  }
}

TEST(Vec3, NormNeitherOverflowsNorUnderflows) {
  for (int power = -1040; power <= 1020; power += 4) {
    const double unit = std::ldexp(1.0, power);
    EXPECT_NEAR(norm(Vec3{3 * unit, 0, -4 * unit}) / unit, 5, 1e-14) << "2^" << power;
    EXPECT_NEAR(norm(Vec3{-2 * unit, 6 * unit, 3 * unit}) / unit, 7, 1e-14) << "2^" << power;
  }
  EXPECT_EQ(norm(Vec3{0, 0, 0}), 0);
  EXPECT_EQ(norm(Vec3{0, -infinite, 0}), infinite);
}

TEST(UnitVec3, KeepsTheDirection) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 direction = drawn_point(random);
    const double length = std::hypot(direction.x, direction.y, direction.z);
    const double unit = std::ldexp(1.0, static_cast<int>(random() % 2000) - 1000);
    const auto made = UnitVec3::make(unit * direction);
    ASSERT_TRUE(made.has_value());
    const Vec3& vec = made->vec();
    EXPECT_NEAR(std::hypot(vec.x, vec.y, vec.z), 1, 4e-16);
    EXPECT_NEAR(vec.x, direction.x / length, 4e-16);
    EXPECT_NEAR(vec.y, direction.y / length, 4e-16);
    EXPECT_NEAR(vec.z, direction.z / length, 4e-16);
  }
}

TEST(UnitVec3, NothingWithoutADirection) {
  EXPECT_FALSE(UnitVec3::make({0, 0, 0}).has_value());
  EXPECT_FALSE(UnitVec3::make({0, -0.0, 0}).has_value());
  for (const double bad : {infinite, -infinite}) {
    EXPECT_FALSE(UnitVec3::make({bad, 0, 0}).has_value());
    EXPECT_FALSE(UnitVec3::make({1, bad, 2}).has_value());
    EXPECT_FALSE(UnitVec3::make({1, 2, bad}).has_value());
  }
}

TEST(UnitVec3, SmallestLengthStillHasADirection) {
  const auto made = UnitVec3::make({0, -std::numeric_limits<double>::denorm_min(), 0});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(made->vec(), (Vec3{0, -1, 0}));
  EXPECT_EQ((-*made).vec(), (Vec3{0, 1, 0}));
  EXPECT_EQ(UnitVec3::axis_z().vec(), (Vec3{0, 0, 1}));
}

void expect_frame(const Vec3& normal) {
  const auto [first, second] = abut::tangents_of(normal);
  constexpr double slack = 2e-15;
  EXPECT_NEAR(dot(first, first), 1, slack);
  EXPECT_NEAR(dot(second, second), 1, slack);
  EXPECT_NEAR(dot(first, second), 0, slack);
  EXPECT_NEAR(dot(first, normal), 0, slack);
  EXPECT_NEAR(dot(second, normal), 0, slack);
  const double turn = normal.x * (first.y * second.z - first.z * second.y) +
                      normal.y * (first.z * second.x - first.x * second.z) +
                      normal.z * (first.x * second.y - first.y * second.x);
  EXPECT_NEAR(turn, 1, slack);
}

TEST(Tangents, FormARightHandedFrame) {
  std::mt19937_64 random(32);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 direction = drawn_point(random);
    const double length = std::hypot(direction.x, direction.y, direction.z);
    expect_frame({direction.x / length, direction.y / length, direction.z / length});
  }
}

// Where formulas for such frames tend to divide by zero.
TEST(Tangents, PolesAndAxesAreNoExceptions) {
  for (const double sign : {1.0, -1.0}) {
    expect_frame({sign, 0, 0});
    expect_frame({0, sign, 0});
    expect_frame({0, 0, sign});
    expect_frame({1, 0, sign * 0.0});
    for (const double tilt : {1e-5, 1e-8, 1e-12, 1e-16, 1e-300}) {
      expect_frame({tilt, 0, sign * std::sqrt(1 - tilt * tilt)});
      expect_frame({0, -tilt, sign * std::sqrt(1 - tilt * tilt)});
    }
  }
}

TEST(UnitVec3, IsNothingForAnyNumberThatIsNone) {
  for (const double bad : {not_a_number, abut::infinity, -abut::infinity}) {
    EXPECT_FALSE(abut::UnitVec3::make({bad, 1, 2}).has_value());
    EXPECT_FALSE(abut::UnitVec3::make({1, bad, 2}).has_value());
    EXPECT_FALSE(abut::UnitVec3::make({1, 2, bad}).has_value());
  }
}

}  // namespace
