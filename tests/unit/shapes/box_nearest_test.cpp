// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "curved_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.box;

namespace {

using abut::Box;
using abut::Vec3;
using test::made;

constexpr Vec3 half{0.5, 1, 2};

Box with(const Vec3& h) { return made<Box>({h.x, h.y, h.z}); }

test::Known known(const Vec3& h) {
  test::Surface sides{{}, false};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      sides.patches.emplace_back([=](double u, double v) {
        const double s = 2 * u - 1, t = 2 * v - 1;
        return axis == 0   ? Vec3{sign * h.x, s * h.y, t * h.z}
               : axis == 1 ? Vec3{t * h.x, sign * h.y, s * h.z}
                           : Vec3{s * h.x, t * h.y, sign * h.z};
      });
    }
  }
  const auto outside = [=](const Vec3& p) {
    return std::fmax(std::fmax(std::fabs(p.x) - h.x, std::fabs(p.y) - h.y), std::fabs(p.z) - h.z);
  };
  const auto reach = [=](const Vec3& d) { return h.x * std::fabs(d.x) + h.y * std::fabs(d.y) + h.z * std::fabs(d.z); };
  return {sides, outside, reach, std::hypot(h.x, h.y, h.z)};
}

TEST(BoxNearest, IsThatOfASearch) {
  for (const Vec3& h : {half, Vec3{2, 0.5, 1}, Vec3{1, 2, 0}, Vec3{0.01, 0.01, 3}, Vec3{0, 0, 2}}) {
    test::expect_nearest(with(h), known(h), 411);
  }
}

TEST(BoxNearest, ByHand) {
  const Box brick = with(half);
  test::expect_same(brick.nearest({3, 0.5, 1}), {0.5, 0.5, 1}, {1, 0, 0}, 2.5);
  test::expect_same(brick.nearest({0.5 + 3, -1 - 4, 1}), {0.5, -1, 1}, {0.6, -0.8, 0}, 5);
  test::expect_same(brick.nearest({0.5 + 2, 1 + 3, -2 - 6}), {0.5, 1, -2}, {2.0 / 7, 3.0 / 7, -6.0 / 7}, 7);
  test::expect_same(brick.nearest({-0.25, 0.5, 1}), {-0.5, 0.5, 1}, {-1, 0, 0}, -0.25);
  test::expect_same(brick.nearest({0, 0.75, 0}), {0, 1, 0}, {0, 1, 0}, -0.25);
  test::expect_same(brick.nearest({0, 0, -1.875}), {0, 0, -2}, {0, 0, -1}, -0.125);
  test::expect_same(brick.nearest({0, 0, 2}), {0, 0, 2}, {0, 0, 1}, 0);
  EXPECT_EQ(brick.nearest({0, 0, 0}).distance, -0.5);
  EXPECT_EQ(std::fabs(brick.nearest({0, 0, 0}).normal.x), 1);
  for (const Vec3& p : {half, Vec3{0.5, 1, 0}, Vec3{0.25, 0.75, 1.75}, Vec3{1e4, 2e4, 3e4}}) {
    test::expect_nearest_at(brick, known(half), p);
  }
}

TEST(BoxNearest, OfFlatAndThinOnes) {
  test::expect_same(with({1, 2, 0}).nearest({0.5, 1, -3}), {0.5, 1, 0}, {0, 0, -1}, 3);
  test::expect_same(with({1, 2, 0}).nearest({4, 0, 4}), {1, 0, 0}, {0.6, 0, 0.8}, 5);
  EXPECT_EQ(with({1, 2, 0}).nearest({0.5, 1, 0}).distance, 0);
  EXPECT_EQ(std::fabs(with({1, 2, 0}).nearest({0.5, 1, 0}).normal.z), 1);
  test::expect_same(with({0, 0, 2}).nearest({3, 0, 6}), {0, 0, 2}, {0.6, 0, 0.8}, 5);
  test::expect_same(with({0, 0, 0}).nearest({3, 0, -4}), {0, 0, 0}, {0.6, 0, -0.8}, 5);
  EXPECT_EQ(with({0, 0, 0}).nearest({0, 0, 0}).distance, 0);
}

// Squares of heights like these have few digits or none.
TEST(BoxNearest, NextToNothingAboveAFlatOne) {
  for (const double height : {1e-100, 1e-155, 1e-160, 1e-161, 1e-200, 1e-300}) {
    const abut::SurfacePoint found = with({1, 2, 0}).nearest({0.5, 1, height});
    EXPECT_NEAR(norm(found.normal), 1, 1e-14) << height;
    EXPECT_NEAR(found.normal.z, 1, 1e-14) << height;
  }
}

}  // namespace
