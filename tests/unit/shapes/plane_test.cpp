// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.plane;

namespace {

using abut::Errc;
using abut::Plane;
using abut::UnitVec3;
using abut::Vec3;
using test::made;

// The offset is measured along the unit normal, whatever length the given one has.
TEST(Plane, NormalIsNormalisedAndTheOffsetIsNot) {
  const Plane plane = made<Plane>({0, 3, 4, 10});
  EXPECT_NEAR(plane.normal().y, 0.6, 3e-16);
  EXPECT_NEAR(plane.normal().z, 0.8, 3e-16);
  EXPECT_EQ(plane.offset(), 10);
  const std::vector<double> parameters = plane.parameters();
  ASSERT_EQ(parameters.size(), 4u);
  EXPECT_EQ(parameters[1], plane.normal().y);
  EXPECT_EQ(parameters[3], 10);
  EXPECT_NEAR(made<Plane>({0, 1e-70, 0, 1}).normal().y, 1, 1e-15);
}

TEST(Plane, BadInputIsRefusedByName) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  test::expect_refused<Plane>({0, 0, 0, 1}, {}, {}, Errc::zero_vector, "normal is (0, 0, 0);");
  test::expect_refused<Plane>({infinite, 0, 0, 1}, {}, {}, Errc::not_finite, "normal_x is inf;");
  test::expect_refused<Plane>({0, std::fabs(std::nan("")), 1, 1}, {}, {}, Errc::not_finite, "normal_y is nan;");
  test::expect_refused<Plane>({0, 0, -1e71, 1}, {}, {}, Errc::out_of_range, "normal_z is -1e+71;");
  test::expect_refused<Plane>({0, 0, 1, -infinite}, {}, {}, Errc::not_finite, "offset is -inf;");
  test::expect_refused<Plane>({0, 0, 1}, {}, {}, Errc::invalid_argument, "parameter_count is 3;");
  test::expect_refused<Plane>({0, 0, 1, 0}, {1}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Plane>({0, 0, 1, 0}, {}, {1}, Errc::invalid_argument, "index_count is 1;");
}

TEST(Plane, BoxHasNoSides) {
  const abut::Aabb box = made<Plane>({0, 0, 1, 5}).aabb({abut::Rotation::identity(), {1, 2, 3}});
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(box.low[axis], -abut::infinity);
    EXPECT_EQ(box.high[axis], abut::infinity);
  }
}

// Rays are drawn through a known point of the plane, from either side of it.
TEST(Plane, RaysMeetItFromBothSides) {
  test::Random random(131);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 normal = test::towards(random);
    const double offset = random.uniform(-5, 5), distance = random.uniform(0.01, 20);
    const Plane plane = made<Plane>({normal.x, normal.y, normal.z, offset});
    const Vec3 across = cross(normal, random.point(5)), direction = test::towards(random);
    if (std::fabs(dot(direction, normal)) < 0.01) {
      continue;
    }
    const Vec3 target = offset * normal + across;
    const auto hit =
        plane.cast_ray(target - distance * direction, UnitVec3::from_unit_unchecked(direction), abut::infinity);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, distance, 5e-12);
    EXPECT_GT(dot(hit->normal, normal), 1 - 1e-15);
    EXPECT_FALSE(plane.cast_ray(target + distance * direction, UnitVec3::from_unit_unchecked(direction), abut::infinity)
                     .has_value());
    EXPECT_FALSE(plane.cast_ray(target - distance * direction, UnitVec3::from_unit_unchecked(direction), 0.9 * distance)
                     .has_value());
  }
}

TEST(Plane, ParallelRaysMissIt) {
  const Plane plane = made<Plane>({0, 0, 1, 1});
  const auto along = UnitVec3::from_unit_unchecked({1, 0, 0});
  EXPECT_FALSE(plane.cast_ray({0, 0, 2}, along, abut::infinity).has_value());
  EXPECT_FALSE(plane.cast_ray({0, 0, 0}, along, abut::infinity).has_value());
}

TEST(Plane, RayOnThePlaneMeetsItAtOnce) {
  const auto hit = made<Plane>({0, 0, 1, 1}).cast_ray({3, 4, 1}, UnitVec3::axis_z(), 10);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->distance, 0);
  EXPECT_EQ(hit->normal, (Vec3{0, 0, 1}));
}

}  // namespace
