// SPDX-License-Identifier: Apache-2.0
// Triangles are left out only where they are further away than the limit, and what is well apart is left out. Points of
// triangles, one by one, and their distance from the shape judge that.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.triangle.four_nearest;
import abut.narrow.triangle.quick_axes;
import abut.narrow.triangle.triangle_point;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cylinder;
import abut.shapes.sphere;

namespace {

using abut::Pose;
using abut::TriangleCorners;
using abut::Vec3;

constexpr int steps = 60;  // along the sides of a triangle

// The least over many points of a triangle.
double least_over(const TriangleCorners& corners, const std::function<double(const Vec3&)>& value) {
  double least = abut::infinity;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const Vec3 p = corners[0] + (static_cast<double>(i) / steps) * (corners[1] - corners[0]) +
                     (static_cast<double>(j) / steps) * (corners[2] - corners[0]);
      least = std::fmin(least, value(p));
    }
  }
  return least;
}

TriangleCorners random_triangle(test::Random& random, double size) {
  const Vec3 near = random.point(2);
  return {near + random.point(size), near + random.point(size), near + random.point(size)};
}

double longest_side(const TriangleCorners& corners) {
  return std::fmax(norm(corners[1] - corners[0]),
                   std::fmax(norm(corners[2] - corners[1]), norm(corners[0] - corners[2])));
}

// Corners on a line, within rounding: a normal of theirs is rounding.
TriangleCorners random_sliver(test::Random& random) {
  const Vec3 near = random.point(0.7), along = random.point(1.5);
  return {near, near + along, near + random.uniform(-1, 1) * along};
}

// Whether a triangle is left out; other triangles are in the other lanes.
template <class S>
bool is_left_out(const abut::QuickAxes<S>& axes, const TriangleCorners& corners, double limit, std::size_t lane) {
  std::array<TriangleCorners, 4> four;
  for (std::size_t i = 0; i < 4; ++i) {
    const double away = 3.0 * (static_cast<double>(i) - static_cast<double>(lane));
    const Vec3 shift{away, -away, 0.5 * away};
    four.at(i) = {corners[0] + shift, corners[1] + shift, corners[2] + shift};
  }
  return (axes.near(abut::FourTriangles::of(four, {}), limit) >> lane & 1) == 0;
}

struct Counts {
  int left_out = 0, kept = 0;
};

// `outside`: how far a point of the frame of the core lies outside of it.
template <class S>
Counts check(const S& shape, const std::function<double(const Vec3&)>& outside, std::uint64_t seed, bool has_all_axes) {
  test::Random random(seed);
  Counts counts;
  for (int i = 0; i < 3000; ++i) {
    const TriangleCorners corners =
        i % 4 == 0 ? random_sliver(random) : random_triangle(random, i % 5 == 0 ? 0.05 : 1.5);
    const Pose pose{random.rotation(), random.point(1)};
    const double limit = i % 3 == 0 ? 0 : random.uniform(0, 0.3);
    const double least = least_over(corners, [&](const Vec3& p) { return outside(pose.undo(p)); });
    const bool are_beyond =
        is_left_out(abut::QuickAxes<S>(shape, pose), corners, limit, static_cast<std::size_t>(i) % 4);
    EXPECT_FALSE(are_beyond && least <= limit) << "triangle " << i << " comes within " << least << " of " << limit;
    // The nearest point lies within a step of one that was looked at.
    const double at_least = least - longest_side(corners) / steps;
    EXPECT_TRUE(are_beyond || !has_all_axes || limit > 0 || at_least <= 0) << "triangle " << i << " at " << at_least;
    (are_beyond ? counts.left_out : counts.kept) += 1;
  }
  return counts;
}

void expect_both(const Counts& counts, int least_kept = 100) {
  EXPECT_GT(counts.left_out, 500);
  EXPECT_GT(counts.kept, least_kept);
}

double outside_box(const Vec3& half, const Vec3& p) {
  const Vec3 out = maximum(absolute(p) - half, Vec3{0, 0, 0});
  return norm(out);
}

TEST(QuickAxes, OfABoxTellAllThatIsApart) {
  const Vec3 half{0.5, 0.4, 0.9};
  expect_both(check(
      test::made<abut::Box>({half.x, half.y, half.z}), [&](const Vec3& p) { return outside_box(half, p); }, 801, true));
}

TEST(QuickAxes, OfACapsuleSeeItsSegment) {
  expect_both(check(
      test::made<abut::Capsule>({0.3, 0.7}), [](const Vec3& p) { return outside_box({0, 0, 0.7}, p); }, 802, true));
}

TEST(QuickAxes, OfACylinderLeaveOutNothingThatMeetsIt) {
  const auto outside = [](const Vec3& p) {
    return std::hypot(std::fmax(std::hypot(p.x, p.y) - 0.5, 0), std::fmax(std::fabs(p.z) - 0.6, 0));
  };
  expect_both(check(test::made<abut::Cylinder>({0.5, 0.6}), outside, 803, false));
}

TEST(QuickAxes, OfABallSeeItsCentre) {
  // Few triangles come as near to a point as the limits are.
  expect_both(check(test::made<abut::Sphere>({0.5}), [](const Vec3& p) { return norm(p); }, 804, true), 20);
}

TEST(QuickAxes, OfTwoTrianglesLeaveOutNoneThatComesNear) {
  test::Random random(805);
  Counts counts;
  for (int i = 0; i < 300; ++i) {
    const TriangleCorners first = i % 4 == 0 ? random_sliver(random) : random_triangle(random, 1.5),
                          second = random_triangle(random, 1.5);
    const Pose pose{random.rotation(), random.point(1)};
    const double limit = i % 3 == 0 ? 0 : random.uniform(0, 0.3);
    const abut::Triangle other(second, 0, false);
    const bool are_beyond =
        is_left_out(abut::QuickAxes<abut::Triangle>(other, pose), first, limit, static_cast<std::size_t>(i) % 4);
    const TriangleCorners placed{pose * second[0], pose * second[1], pose * second[2]};
    const double least = least_over(first, [&](const Vec3& p) { return norm(p - abut::nearest_on(placed, p)); });
    EXPECT_FALSE(are_beyond && least <= limit) << "triangle " << i << " comes within " << least << " of " << limit;
    (are_beyond ? counts.left_out : counts.kept) += 1;
  }
  EXPECT_GT(counts.left_out, 50);
  EXPECT_GT(counts.kept, 30);
}

// Slivers and points too.
TEST(FourNearest, AgreeWithEachTriangleByItself) {
  test::Random random(807);
  int aside = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<TriangleCorners, 4> four;
    for (TriangleCorners& corners : four) {
      corners = i % 7 == 0 ? random_sliver(random) : random_triangle(random, i % 5 == 0 ? 0.05 : 1.5);
    }
    const Vec3 corner = random.point(2);
    four[2] = i % 11 == 0 ? TriangleCorners{corner, corner, corner} : four[2];
    const Vec3 point = random.point(3);
    const abut::FourNearest nearest(abut::FourTriangles::of(four, {}), point);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Vec3 expected = abut::nearest_on(four.at(lane), point);
      const double further = std::sqrt(nearest.square[lane]) - norm(point - expected);
      EXPECT_LE(further, 1e-9);
      EXPECT_TRUE(i % 7 == 0 || further >= -1e-9) << "only slivers have their nearest point in doubt";
      aside += nearest.is_aside[lane] != 0 ? 1 : 0;
    }
  }
  EXPECT_GT(aside, 4000);
}

TEST(NearestOnATriangle, IsNoFurtherThanAnyPoint) {
  test::Random random(806);
  for (int i = 0; i < 2000; ++i) {
    const TriangleCorners corners = random_triangle(random, i % 5 == 0 ? 0.05 : 1.5);
    const Vec3 point = random.point(3), nearest = abut::nearest_on(corners, point);
    const double distance = norm(point - nearest);
    EXPECT_LE(distance, least_over(corners, [&](const Vec3& p) { return norm(point - p); }) + 1e-12);
    EXPECT_LE(abut::gap_beyond(corners, nearest, point - nearest), 1e-12);
    EXPECT_LE(norm(nearest - abut::nearest_on(corners, nearest)), 1e-12) << "the point lies on the triangle";
  }
}

}  // namespace
