// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.sphere;

namespace {

using abut::Errc;
using abut::Sphere;
using abut::Vec3;
using test::made;

TEST(Sphere, KeepsItsRadius) {
  const Sphere sphere = made<Sphere>({2.5});
  EXPECT_EQ(sphere.parameters(), (std::vector{2.5}));
  EXPECT_EQ(sphere.radius(), 2.5);
}

TEST(Sphere, BadInputIsRefusedByName) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  test::expect_refused<Sphere>({0}, {}, {}, Errc::out_of_range, "radius is 0;");
  test::expect_refused<Sphere>({-2.5}, {}, {}, Errc::out_of_range, "radius is -2.5;");
  test::expect_refused<Sphere>({infinite}, {}, {}, Errc::not_finite, "radius is inf;");
  test::expect_refused<Sphere>({std::fabs(std::nan(""))}, {}, {}, Errc::not_finite, "radius is nan;");
  test::expect_refused<Sphere>({1e71}, {}, {}, Errc::out_of_range, "radius is 1e+71;");
  test::expect_refused<Sphere>({}, {}, {}, Errc::invalid_argument, "parameter_count is 0;");
  test::expect_refused<Sphere>({1, 2}, {}, {}, Errc::invalid_argument, "parameter_count is 2;");
  test::expect_refused<Sphere>({1}, {1, 2, 3}, {}, Errc::invalid_argument, "real_count is 3;");
  test::expect_refused<Sphere>({1}, {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

TEST(Sphere, BoxIsTight) {
  test::expect_tight_boxes(
      made<Sphere>({1.5}),
      [](const abut::Pose& pose, const Vec3& direction) { return dot(pose.position, direction) + 1.5; }, 1.5, 101);
}

TEST(Sphere, CoreIsItsCentre) {
  const Sphere sphere = made<Sphere>({1.5});
  test::expect_support(sphere, {{0, 0, 0}}, 1.5, 102);
  const abut::Face face = sphere.supporting_face({1, 2, 3});
  ASSERT_EQ(face.vertices.size(), 1u);
  EXPECT_EQ(face.vertices[0].point, (Vec3{0, 0, 0}));
  EXPECT_EQ(face.normal, (Vec3{0, 0, 0}));
  EXPECT_EQ(sphere.extent(), 0);
}

TEST(Sphere, RaysMeetTheFirstCrossing) {
  for (const double radius : {1e-3, 1.0, 50.0}) {
    test::expect_rays(
        made<Sphere>({radius}), [radius](const Vec3& p) { return std::hypot(p.x, p.y, p.z) - radius; }, radius, 103);
  }
}

TEST(Sphere, RaysFromTheCentreAndTheSurface) {
  const Sphere sphere = made<Sphere>({2});
  const auto up = abut::UnitVec3::axis_z();
  EXPECT_EQ(sphere.cast_ray({0, 0, 0}, up, 10)->distance, 2);
  EXPECT_EQ(sphere.cast_ray({0, 0, 0}, up, 10)->normal, (Vec3{0, 0, 1}));
  EXPECT_EQ(sphere.cast_ray({0, 0, -2}, up, 10)->distance, 0);
  EXPECT_EQ(sphere.cast_ray({0, 0, -2}, up, 10)->normal, (Vec3{0, 0, -1}));
  EXPECT_FALSE(sphere.cast_ray({0, 0, 2.5}, up, 10).has_value());
}

// From a million radii away the first crossing is still found to the rounding of the origin.
TEST(Sphere, RaysFromFarAwayKeepTheirDigits) {
  const Sphere sphere = made<Sphere>({1});
  test::Random random(104);
  for (int i = 0; i < 300; ++i) {
    const Vec3 direction = test::towards(random), on_surface = test::towards(random);
    const double facing = dot(direction, on_surface);
    if (facing > -0.1) {
      continue;
    }
    const auto hit =
        sphere.cast_ray(on_surface - 1e6 * direction, abut::UnitVec3::from_unit_unchecked(direction), abut::infinity);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, 1e6, 1e-8);
    EXPECT_NEAR(dot(hit->normal, on_surface), 1, 1e-14);
  }
}

}  // namespace
