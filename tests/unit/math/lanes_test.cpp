// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "../random_boxes.hpp"

import abut.math;

namespace {

using abut::LaneMatrix;
using abut::Lanes;
using abut::Rotation;
using abut::Vec3;

void expect_lanes(Lanes got, double a, double b, double c, double d) {
  EXPECT_EQ(got[0], a);
  EXPECT_EQ(got[1], b);
  EXPECT_EQ(got[2], c);
  EXPECT_EQ(got[3], d);
}

TEST(Lanes, VectorsOfSpaceEndInZero) {
  const Lanes lanes = abut::lanes_of({1, 2, 3});
  expect_lanes(lanes, 1, 2, 3, 0);
  EXPECT_EQ(abut::vec3_of(lanes), (Vec3{1, 2, 3}));
  expect_lanes(abut::all_lanes(7), 7, 7, 7, 7);
}

TEST(Lanes, OperationsAreLaneByLane) {
  const Lanes a{1, -2, 3, -4}, b{5, -6, -7, 8};
  expect_lanes(abut::absolute(a), 1, 2, 3, 4);
  expect_lanes(abut::minimum(a, b), 1, -6, -7, -4);
  expect_lanes(abut::maximum(a, b), 5, -2, 3, 8);
  EXPECT_EQ(abut::sum(a), -2);
  EXPECT_EQ(abut::dot(a, b), 5 + 12 - 21 - 32);
}

// Of one comparison, and of two that are combined.
TEST(Lanes, EachLaneHasABit) {
  for (unsigned bits = 0; bits < 16; ++bits) {
    Lanes a{}, b{};
    for (unsigned lane = 0; lane < 4; ++lane) {
      a[lane] = (bits >> lane & 1) != 0 ? -1 : 1;
      b[lane] = lane % 2 == 0 ? -1 : 1;
    }
    const Lanes zero = abut::all_lanes(0);
    EXPECT_EQ(abut::bits_of(a < zero), bits);
    EXPECT_EQ(abut::bits_of((a < zero) & (b < zero)), bits & 5);
    EXPECT_EQ(abut::bits_of((a < zero) | (b < zero)), bits | 5);
    EXPECT_EQ(abut::bits_of(~(a < zero)), ~bits & 15);
  }
}

TEST(Lanes, LargestLooksAtEveryLane) {
  EXPECT_EQ(abut::largest(Lanes{4, -1, 2, 3}), 4);
  EXPECT_EQ(abut::largest(Lanes{-1, 4, 2, 3}), 4);
  EXPECT_EQ(abut::largest(Lanes{2, -1, 4, 3}), 4);
  EXPECT_EQ(abut::largest(Lanes{2, -1, 3, 4}), 4);
}

TEST(Lanes, ClampKeepsWithinTheLimit) {
  expect_lanes(abut::clamp(Lanes{5, -5, 0.5, -0.5}, Lanes{1, 2, 3, 0}), 1, -2, 0.5, 0);
}

// One rounding, not two: of the product only the rounding error is left.
TEST(Lanes, MultiplyAddIsFused) {
  const double third = 1.0 / 3;
  const Lanes left = abut::multiply_add(abut::all_lanes(third), abut::all_lanes(3), abut::all_lanes(-1));
  EXPECT_NE(left[0], 0);
  for (int lane = 0; lane < 4; ++lane) {
    EXPECT_EQ(left[lane], std::fma(third, 3, -1));
  }
}

TEST(LaneMatrix, ColumnsAndRowsTurnThereAndBack) {
  test::Random random(61);
  for (int i = 0; i < 1000; ++i) {
    const Rotation rotation = random.rotation();
    const Vec3 v = random.point(5), offset = random.point(5);
    const Vec3 there = abut::vec3_of(LaneMatrix::columns_of(rotation) * abut::lanes_of(v));
    const Vec3 back = abut::vec3_of(LaneMatrix::rows_of(rotation) * abut::lanes_of(v));
    const Vec3 moved = abut::vec3_of(LaneMatrix::columns_of(rotation).apply(abut::lanes_of(v), abut::lanes_of(offset)));
    const Vec3 expected = rotation * v, undone = rotation.undo(v), expected_moved = expected + offset;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(there[axis], expected[axis], 4e-15);
      EXPECT_NEAR(back[axis], undone[axis], 4e-15);
      EXPECT_NEAR(moved[axis], expected_moved[axis], 8e-15);
    }
  }
}

TEST(LaneMatrix, ProductsStayVectorsOfSpace) {
  const LaneMatrix matrix = LaneMatrix::columns_of(Rotation::identity());
  expect_lanes(matrix * abut::lanes_of({1, 2, 3}), 1, 2, 3, 0);
  expect_lanes(LaneMatrix::rows_of(Rotation::identity()).apply(abut::lanes_of({1, 2, 3}), abut::lanes_of({4, 5, 6})), 5,
               7, 9, 0);
}

}  // namespace
