// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "../../../made.hpp"
#include "../../../least_overlap.hpp"
#include "../../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.fan.discs.disc_depth_of_pair;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.hull;
import abut.shapes.triangle;

namespace {

using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr Real error = 1e-10, size = 4;

struct Case {
  Vec3 half;
  test::Solid solid;
  Pose pose;  // of the solid in the frame of the box
};

// The overlap along a direction from the box to the solid.
Real overlap(const Case& c, const Vec3& d) {
  const abut::Rotation& r = c.pose.rotation;
  const Real box = c.half.x * std::fabs(d.x) + c.half.y * std::fabs(d.y) + c.half.z * std::fabs(d.z);
  return (box + c.solid.reach(-r.undo(d)) - dot(d, c.pose.position)) / norm(d);
}

template <class Polyhedron>
std::optional<abut::ProvenDepth> depth_of(const Polyhedron& polyhedron, const Case& c) {
  const std::vector<Real> parameters{c.solid.radius, c.solid.half_height};
  return c.solid.is_cone ? abut::disc_depth(polyhedron, test::made<abut::Cone>(parameters), c.pose, size, error)
                         : abut::disc_depth(polyhedron, test::made<abut::Cylinder>(parameters), c.pose, size, error);
}

template <class Polyhedron>
void check(const Polyhedron& polyhedron, const Case& c, int number) {
  const auto overlap_along = [&](const Vec3& d) { return overlap(c, d); };
  const std::optional<abut::ProvenDepth> found = depth_of(polyhedron, c);
  const Real least = test::least_overlap(overlap_along);
  if (!found) {
    EXPECT_LE(least, error) << number;
    return;
  }
  test::expect_least(*found, least, error, overlap_along, number);
}

TEST(DiscDepth, NoDirectionHasLessThanTheDepthOfABox) {
  test::Random random(20);
  for (int i = 0; i < 160; ++i) {
    const Vec3 half{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
    const Case c{
        half, {random.uniform(0.05, 1), random.uniform(0.05, 1), i % 2 == 0}, {random.rotation(), random.point(0.7)}};
    check(test::made<abut::Box>({half.x, half.y, half.z}), c, i);
  }
}

TEST(DiscDepth, NoDirectionHasLessThanTheDepthOfASegment) {
  test::Random random(21);
  for (int i = 0; i < 80; ++i) {
    const Vec3 half{0, 0, random.uniform(0.1, 1)};
    const Case c{
        half, {random.uniform(0.05, 1), random.uniform(0.05, 1), i % 2 == 0}, {random.rotation(), random.point(0.4)}};
    check(test::made<abut::Capsule>({0.1, half.z}), c, i);
  }
}

// The same box as a hull, whose faces and edges are found another way.
TEST(DiscDepth, OfAHullIsThatOfTheBoxThatItIs) {
  test::Random random(24);
  for (int i = 0; i < 120; ++i) {
    const Vec3 half{random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1)};
    std::vector<Real> corners;
    for (const Vec3& corner : test::corners_of(half, Pose::identity())) {
      corners.insert(corners.end(), {corner.x, corner.y, corner.z});
    }
    const Case c{
        half, {random.uniform(0.05, 1), random.uniform(0.05, 1), i % 2 == 0}, {random.rotation(), random.point(0.7)}};
    const auto of_box = depth_of(test::made<abut::Box>({half.x, half.y, half.z}), c);
    const auto of_hull = depth_of(test::made<abut::Hull>({}, corners), c);
    ASSERT_EQ(of_box.has_value(), of_hull.has_value()) << i;
    if (of_box) {
      EXPECT_NEAR(of_hull->depth, of_box->depth, error) << i;
      EXPECT_LE(norm(of_hull->normal - of_box->normal), 1e-6) << i;
    }
  }
}

// Axes along those of the box and across its edges, where seams of arcs meet their ends and shadows are flat.
TEST(DiscDepth, NoDirectionHasLessWhereAxesAreAligned) {
  test::Random random(22);
  const Vec3 half{0.5, 0.6, 0.7};
  const auto box = test::made<abut::Box>({half.x, half.y, half.z});
  for (int i = 0; i < 120; ++i) {
    const Real tilt = i % 4 == 0 ? 0 : i % 4 == 1 ? 1e-13 : i % 4 == 2 ? 1e-7 : std::numbers::pi / 4;
    const Real c = std::cos(tilt), s = std::sin(tilt);
    const abut::Rotation turned{{1, 0, 0}, {0, c, s}, {0, -s, c}};
    const abut::Rotation onto = i % 3 == 0   ? abut::Rotation{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}
                                : i % 3 == 1 ? abut::Rotation{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}
                                             : abut::Rotation::identity();
    const Case one{
        half, {random.uniform(0.2, 0.8), random.uniform(0.2, 0.8), i % 2 == 0}, {turned * onto, random.point(0.6)}};
    check(box, one, i);
  }
}

// Of a triangle: the overlap along a direction is that of its three corners.
TEST(DiscDepth, NoDirectionHasLessThanTheDepthOfATriangle) {
  test::Random random(25);
  int found_count = 0;
  for (int i = 0; i < 160; ++i) {
    const std::array<Vec3, 3> corners{random.point(1), random.point(1), random.point(1)};
    const test::Solid solid{random.uniform(0.05, 1), random.uniform(0.05, 1), i % 2 == 0};
    const Pose pose{random.rotation(), random.point(0.4)};
    const auto overlap_along = [&](const Vec3& d) {
      const Real reach = std::max(dot(corners[0], d), std::max(dot(corners[1], d), dot(corners[2], d)));
      return (reach + solid.reach(-pose.rotation.undo(d)) - dot(d, pose.position)) / norm(d);
    };
    const Real least = test::least_overlap(overlap_along);
    if (least <= error) {
      continue;
    }
    const auto triangle =
        test::made<abut::FreeTriangle>({corners[0].x, corners[0].y, corners[0].z, corners[1].x, corners[1].y,
                                        corners[1].z, corners[2].x, corners[2].y, corners[2].z});
    const std::vector<Real> parameters{solid.radius, solid.half_height};
    const auto found = solid.is_cone
                           ? abut::disc_depth(triangle, test::made<abut::Cone>(parameters), pose, size, error)
                           : abut::disc_depth(triangle, test::made<abut::Cylinder>(parameters), pose, size, error);
    ASSERT_TRUE(found) << i;
    ++found_count;
    test::expect_least(*found, least, error, overlap_along, i);
  }
  EXPECT_GT(found_count, 60);
}

TEST(DiscDepth, IsTheSameFromTheOtherSide) {
  test::Random random(23);
  const auto box = test::made<abut::Box>({0.5, 0.6, 0.7});
  const auto cone = test::made<abut::Cone>({0.4, 0.8});
  for (int i = 0; i < 100; ++i) {
    const Pose ab{random.rotation(), random.point(0.5)};
    const auto found = abut::disc_depth(box, cone, ab, size, error),
               other = abut::disc_depth(cone, box, ab.inverse(), size, error);
    ASSERT_EQ(found.has_value(), other.has_value()) << i;
    if (found) {
      EXPECT_NEAR(found->depth, other->depth, error) << i;
      EXPECT_NEAR(norm(found->normal + ab.rotation * other->normal), 0, 1e-6) << i;
    }
  }
}

TEST(DiscDepth, SaysNothingOfBodiesThatDoNotOverlap) {
  const auto box = test::made<abut::Box>({1, 1, 1});
  const auto cylinder = test::made<abut::Cylinder>({0.5, 1});
  const Pose apart{abut::Rotation::identity(), {0, 0, 2.5}}, touching{abut::Rotation::identity(), {1.5, 0, 0}};
  EXPECT_FALSE(abut::disc_depth(box, cylinder, apart, size, error));
  EXPECT_FALSE(abut::disc_depth(box, cylinder, touching, size, error));
}

}  // namespace
