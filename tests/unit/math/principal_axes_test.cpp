// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../random_boxes.hpp"

import abut.math.principal_axes;
import abut.math;

namespace {

using abut::PrincipalAxes;
using abut::Vec3;

void expect_right_handed(const PrincipalAxes& axes) {
  constexpr double slack = 1e-14;
  for (const Vec3& axis : {axes.first, axes.second, axes.third}) {
    EXPECT_NEAR(dot(axis, axis), 1, slack);
  }
  EXPECT_NEAR(dot(axes.first, axes.second), 0, slack);
  EXPECT_NEAR(dot(axes.second, axes.third), 0, slack);
  EXPECT_NEAR(dot(axes.third, axes.first), 0, slack);
  EXPECT_NEAR(dot(cross(axes.first, axes.second), axes.third), 1, slack);
}

double spread(const std::vector<Vec3>& points, const Vec3& mean, const Vec3& axis) {
  double sum = 0;
  for (const Vec3& p : points) {
    sum += dot(p - mean, axis) * dot(p - mean, axis);
  }
  return sum;
}

TEST(PrincipalAxes, OfABoxAreItsEdgesByLength) {
  test::Random random(71);
  for (int i = 0; i < 300; ++i) {
    const abut::Pose pose{random.rotation(), random.point(10)};
    const PrincipalAxes axes = abut::principal_axes(test::corners_of({1, 3, 2}, pose));
    expect_right_handed(axes);
    EXPECT_NEAR(norm(axes.mean - pose.position), 0, 1e-13);
    EXPECT_NEAR(std::fabs(dot(axes.first, pose.rotation.y)), 1, 1e-12);
    EXPECT_NEAR(std::fabs(dot(axes.second, pose.rotation.z)), 1, 1e-12);
    EXPECT_NEAR(std::fabs(dot(axes.third, pose.rotation.x)), 1, 1e-12);
  }
}

// No other direction has more spread than the first axis or less than the third.
TEST(PrincipalAxes, BoundTheSpreadOfAllDirections) {
  test::Random random(72);
  for (int i = 0; i < 100; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 20; ++k) {
      points.push_back(random.point(3));
    }
    const PrincipalAxes axes = abut::principal_axes(points);
    expect_right_handed(axes);
    const double most = spread(points, axes.mean, axes.first), least = spread(points, axes.mean, axes.third);
    const double between = spread(points, axes.mean, axes.second);
    EXPECT_GE(most, between);
    EXPECT_GE(between, least);
    for (int k = 0; k < 100; ++k) {
      const Vec3 direction = random.rotation().x;
      EXPECT_LE(spread(points, axes.mean, direction), most * (1 + 1e-12));
      EXPECT_GE(spread(points, axes.mean, direction), least * (1 - 1e-12));
    }
  }
}

TEST(PrincipalAxes, DegenerateCloudsStillHaveAFrame) {
  const std::vector<Vec3> one{{1, 2, 3}}, same(5, Vec3{4, 5, 6}), line{{0, 0, 0}, {1, 1, 0}, {3, 3, 0}};
  expect_right_handed(abut::principal_axes(one));
  EXPECT_EQ(abut::principal_axes(one).mean, (Vec3{1, 2, 3}));
  expect_right_handed(abut::principal_axes(same));
  const PrincipalAxes axes = abut::principal_axes(line);
  expect_right_handed(axes);
  EXPECT_NEAR(std::fabs(axes.first.x), std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(std::fabs(axes.first.y), std::sqrt(0.5), 1e-14);
}

// Squares of such coordinates overflow or vanish.
TEST(PrincipalAxes, ExtremeSizesKeepTheirAxes) {
  for (const double size : {1e-200, 1e-70, 1e70, 1e200}) {
    const std::vector<Vec3> points{{-3 * size, 0, 0}, {3 * size, 0, 0}, {0, 0, 2 * size},
                                   {0, 0, -2 * size}, {0, size, 0},     {0, -size, 0}};
    const PrincipalAxes axes = abut::principal_axes(points);
    expect_right_handed(axes);
    EXPECT_NEAR(std::fabs(axes.first.x), 1, 1e-14) << size;
    EXPECT_NEAR(std::fabs(axes.second.z), 1, 1e-14) << size;
    EXPECT_NEAR(std::fabs(axes.third.y), 1, 1e-14) << size;
  }
}

}  // namespace
