// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.points.clip;

namespace {

using abut::Face;
using abut::FeatureKind;
using abut::Vec3;

// The region may reach over its faces by some units of rounding, so that faces that meet in a line share it.
constexpr double rounding = 1e-13;

constexpr Vec3 up{0, 0, 1};

// Corners counter-clockwise seen from the end of the normal.
Face polygon(const std::vector<Vec3>& corners, const Vec3& normal) {
  Face face;
  face.normal = normal;
  face.index = 7;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    face.vertices.push_back({corners[i], i, 10 + i});
  }
  return face;
}
Face top_square(double half, const Vec3& centre) {
  return polygon({centre + Vec3{-half, -half, 0}, centre + Vec3{half, -half, 0}, centre + Vec3{half, half, 0},
                  centre + Vec3{-half, half, 0}},
                 up);
}
Face bottom_square(double half, const Vec3& centre, double turn) {
  const double c = half * std::cos(turn), s = half * std::sin(turn);
  return polygon({centre + Vec3{-c + s, -s - c, 0}, centre + Vec3{-c - s, -s + c, 0}, centre + Vec3{c - s, s + c, 0},
                  centre + Vec3{c + s, s - c, 0}},
                 -up);
}

// Of a convex region; its corners come in any order.
double area_of(std::span<const abut::ClipPoint> points) {
  std::vector<Vec3> corners;
  Vec3 middle{0, 0, 0};
  for (const abut::ClipPoint& point : points) {
    corners.push_back(point.point_a);
    middle += (1.0 / static_cast<double>(points.size())) * point.point_a;
  }
  std::ranges::sort(corners, {}, [&](const Vec3& p) { return std::atan2(p.y - middle.y, p.x - middle.x); });
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &p = corners[i], &q = corners[(i + 1) % corners.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return std::fabs(twice) / 2;
}

TEST(Clip, SquareOnSquareIsTheirCommonRectangle) {
  abut::ClipPoints points;
  abut::clip_faces(top_square(1, {0, 0, 0}), bottom_square(1, {0.5, 0.25, 0.125}, 0), up, points);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_NEAR(area_of(points.span()), 1.5 * 1.75, rounding);
  for (const abut::ClipPoint& point : points.span()) {
    EXPECT_EQ(point.point_a.z, 0);
    EXPECT_EQ(point.point_b.z, 0.125);
    EXPECT_NEAR(point.point_a.x, point.point_b.x, 1e-15);
    EXPECT_NEAR(point.point_a.y, point.point_b.y, 1e-15);
  }
}

TEST(Clip, SquareTurnedByAnEighthIsAnOctagon) {
  abut::ClipPoints points;
  abut::clip_faces(top_square(1, {0, 0, 0}), bottom_square(1, {0, 0, -0.5}, std::numbers::pi / 4), up, points);
  EXPECT_EQ(points.size(), 8u);
  EXPECT_NEAR(area_of(points.span()), 8 * (std::numbers::sqrt2 - 1), rounding);
}

TEST(Clip, SmallFaceInsideALargeOneKeepsItsCorners) {
  abut::ClipPoints points;
  abut::clip_faces(top_square(10, {0, 0, 0}), bottom_square(1, {2, 3, 0}, 0.3), up, points);
  ASSERT_EQ(points.size(), 4u);
  for (const abut::ClipPoint& point : points.span()) {
    EXPECT_EQ(point.feature_a.kind, FeatureKind::face);
    EXPECT_EQ(point.feature_a.index, 7u);
    EXPECT_EQ(point.feature_b.kind, FeatureKind::vertex);
  }
}

TEST(Clip, EdgeOverFace) {
  abut::ClipPoints points;
  Face edge;
  edge.vertices.push_back({{-5, 0.5, 1}, 0, 3});
  edge.vertices.push_back({{5, 0.5, 1.5}, 1, 3});
  abut::clip_faces(top_square(1, {0, 0, 0}), edge, up, points);
  ASSERT_EQ(points.size(), 2u);
  for (const abut::ClipPoint& point : points.span()) {
    EXPECT_NEAR(std::fabs(point.point_b.x), 1, rounding);
    EXPECT_NEAR(point.point_b.z, 1.25 + 0.05 * point.point_b.x, 1e-15);
    EXPECT_EQ(point.point_a.z, 0);
  }
}

// A vertex has no region in common with anything: its closest point is the contact.
TEST(Clip, NothingOfAVertex) {
  abut::ClipPoints points;
  Face corner;
  corner.vertices.push_back({{0.25, -0.5, 2}, 4, 0});
  abut::clip_faces(top_square(1, {0, 0, 0}), corner, up, points);
  EXPECT_EQ(points.size(), 0u);
}

TEST(Clip, FacesThatMissEachOtherShareNothing) {
  abut::ClipPoints points;
  abut::clip_faces(top_square(1, {0, 0, 0}), bottom_square(1, {3, 0, 0}, 0), up, points);
  EXPECT_EQ(points.size(), 0u);
}

// Faces that meet along a line share it, although rounding may have put them apart.
TEST(Clip, FacesThatMeetAlongALine) {
  for (const double gap : {0.0, 1e-15, -1e-15}) {
    abut::ClipPoints points;
    abut::clip_faces(top_square(1, {0, 0, 0}), bottom_square(1, {2 + gap, 0.5, 0}, 0), up, points);
    ASSERT_GE(points.size(), 2u) << gap;
    double low = 9, high = -9;
    for (const abut::ClipPoint& point : points.span()) {
      EXPECT_NEAR(point.point_a.x, 1, rounding);
      low = std::fmin(low, point.point_a.y);
      high = std::fmax(high, point.point_a.y);
    }
    EXPECT_NEAR(low, -0.5, rounding);
    EXPECT_NEAR(high, 1, rounding);
  }
}

// The area is symmetric and both ways agree with the sum over a fine grid.
TEST(Clip, RandomSquares) {
  test::Random random(51);
  for (int i = 0; i < 300; ++i) {
    const Vec3 centre = random.point(1);
    const double turn = random.uniform(0, 6), half = random.uniform(0.2, 1.5);
    abut::ClipPoints points;
    abut::clip_faces(top_square(1, {0, 0, 0}), bottom_square(half, centre, turn), up, points);
    int inside = 0;
    constexpr int steps = 200;
    for (int x = 0; x < steps; ++x) {
      for (int y = 0; y < steps; ++y) {
        const double px = -1 + (x + 0.5) * 2 / steps, py = -1 + (y + 0.5) * 2 / steps;
        const double dx = px - centre.x, dy = py - centre.y;
        const double u = std::cos(turn) * dx + std::sin(turn) * dy, v = -std::sin(turn) * dx + std::cos(turn) * dy;
        inside += std::fabs(u) <= half && std::fabs(v) <= half ? 1 : 0;
      }
    }
    EXPECT_NEAR(points.size() < 3 ? 0 : area_of(points.span()), 4.0 * inside / (steps * steps), 0.03) << i;
  }
}

}  // namespace
