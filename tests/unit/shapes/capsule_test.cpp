// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <limits>
#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.capsule;

namespace {

using abut::Capsule;
using abut::Errc;
using abut::Vec3;
using test::made;

constexpr double radius = 0.5, half_height = 1.5;

Capsule pill() { return made<Capsule>({radius, half_height}); }

// Distance to the segment from below to above the origin, less the radius.
double outside(const Vec3& p) {
  const double over = std::fmax(std::fabs(p.z) - half_height, 0);
  return std::hypot(p.x, p.y, over) - radius;
}

TEST(Capsule, KeepsItsParameters) {
  EXPECT_EQ(pill().parameters(), (std::vector{radius, half_height}));
  EXPECT_EQ(pill().radius(), radius);
  EXPECT_EQ(pill().half(), (Vec3{0, 0, half_height}));
}

TEST(Capsule, BadInputIsRefusedByName) {
  test::expect_refused<Capsule>({0, 1}, {}, {}, Errc::out_of_range, "radius is 0;");
  test::expect_refused<Capsule>({-1, 1}, {}, {}, Errc::out_of_range, "radius is -1;");
  test::expect_refused<Capsule>({1, -2}, {}, {}, Errc::out_of_range, "half_height is -2;");
  test::expect_refused<Capsule>({1, std::numeric_limits<double>::infinity()}, {}, {}, Errc::not_finite,
                                "half_height is inf;");
  test::expect_refused<Capsule>({1}, {}, {}, Errc::invalid_argument, "parameter_count is 1;");
  test::expect_refused<Capsule>({1, 1}, {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Capsule>({1, 1}, {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

TEST(Capsule, BoxIsTight) {
  const auto reach = [](const abut::Pose& pose, const Vec3& direction) {
    return test::furthest({pose * Vec3{0, 0, half_height}, pose * Vec3{0, 0, -half_height}}, direction) + radius;
  };
  test::expect_tight_boxes(pill(), reach, 2, 121);
}

TEST(Capsule, CoreIsItsSegment) {
  test::expect_support(pill(), {{0, 0, half_height}, {0, 0, -half_height}}, 2, 122);
  EXPECT_EQ(pill().support({0, 0, 1}).index, 1u);
  EXPECT_EQ(pill().support({0, 0, -1}).index, 0u);
  const abut::Face face = pill().supporting_face({1, 0, 0});
  ASSERT_EQ(face.vertices.size(), 2u);
  EXPECT_EQ(face.normal, (Vec3{0, 0, 0}));
  EXPECT_EQ(std::fabs(face.vertices[0].point.z), half_height);
  EXPECT_EQ(face.vertices[0].point, -face.vertices[1].point);
  EXPECT_EQ(made<Capsule>({1, 0}).supporting_face({1, 0, 0}).vertices.size(), 1u);
}

TEST(Capsule, RaysMeetTheFirstCrossing) {
  test::expect_rays(pill(), outside, 2, 123);
  test::expect_rays(made<Capsule>({2, 0}), [](const Vec3& p) { return std::hypot(p.x, p.y, p.z) - 2; }, 2, 124);
}

TEST(Capsule, RaysAlongTheAxisMeetTheCaps) {
  const auto up = abut::UnitVec3::axis_z();
  EXPECT_EQ(pill().cast_ray({0, 0, -5}, up, 10)->distance, 3);
  EXPECT_EQ(pill().cast_ray({0, 0, -5}, up, 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_EQ(pill().cast_ray({0, 0, 0}, up, 10)->distance, 2);
  EXPECT_EQ(pill().cast_ray({0, 0, 0}, -up, 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_FALSE(pill().cast_ray({0.6, 0, -5}, up, 10).has_value());
}

// Where the caps meet the side neither may leave the hit to the other.
TEST(Capsule, RaysAtTheSeamMeetTheFirstCrossing) {
  test::Random random(125);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const Vec3 outward{std::cos(angle), std::sin(angle), 0};
    const Vec3 seam = radius * outward + Vec3{0, 0, i % 2 == 0 ? half_height : -half_height};
    const Vec3 direction = test::towards(random);
    if (dot(direction, outward) > -0.1) {
      continue;
    }
    const double distance = random.uniform(0.5, 4);
    const auto hit =
        pill().cast_ray(seam - distance * direction, abut::UnitVec3::from_unit_unchecked(direction), abut::infinity);
    ASSERT_TRUE(hit.has_value()) << i;
    ASSERT_NEAR(hit->distance, distance, 1e-13) << i;
    ++met;
  }
  EXPECT_GT(met, 5000);
}

}  // namespace
