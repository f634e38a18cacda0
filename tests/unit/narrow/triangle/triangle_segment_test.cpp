// SPDX-License-Identifier: Apache-2.0
// The distance of a segment from a triangle, beside a search along the segment: the distance of its points from the
// triangle is convex. Nothing is proven where the segment pierces the triangle.
#include <gtest/gtest.h>

#include <cmath>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.triangle.triangle_point;
import abut.narrow.triangle.triangle_segment;

namespace {

using abut::Real;
using abut::TriangleCorners;
using abut::Vec3;

struct Segment {
  Vec3 centre, axis;
  Real half;

  [[nodiscard]] Vec3 at(Real s) const { return centre + s * axis; }
};

Segment random_segment(test::Random& random) {
  const Vec3 toward = random.point(1);
  return {random.point(1), (1 / abut::norm(toward)) * toward, random.uniform(0, 1.5)};
}

Real distance_at(const TriangleCorners& corners, const Segment& segment, Real s) {
  return abut::norm(segment.at(s) - abut::nearest_on(corners, segment.at(s)));
}

// Thirds of what is left are cut off until nothing but rounding is.
Real distance_by_search(const TriangleCorners& corners, const Segment& segment) {
  Real low = -segment.half, high = segment.half;
  for (int i = 0; i < 200; ++i) {
    const Real first = low + (high - low) / 3, second = high - (high - low) / 3;
    if (distance_at(corners, segment, first) < distance_at(corners, segment, second)) {
      high = second;
    } else {
      low = first;
    }
  }
  return distance_at(corners, segment, (low + high) / 2);
}

// What the closest points prove: the distance is no less.
Real proven(const abut::NearPoints& near) { return (near.square - near.gap) / std::sqrt(near.square); }

TEST(TriangleSegment, IsAsFarAsASearchFinds) {
  test::Random random(17);
  int apart = 0, pierced = 0;
  for (int i = 0; i < 4000; ++i) {
    const TriangleCorners corners{random.point(1), random.point(1), random.point(1)};
    const Segment segment = random_segment(random);
    const abut::NearPoints near = abut::near_points_of_segment(corners, segment.centre, segment.axis, segment.half);
    const Real searched = distance_by_search(corners, segment);
    if (searched < 1e-7) {
      ++pierced;
      EXPECT_LE(proven(near), 1e-12) << "case " << i;
      continue;
    }
    ++apart;
    EXPECT_NEAR(std::sqrt(near.square), searched, 1e-7) << "case " << i;
    EXPECT_NEAR(proven(near), searched, 1e-7) << "case " << i;
  }
  EXPECT_GT(apart, 3000);
  EXPECT_GT(pierced, 100);
}

TEST(TriangleSegment, MeetsFacesEdgesAndCorners) {
  const TriangleCorners corners{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
  const auto distance = [&](const Vec3& centre, const Vec3& axis, Real half) {
    return std::sqrt(abut::near_points_of_segment(corners, centre, axis, half).square);
  };
  EXPECT_DOUBLE_EQ(distance({1, 1, 3}, {0, 0, 1}, 1), 2);    // an end over the face
  EXPECT_DOUBLE_EQ(distance({1, 1, 3}, {1, 0, 0}, 0.5), 3);  // parallel to the face
  EXPECT_DOUBLE_EQ(distance({1, -2, 0}, {0, 0, 1}, 1), 2);   // across an edge
  EXPECT_DOUBLE_EQ(distance({2, -2, 0}, {1, 0, 0}, 1), 2);   // parallel to an edge
  EXPECT_DOUBLE_EQ(distance({-3, 0, -4}, {0, 1, 0}, 2), 5);  // beside a corner
}

// A short way has no digits left between its ends, so its direction comes from what it begins on.
TEST(TriangleSegment, TellsTheDirectionOfShortWays) {
  test::Random random(18);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const TriangleCorners corners{random.point(1), random.point(1), random.point(1)};
    const Vec3 edge = corners[1] - corners[0], across = random.point(1);
    const Vec3 aside = across - (dot(across, edge) / abut::squared_norm(edge)) * edge;
    const Real share = random.uniform(0.2, 0.8);
    // The middle of the segment is a millionth beside the edge, away from the face.
    const Vec3 outward = corners[0] - corners[2];
    const Vec3 away = (dot(aside, outward) < 0 ? -1e-6 : 1e-6) / abut::norm(aside) * aside;
    const Vec3 axis = cross(away, edge + 0.5 * away);
    const abut::NearPoints near =
        abut::near_points_of_segment(corners, corners[0] + share * edge + away, (1 / abut::norm(axis)) * axis, 0.1);
    const Vec3 way = abut::vec3_of(near.between);
    if (std::fabs(abut::norm(way) - 1e-6) > 1e-9) {
      continue;  // another edge or the face is nearer
    }
    ++checked;
    EXPECT_LE(std::fabs(dot(way, edge)), 1e-15 * abut::norm(way) * abut::norm(edge)) << "case " << i;
  }
  EXPECT_GT(checked, 500);
}

// A triangle may be a line or a point, and a segment a point.
TEST(TriangleSegment, NeedsNoAreaAndNoLength) {
  const TriangleCorners line{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{4, 0, 0}},
      point{Vec3{1, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 0, 0}};
  const auto distance = [](const TriangleCorners& corners, Real half) {
    return std::sqrt(abut::near_points_of_segment(corners, {1, 3, 0}, {0, 0, 1}, half).square);
  };
  EXPECT_DOUBLE_EQ(distance(line, 1), 3);
  EXPECT_DOUBLE_EQ(distance(point, 1), 3);
  EXPECT_DOUBLE_EQ(distance(line, 0), 3);
}

}  // namespace
