// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "../random_boxes.hpp"

import abut.math.wide;
import abut.math;

namespace {

using abut::Wide;

// 113 bits, where two doubles have 106 or more.
using Quad = __float128;
Quad quad(const Wide& value) { return static_cast<Quad>(value.high) + static_cast<Quad>(value.low); }

// Of a number made of two, and of any size.
Wide random_wide(test::Random& random) {
  const double high = std::ldexp(random.uniform(-1, 1), static_cast<int>(random.uniform(-20, 20)));
  return Wide::sum(high, std::ldexp(high, -54) * random.uniform(-1, 1));
}

bool is_near(const Wide& got, Quad expected, Quad scale) {
  const Quad off = quad(got) - expected, most = scale * static_cast<Quad>(0x1p-102);
  return (off < 0 ? -off : off) <= most;
}
Quad size(Quad value) { return value < 0 ? -value : value; }

TEST(Wide, SumsAndProductsOfTwoNumbersAreExact) {
  test::Random random(61);
  for (int i = 0; i < 10000; ++i) {
    const double a = random_wide(random).high, b = random_wide(random).high;
    EXPECT_EQ(quad(Wide::sum(a, b)), static_cast<Quad>(a) + static_cast<Quad>(b));
    EXPECT_EQ(quad(Wide::product(a, b)), static_cast<Quad>(a) * static_cast<Quad>(b));
  }
}

TEST(Wide, ArithmeticRoundsInTheLastOfTwiceTheDigits) {
  test::Random random(62);
  for (int i = 0; i < 10000; ++i) {
    const Wide a = random_wide(random), b = random_wide(random);
    const Quad x = quad(a), y = quad(b);
    EXPECT_TRUE(is_near(a + b, x + y, size(x) + size(y)));
    EXPECT_TRUE(is_near(a - b, x - y, size(x) + size(y)));
    EXPECT_TRUE(is_near(a * b, x * y, size(x * y)));
    EXPECT_TRUE(is_near(a / b, x / y, size(x / y)));
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a <= b, x <= y);
    EXPECT_EQ(a > b, x > y);
    EXPECT_EQ(a >= b, x >= y);
  }
}

TEST(Wide, NumbersThatDifferInTheirLowerHalfOnly) {
  const Wide less(1, -0x1p-80), more(1, 0x1p-80);
  EXPECT_TRUE(less < more && less <= more && more > less && more >= less && more >= more);
  EXPECT_FALSE(more < less || less > more || less >= more);
  EXPECT_EQ(quad(more - less), static_cast<Quad>(0x1p-79));
  EXPECT_EQ(static_cast<double>(more), 1);
}

TEST(Wide, DifferencesOfVectorsAreExact) {
  const abut::Vec3 a{1e9, 1, -1e9}, b{1e-9, 1e9 / 3, 7e-10};
  const abut::WideVec3 d = abut::wide_difference(a, b);
  const Quad x = static_cast<Quad>(a.x) - static_cast<Quad>(b.x), y = static_cast<Quad>(a.y) - static_cast<Quad>(b.y),
             z = static_cast<Quad>(a.z) - static_cast<Quad>(b.z);
  EXPECT_EQ(quad(d.x), x);
  EXPECT_EQ(quad(d.y), y);
  EXPECT_EQ(quad(d.z), z);
  EXPECT_TRUE(is_near(abut::squared_norm(d), x * x + y * y + z * z, x * x + y * y + z * z));
  const abut::WideVec3 e = abut::wide_difference(b, {3, 5, 7});
  const Quad first = x * quad(e.y), second = y * quad(e.x);
  EXPECT_TRUE(is_near(abut::cross(d, e).z, first - second, size(first) + size(second)));
}

}  // namespace
