// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "../../hull_of.hpp"
#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.convex.separation;
import abut.narrow.fan.hull_sat;
import abut.shapes.hull;
import abut.shapes.triangle;

namespace {

using abut::Hull;
using abut::Pose;
using abut::Vec3;
using test::hull_of;
using Points = std::vector<Vec3>;

// On a lattice many edges have the same normal across them as those that touch.
Points lattice_points(std::size_t count, test::Random& random) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = random.point(4);
    points.push_back(0.25 * Vec3{std::round(p.x), std::round(p.y), std::round(p.z)});
  }
  return points;
}

// How far a point lies from a triangle, at most: across its plane, and outside of its edges in that plane.
double off_triangle(const Points& corners, const Vec3& p) {
  const Vec3 across = cross(corners[1] - corners[0], corners[2] - corners[0]), n = (1 / norm(across)) * across;
  double off = std::fabs(dot(p - corners[0], n));
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 edge = corners[(i + 1) % 3] - corners[i];
    off = std::fmax(off, dot(p - corners[i], cross(edge, n)) / norm(edge));
  }
  return off;
}

TEST(HullSatOnALattice, PointsOfTwoHullsLieOnBoth) {
  test::Random random(308);
  int deep = 0;
  for (int i = 0; i < 6000; ++i) {
    SCOPED_TRACE(i);
    const Hull a = hull_of(lattice_points(10, random)), b = hull_of(lattice_points(8, random));
    const Pose ab{abut::Rotation::identity(), lattice_points(1, random)[0]};
    abut::CoreSeparation found = abut::separate_cores(a, b, ab, {}, abut::infinity);
    if (!found.overlap || found.algorithm != abut::Algorithm::sat || a.data().faces.size() < 3 ||
        b.data().faces.size() < 3) {
      continue;
    }
    ++deep;
    abut::find_points(a, b, ab, found);
    EXPECT_TRUE(abut::holds(a, found.point_a, 1e-12));
    EXPECT_TRUE(abut::holds(b, ab.undo(found.point_b), 1e-12));
  }
  EXPECT_GT(deep, 1000);
}

// The normal that is best is across the ends of a stretch that no edge of b joins, too.
TEST(HullSatOnALattice, EndsOfAStretchThatIsCutAreNoEdge) {
  const Hull a = hull_of({{-0.5, -0.75, -0.5},
                          {-1, 0.75, 0.25},
                          {-1, -0.75, 0.25},
                          {0.5, 0.75, 0.5},
                          {1, 0.75, -0.25},
                          {0, 0, -0.5},
                          {0, -0.375, 0.25},
                          {0.5, 0.375, 0.25},
                          {-0.5, -0.75, 0.25}});
  const Hull b = hull_of({{-0.5, 0.625, 0.375},
                          {-0.5, 1.25, -0.75},
                          {0, 1.25, 0.375},
                          {0.5, -0.625, 0.75},
                          {0.25, 0, -0.75},
                          {0.5, -1.25, -0.75},
                          {0, -0.625, -0.75},
                          {0, -1.25, -0.375}});
  const Pose ab{abut::Rotation::identity(), {0.6646153846842664, 1.5015384614868001, 0.30769230767295891}};
  abut::CoreSeparation found = abut::separate_cores(a, b, ab, {}, abut::infinity);
  ASSERT_TRUE(found.overlap);
  abut::find_points(a, b, ab, found);
  EXPECT_TRUE(abut::holds(a, found.point_a, 1e-12));
  EXPECT_TRUE(abut::holds(b, ab.undo(found.point_b), 1e-12));
}

TEST(HullSatOnALattice, PointsOfAHullAndATriangleLieOnBoth) {
  test::Random random(309);
  int deep = 0;
  for (int i = 0; i < 6000; ++i) {
    SCOPED_TRACE(i);
    const Hull a = hull_of(lattice_points(10, random));
    const Points corners = lattice_points(3, random);
    const auto b = test::made<abut::FreeTriangle>({corners[0].x, corners[0].y, corners[0].z, corners[1].x, corners[1].y,
                                                   corners[1].z, corners[2].x, corners[2].y, corners[2].z});
    const Pose ab{abut::Rotation::identity(), lattice_points(1, random)[0]};
    abut::CoreSeparation found = abut::separate_cores(a, b, ab, {}, abut::infinity);
    if (!found.overlap || found.algorithm != abut::Algorithm::sat || a.data().faces.size() < 3 || !b.has_area()) {
      continue;
    }
    ++deep;
    abut::find_points(a, b, ab, found);
    EXPECT_TRUE(abut::holds(a, found.point_a, 1e-12));
    EXPECT_LE(off_triangle(corners, ab.undo(found.point_b)), 1e-12);
  }
  EXPECT_GT(deep, 1000);
}

}  // namespace
