// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.walls.half_space;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cone;
import abut.shapes.cylinder;
import abut.shapes.hull;
import abut.shapes.plane;
import abut.shapes.sphere;

namespace {

using abut::Cylinder;
using abut::Plane;
using abut::Vec3;
using test::made;

constexpr double radius = 0.5, half_height = 1;

Plane ground() { return made<Plane>({0, 0, 1, 0}); }
Cylinder can() { return made<Cylinder>({radius, half_height}); }

abut::Manifold contacts(const abut::Pose& pose, double margin) {
  abut::QuerySettings settings;
  settings.margin = margin;
  abut::Manifold points;
  EXPECT_EQ(abut::half_space_contacts(ground(), can(), pose, settings, points), abut::Outcome::ok);
  std::set<std::uint64_t> ids;
  for (const abut::ContactPoint& point : points) {
    EXPECT_TRUE(ids.insert(point.id).second) << "one id, two points";
    EXPECT_EQ(point.normal, (Vec3{0, 0, 1}));
    EXPECT_NEAR(point.point_a.z, 0, 1e-15);
    EXPECT_NEAR(point.point_b.z, point.distance, 1e-15);
    EXPECT_LE(point.distance, margin);
  }
  return points;
}

TEST(HalfSpace, StandingCylinderTouchesAtItsRim) {
  for (const bool upright : {true, false}) {
    const abut::Rotation turn =
        upright ? abut::Rotation::identity() : abut::Rotation{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    const abut::Manifold points = contacts({turn, {3, 4, half_height - 0.01}}, 0);
    ASSERT_EQ(points.size(), 16u);
    std::set<std::uint32_t> corners;
    for (const abut::ContactPoint& point : points) {
      EXPECT_NEAR(point.distance, -0.01, 1e-15);
      EXPECT_NEAR(std::hypot(point.point_b.x - 3, point.point_b.y - 4), radius, 1e-15);
      EXPECT_EQ(point.feature_b.kind, abut::FeatureKind::vertex);
      corners.insert(point.feature_b.index);
    }
    EXPECT_EQ(*corners.begin(), upright ? 16u : 0u);
    EXPECT_EQ(*corners.rbegin(), upright ? 31u : 15u);
  }
}

TEST(HalfSpace, LyingCylinderTouchesAtTwoPoints) {
  test::Random random(401);
  for (int i = 0; i < 200; ++i) {
    // The axis across the plane's normal, turned about both.
    const double yaw = random.uniform(0, 2 * std::numbers::pi), roll = random.uniform(0, 2 * std::numbers::pi);
    const Vec3 along{std::cos(yaw), std::sin(yaw), 0}, across{-std::sin(yaw), std::cos(yaw), 0}, up{0, 0, 1};
    const Vec3 first = std::cos(roll) * across + std::sin(roll) * up,
               second = std::cos(roll) * up - std::sin(roll) * across;
    const abut::Rotation turn{first, second, along};
    const abut::Manifold points = contacts({turn, {3, 4, radius - 0.01}}, 0);
    ASSERT_EQ(points.size(), 2u) << "seed 401, turn " << i;
    for (const abut::ContactPoint& point : points) {
      EXPECT_NEAR(point.distance, -0.01, 1e-15) << "seed 401, turn " << i;
      const Vec3 end = Vec3{3, 4, -0.01} + (point.feature_b.index == 32 ? -half_height : half_height) * along;
      EXPECT_LE(largest_magnitude(point.point_b - end), 4e-15) << "seed 401, turn " << i;
    }
    EXPECT_EQ(points[0].feature_b, (abut::Feature{abut::FeatureKind::vertex, 32}));
    EXPECT_EQ(points[1].feature_b, (abut::Feature{abut::FeatureKind::vertex, 33}));
  }
}

// The lowest point of a rim lies somewhere between two of its corners.
TEST(HalfSpace, TiltedCylinderTouchesAtItsLowestPoint) {
  test::Random random(402);
  int between = 0;
  for (int i = 0; i < 2000; ++i) {
    const abut::Pose pose{random.rotation(), random.point(1) + Vec3{0, 0, 1}};
    const Vec3 axis = pose.rotation.z, upwards = (axis.z > 0 ? 1 : -1) * axis;
    // The part of the normal across the axis.
    const Vec3 level{-upwards.z * upwards.x, -upwards.z * upwards.y, 1 - upwards.z * upwards.z};
    const Vec3 lowest = pose.position - half_height * upwards - (radius / std::sqrt(dot(level, level))) * level;
    const double around = std::atan2(dot(pose.rotation.y, level), dot(pose.rotation.x, level));
    const double to_corner = std::fabs(std::remainder(around, std::numbers::pi / 8));
    for (const double margin : {10.0, lowest.z + 1e-9}) {
      const abut::Manifold points = contacts(pose, margin);
      double least = abut::infinity, off = abut::infinity;
      for (const abut::ContactPoint& point : points) {
        least = std::fmin(least, point.distance);
        off = std::fmin(off, largest_magnitude(point.point_b - lowest));
      }
      EXPECT_NEAR(least, lowest.z, 1e-12) << "seed 402, turn " << i;
      EXPECT_LE(off, 1e-12) << "seed 402, turn " << i;
    }
    between += std::fabs(axis.z) > 0.8 && to_corner > 0.05 ? 1 : 0;
    abut::Distance distance{};
    EXPECT_EQ(abut::half_space_distance(ground(), can(), pose, {}, distance), abut::Outcome::ok);
    EXPECT_NEAR(distance.distance, lowest.z, 1e-14) << "seed 402, turn " << i;
    EXPECT_LE(largest_magnitude(distance.point_b - lowest), 1e-12) << "seed 402, turn " << i;
  }
  EXPECT_GT(between, 100);
}

TEST(HalfSpace, NothingBeyondTheMargin) {
  const abut::Pose pose{abut::Rotation::identity(), {0, 0, half_height + 0.5}};
  EXPECT_TRUE(contacts(pose, 0.4).empty());
  EXPECT_EQ(contacts(pose, 0.6).size(), 16u);
}

// A tilted half-space and a shape near its plane, both placed in the world.
struct Placed {
  Plane plane;
  abut::Pose pose_a, pose_b;
  Vec3 normal;    // in the world
  double height;  // of the origin of the shape
  double margin;

  double height_of(const Vec3& world) const { return height + dot(normal, world - pose_b.position); }
};

Placed place_near_plane(test::Random& random, double reach) {
  const abut::Rotation tilt = random.rotation();
  const double offset = random.uniform(-2, 2), height = random.uniform(-reach, reach);
  const abut::Pose pose_a{random.rotation(), random.point(10)};
  const Vec3 n = pose_a.rotation * tilt.z, level = pose_a.rotation * tilt.x;
  const Vec3 position = pose_a.position + (offset + height) * n + random.uniform(-3, 3) * level;
  return {made<Plane>({tilt.z.x, tilt.z.y, tilt.z.z, offset}),
          pose_a,
          {random.rotation(), position},
          n,
          height,
          random.uniform(-0.3, 0.5)};
}

// What has to touch: points of the surface in the world, and the vertices that they are of.
struct Expected {
  Vec3 point;
  std::uint32_t vertex;
};

template <class B>
void expect_contacts(const Placed& placed, const B& b, const std::vector<Expected>& points) {
  constexpr double slack = 1e-13;
  abut::QuerySettings settings;
  settings.margin = placed.margin;
  abut::Manifold found;
  const auto append = [&](const abut::ContactPoint& contact) { found.push_back(contact); };
  ASSERT_EQ(abut::half_space_contacts(placed.plane, b, placed.pose_a, placed.pose_b, settings, append),
            abut::Outcome::ok);
  std::size_t expected = 0;
  for (const Expected& point : points) {
    const double height = placed.height_of(point.point);
    if (std::fabs(height - placed.margin) < slack) {
      return;  // within rounding of the margin either answer is right
    }
    expected += height < placed.margin ? 1 : 0;
    const auto is_it = [&](const abut::ContactPoint& contact) {
      return contact.feature_b == abut::Feature{abut::FeatureKind::vertex, point.vertex} &&
             largest_magnitude(contact.point_b - point.point) < slack &&
             largest_magnitude(contact.point_a - (point.point - height * placed.normal)) < slack &&
             largest_magnitude(contact.normal - placed.normal) < slack &&
             std::fabs(contact.distance - height) < slack &&
             contact.id == abut::contact_id({abut::FeatureKind::whole, 0}, contact.feature_b);
    };
    EXPECT_EQ(std::ranges::count_if(found, is_it), height < placed.margin ? 1 : 0) << "vertex " << point.vertex;
  }
  EXPECT_EQ(found.size(), expected);
}

TEST(HalfSpace, BallTouchesWithItsLowestPoint) {
  test::Random random(403);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Placed placed = place_near_plane(random, 2);
    expect_contacts(placed, made<abut::Sphere>({0.8}), {{placed.pose_b.position - 0.8 * placed.normal, 0}});
  }
}

TEST(HalfSpace, CapsuleTouchesWithItsEnds) {
  test::Random random(404);
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Placed placed = place_near_plane(random, 2);
    const Vec3 &centre = placed.pose_b.position, axis = placed.pose_b.rotation.z;
    // Under the upper end the surface is the side, or the ball around the lower end, which has its own contact.
    const double rise = abut::dot(axis, placed.normal), sine = abut::norm(abut::cross(axis, placed.normal));
    const std::uint32_t lower = rise > 0 ? 0 : 1;
    const Vec3 to_lower = (rise > 0 ? -1.2 : 1.2) * axis;
    std::vector<Expected> expected{{centre + to_lower - 0.8 * placed.normal, lower}};
    if (0.8 * std::fabs(rise) <= 2.4 * sine) {
      expected.push_back({centre - to_lower - (0.8 / sine) * placed.normal, 1 - lower});
    }
    expect_contacts(placed, made<abut::Capsule>({0.8, 1.2}), expected);
    expect_contacts(placed, made<abut::Capsule>({0.8, 0}), {{centre - 0.8 * placed.normal, 0}});
  }
}

// The corners of the face of a box whose normal points down most, and which of the three axes that is.
std::vector<Expected> lowest_face(const Placed& placed, const Vec3& half) {
  const abut::Rotation& r = placed.pose_b.rotation;
  int axis = 0;
  bool is_upper = false;
  double least = abut::infinity;
  for (int candidate = 0; candidate < 3; ++candidate) {
    const double upward = dot(candidate == 0 ? r.x : candidate == 1 ? r.y : r.z, placed.normal);
    if (-std::fabs(upward) < least) {
      least = -std::fabs(upward);
      axis = candidate;
      is_upper = upward < 0;
    }
  }
  std::vector<Expected> corners;
  for (std::uint32_t bits = 0; bits < 8; ++bits) {
    if (((bits >> axis) & 1u) == (is_upper ? 1u : 0u)) {
      const Vec3 local{bits & 1u ? half.x : -half.x, bits & 2u ? half.y : -half.y, bits & 4u ? half.z : -half.z};
      corners.push_back({placed.pose_b * local, bits});
    }
  }
  return corners;
}

TEST(HalfSpace, BoxTouchesWithTheCornersOfItsLowestFace) {
  test::Random random(405);
  std::set<std::uint32_t> all;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Placed placed = place_near_plane(random, 2.5);
    const Vec3 half{random.uniform(0.2, 1.5), random.uniform(0.2, 1.5), random.uniform(0.2, 1.5)};
    const std::vector<Expected> corners = lowest_face(placed, half);
    for (const Expected& corner : corners) {
      all.insert(corner.vertex);
    }
    expect_contacts(placed, made<abut::Box>({half.x, half.y, half.z}), corners);
  }
  EXPECT_EQ(all.size(), 8u);
}

// A box without extent along an axis still has a face across it, and along others none.
TEST(HalfSpace, FlatBoxTouchesWithEachCornerOnce) {
  test::Random random(406);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    Placed placed = place_near_plane(random, 0.5);
    placed.margin = 10;
    abut::Manifold found;
    const auto append = [&](const abut::ContactPoint& contact) { found.push_back(contact); };
    const abut::Box sheet = made<abut::Box>({1, 0, 0.5});
    abut::QuerySettings settings;
    settings.margin = placed.margin;
    ASSERT_EQ(abut::half_space_contacts(placed.plane, sheet, placed.pose_a, placed.pose_b, settings, append),
              abut::Outcome::ok);
    const Vec3 up = placed.pose_b.rotation.undo(placed.normal);
    const bool lies = std::fabs(up.y) > std::fabs(up.x) && std::fabs(up.y) > std::fabs(up.z);
    EXPECT_EQ(found.size(), lies ? 4u : 2u);
    double least = abut::infinity;
    for (const abut::ContactPoint& contact : found) {
      least = std::fmin(least, contact.distance);
    }
    EXPECT_NEAR(least, placed.height - std::fabs(up.x) - 0.5 * std::fabs(up.z), 1e-13);
  }
}

// The hull of the corners of a box numbers them in an order of its own, so the points tell.
TEST(HalfSpace, HullTouchesWithTheCornersOfItsLowestFace) {
  test::Random random(407);
  const Vec3 half{0.5, 0.75, 1.25};
  std::vector<double> xyz;
  for (const Vec3& corner : test::corners_of(half, abut::Pose::identity())) {
    xyz.insert(xyz.end(), {corner.x, corner.y, corner.z});
  }
  const abut::Hull hull = made<abut::Hull>({}, xyz);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Placed placed = place_near_plane(random, 2.5);
    std::vector<Expected> corners = lowest_face(placed, half);
    for (Expected& corner : corners) {
      const Vec3 local = placed.pose_b.undo(corner.point);
      for (std::uint32_t vertex = 0; vertex < hull.data().vertices.size(); ++vertex) {
        corner.vertex = largest_magnitude(hull.data().vertices[vertex] - local) < 1e-12 ? vertex : corner.vertex;
      }
    }
    expect_contacts(placed, hull, corners);
  }
}

TEST(HalfSpace, HullWithoutAreaTouchesWithItsEnds) {
  test::Random random(408);
  const abut::Hull stick = made<abut::Hull>({}, {-1, 0, 0, 1, 0, 0});
  const std::uint32_t upper = stick.data().vertices[0].x > 0 ? 0 : 1;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Placed placed = place_near_plane(random, 2);
    const Vec3 along = placed.pose_b.rotation.x;
    expect_contacts(placed, stick,
                    {{placed.pose_b.position - along, 1 - upper}, {placed.pose_b.position + along, upper}});
  }
}

// Apex, side or base: the deepest contact is at the lowest of the apex and the rim.
TEST(HalfSpace, ConeTouchesAtItsLowestPoint) {
  test::Random random(409);
  const abut::Cone cone = made<abut::Cone>({radius, half_height});
  std::set<abut::FeatureKind> kinds;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Placed placed = place_near_plane(random, 1);
    abut::QuerySettings settings;
    settings.margin = 5;
    double least = abut::infinity;
    const auto append = [&](const abut::ContactPoint& contact) {
      least = std::fmin(least, contact.distance);
      kinds.insert(contact.feature_b.kind);
      EXPECT_NEAR(placed.height_of(contact.point_b), contact.distance, 1e-13);
      EXPECT_NEAR(placed.height_of(contact.point_a), 0, 1e-13);
      EXPECT_EQ(contact.feature_a, (abut::Feature{abut::FeatureKind::whole, 0}));
    };
    ASSERT_EQ(abut::half_space_contacts(placed.plane, cone, placed.pose_a, placed.pose_b, settings, append),
              abut::Outcome::ok);
    const double rise = dot(placed.pose_b.rotation.z, placed.normal);
    const double across = std::sqrt(1 - rise * rise);
    EXPECT_NEAR(least, placed.height + std::fmin(half_height * rise, -half_height * rise - radius * across), 1e-12);
  }
  EXPECT_EQ(kinds, (std::set{abut::FeatureKind::vertex, abut::FeatureKind::edge}));
}

TEST(HalfSpace, OtherAlgorithmsAreRefused) {
  abut::QuerySettings settings;
  settings.algorithm = abut::Algorithm::gjk_epa;
  abut::Manifold points;
  EXPECT_EQ(abut::half_space_contacts(ground(), can(), abut::Pose::identity(), settings, points),
            abut::Outcome::unsupported);
  EXPECT_TRUE(points.empty());
}

}  // namespace
