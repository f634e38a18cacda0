// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../shapes/surface_checks.hpp"

import abut.capability;
import abut.math;

namespace {

using abut::Triangle;
using abut::Vec3;

Triangle triangle(const Vec3& a, const Vec3& b, const Vec3& c) { return {a, b, c, 42, false}; }
std::vector<Vec3> corners_of(const Triangle& t) { return {t.corners().begin(), t.corners().end()}; }
Triangle drawn(test::Random& random) {
  for (;;) {
    const Vec3 a = random.point(1), b = random.point(1), c = random.point(1);
    if (norm(cross(b - a, c - a)) > 0.1) {
      return triangle(a, b, c);
    }
  }
}

TEST(Triangle, NormalIsByWinding) {
  EXPECT_EQ(triangle({0, 0, 0}, {2, 0, 0}, {0, 3, 0}).normal(), (Vec3{0, 0, 1}));
  EXPECT_EQ(triangle({0, 0, 0}, {0, 3, 0}, {2, 0, 0}).normal(), (Vec3{0, 0, -1}));
  for (const double size : {1e-60, 1e-30, 1e60}) {
    EXPECT_NEAR(triangle({0, 0, 0}, {size, 0, 0}, {0, size, 0}).normal().z, 1, 1e-15) << size;
  }
}

// Across all edges of a needle, and the same whichever corner comes first. Edges within a thousandth of each other cost
// three digits.
TEST(Triangle, NormalOfANeedleIsAcrossItsEdges) {
  test::Random random(239);
  for (int i = 0; i < 4000; ++i) {
    const double width = std::pow(10, random.uniform(-12, -1));
    const Vec3 a = random.point(1), b = a + random.point(1),
               c = a + random.uniform(-1, 2) * (b - a) + width * random.point(1);
    const Vec3 n = triangle(a, b, c).normal();
    EXPECT_NEAR(norm(n), 1, 1e-15);
    for (const Vec3& edge : {b - a, c - b, a - c}) {
      EXPECT_NEAR(dot(n, edge), 0, 2e-12) << width;
    }
    EXPECT_GT(dot(n, triangle(b, c, a).normal()), 0.99) << width;
  }
}

TEST(Triangle, NormalIsZeroWithoutArea) {
  const Triangle line = triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), point = triangle({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
  EXPECT_FALSE(line.has_area());
  EXPECT_FALSE(point.has_area());
  EXPECT_EQ(point.normal(), (Vec3{0, 0, 0}));
  EXPECT_TRUE(triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).has_area());
}

TEST(Triangle, BoxesAreTight) {
  test::Random random(231);
  for (int i = 0; i < 20; ++i) {
    const Triangle t = drawn(random);
    const auto reach = [&](const abut::Pose& pose, const Vec3& direction) {
      return test::furthest({pose * t.corners()[0], pose * t.corners()[1], pose * t.corners()[2]}, direction);
    };
    test::expect_tight_boxes(t, reach, 1, 232);
    EXPECT_EQ(t.box().low, t.aabb(abut::Pose::identity()).low);
    EXPECT_EQ(t.box().high, t.aabb(abut::Pose::identity()).high);
  }
}

TEST(Triangle, SupportIsTheFurthestCorner) {
  test::Random random(233);
  for (int i = 0; i < 20; ++i) {
    const Triangle t = drawn(random);
    test::expect_support(t, corners_of(t), 2, 234);
    for (std::uint32_t k = 0; k < 3; ++k) {
      // Up from the opposite edge, where the two others are level.
      const Vec3 &top = t.corners()[k], &from = t.corners()[(k + 1) % 3], along = t.corners()[(k + 2) % 3] - from;
      const Vec3 height = (top - from) - (dot(top - from, along) / dot(along, along)) * along;
      EXPECT_EQ(t.support(height).point, top);
      EXPECT_EQ(t.support(height).index, k);
    }
  }
}

// Both sides look outward, each counter-clockwise seen from its own; edges keep their numbers.
TEST(Triangle, FaceLooksInTheDirection) {
  test::Random random(235);
  for (int i = 0; i < 500; ++i) {
    const Triangle t = drawn(random);
    const Vec3 direction = test::towards(random);
    const abut::Face face = t.supporting_face(direction);
    ASSERT_EQ(face.vertices.size(), 3u);
    EXPECT_GE(dot(face.normal, direction), 0);
    const Vec3 &a = face.vertices[0].point, &b = face.vertices[1].point, &c = face.vertices[2].point;
    EXPECT_GT(dot(cross(b - a, c - a), face.normal), 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = face.vertices[k].vertex, to = face.vertices[(k + 1) % 3].vertex,
                          edge = face.vertices[k].edge;
      EXPECT_EQ(face.vertices[k].point, t.corners()[from]);
      // Edge 0 joins corners 0 and 1, edge 1 corners 1 and 2, edge 2 corners 2 and 0.
      EXPECT_TRUE((from == edge && to == (edge + 1) % 3) || (to == edge && from == (edge + 1) % 3));
    }
  }
}

TEST(Triangle, ExtentBoundsTheCornersUpToAFactorOfTwo) {
  test::Random random(236);
  for (int i = 0; i < 500; ++i) {
    const Triangle t = drawn(random);
    for (const Vec3& corner : t.corners()) {
      EXPECT_LE(norm(corner - t.centre()), 2 * t.extent());
    }
  }
}

// Rays are aimed at known mixtures of the corners, within and without, from both sides.
TEST(Triangle, RaysMeetWhatLiesBetweenTheCorners) {
  test::Random random(237);
  int hits = 0, misses = 0;
  for (int i = 0; i < 5000; ++i) {
    const Triangle t = drawn(random);
    const double u = random.uniform(-0.5, 1.5), v = random.uniform(-0.5, 1.5), w = 1 - u - v;
    const Vec3 target = w * t.corners()[0] + u * t.corners()[1] + v * t.corners()[2];
    const Vec3 direction = test::towards(random);
    if (std::fabs(dot(direction, t.normal())) < 0.05) {
      continue;
    }
    const double distance = random.uniform(0.1, 5), least = std::fmin(std::fmin(u, v), w);
    const auto way = abut::UnitVec3::from_unit_unchecked(direction);
    const auto hit = t.cast_ray(target - distance * direction, way, abut::infinity);
    if (least < -1e-9) {
      EXPECT_FALSE(hit.has_value());
      ++misses;
    } else if (least > 1e-9) {
      ASSERT_TRUE(hit.has_value());
      EXPECT_NEAR(hit->distance, distance, 1e-12);
      EXPECT_EQ(hit->normal, t.normal());
      EXPECT_EQ(hit->feature, (abut::Feature{abut::FeatureKind::face, 42}));
      EXPECT_FALSE(t.cast_ray(target - distance * direction, way, 0.99 * distance).has_value());
      EXPECT_FALSE(t.cast_ray(target + distance * direction, way, abut::infinity).has_value());
      ++hits;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
}

TEST(Triangle, RaysInItsPlaneMissIt) {
  const Triangle t = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_FALSE(t.cast_ray({-1, 0.25, 0}, abut::UnitVec3::from_unit_unchecked({1, 0, 0}), 10).has_value());
}

// Two triangles share an edge; a ray at a point of the edge meets one of them at least.
TEST(Triangle, RaysDoNotSlipThroughASharedEdge) {
  test::Random random(238);
  int cast = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec3 a = random.point(1), b = random.point(1);
    const Vec3 side = cross(b - a, random.point(1));
    if (norm(b - a) < 0.2 || norm(side) < 0.1) {
      continue;
    }
    const Triangle left = triangle(a, b, a + side), right = triangle(b, a, b - side);
    const double at = random.uniform(0.05, 0.95);
    const Vec3 target = (1 - at) * a + at * b, direction = test::towards(random);
    if (std::fabs(dot(direction, left.normal())) < 0.2) {
      continue;
    }
    const Vec3 origin = target - random.uniform(1, 20) * direction;
    const auto way = abut::UnitVec3::from_unit_unchecked(direction);
    ASSERT_TRUE(left.cast_ray(origin, way, abut::infinity).has_value() ||
                right.cast_ray(origin, way, abut::infinity).has_value())
        << i;
    ++cast;
  }
  EXPECT_GT(cast, 50000);
}

}  // namespace
