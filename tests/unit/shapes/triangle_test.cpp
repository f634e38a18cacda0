// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.triangle;

namespace {

using abut::Errc;
using abut::FreeTriangle;
using abut::Vec3;
using test::made;

constexpr Vec3 a{1, 0, 0.5}, b{-0.5, 0.8, 0}, c{-0.5, -0.8, -0.25};

FreeTriangle kite() { return made<FreeTriangle>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}); }

TEST(FreeTriangle, KeepsItsCorners) {
  EXPECT_EQ(kite().parameters(), (std::vector{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z}));
  EXPECT_EQ(kite().corners()[0], a);
  EXPECT_EQ(kite().corners()[1], b);
  EXPECT_EQ(kite().corners()[2], c);
  EXPECT_FALSE(kite().is_one_sided());
  EXPECT_EQ(kite().index(), 0u);
}

TEST(FreeTriangle, BadInputIsRefusedByName) {
  const std::vector<const char*> names{"a_x", "a_y", "a_z", "b_x", "b_y", "b_z", "c_x", "c_y", "c_z"};
  for (std::size_t i = 0; i < 9; ++i) {
    std::vector<double> numbers(9, 1);
    numbers[i] = std::numeric_limits<double>::infinity();
    test::expect_refused<FreeTriangle>(numbers, {}, {}, Errc::not_finite,
                                       std::string(names[i]) + " is inf; it must be finite");
    numbers[i] = -2e70;
    test::expect_refused<FreeTriangle>(numbers, {}, {}, Errc::out_of_range,
                                       std::string(names[i]) + " is -2e+70; it must be at most 1e70");
  }
  test::expect_refused<FreeTriangle>({1, 2, 3}, {}, {}, Errc::invalid_argument, "parameter_count is 3; it must be 9");
  test::expect_refused<FreeTriangle>(std::vector<double>(10), {}, {}, Errc::invalid_argument, "parameter_count is 10;");
  test::expect_refused<FreeTriangle>(std::vector<double>(9), {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<FreeTriangle>(std::vector<double>(9), {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

TEST(FreeTriangle, BoxIsTight) {
  const auto reach = [](const abut::Pose& pose, const Vec3& direction) {
    return test::furthest({pose * a, pose * b, pose * c}, direction);
  };
  test::expect_tight_boxes(kite(), reach, 1, 321);
}

TEST(FreeTriangle, SupportIsTheFurthestCorner) {
  test::expect_support(kite(), {a, b, c}, 1.2, 322);
  EXPECT_EQ(kite().support({1e-200, 0, 0}).point, a);
  EXPECT_EQ(kite().support({0, 1e-200, 0}).point, b);
  EXPECT_EQ(kite().support({0, -1e-200, 0}).point, c);
  EXPECT_EQ(kite().support({0, -1, 0}).index, 2u);
}

TEST(FreeTriangle, BothSidesAreFaces) {
  const Vec3 front = cross(b - a, c - a);
  for (const double sign : {1.0, -1.0}) {
    const abut::Face face = kite().supporting_face(sign * front);
    ASSERT_EQ(face.vertices.size(), 3u);
    EXPECT_NEAR(dot(face.normal, sign * front), std::sqrt(dot(front, front)), 1e-15);
    const Vec3 &p = face.vertices[0].point, &q = face.vertices[1].point, &r = face.vertices[2].point;
    EXPECT_GT(dot(cross(q - p, r - p), sign * front), 0);
  }
}

TEST(FreeTriangle, RaysMeetItFromBothSides) {
  const Vec3 front = cross(b - a, c - a), unit = (1 / std::sqrt(dot(front, front))) * front;
  test::Random random(323);
  for (int i = 0; i < 2000; ++i) {
    const double u = random.uniform(-0.5, 1.5), v = random.uniform(-0.5, 1.5),
                 least = std::fmin(std::fmin(u, v), 1 - u - v);
    const Vec3 target = (1 - u - v) * a + u * b + v * c, direction = test::towards(random);
    if (std::fabs(least) < 1e-9 || std::fabs(dot(direction, unit)) < 0.05) {
      continue;
    }
    const auto way = abut::UnitVec3::from_unit_unchecked(direction);
    const auto hit = kite().cast_ray(target - 3 * direction, way, 10);
    ASSERT_EQ(hit.has_value(), least > 0) << "seed 323, ray " << i;
    if (hit) {
      EXPECT_NEAR(hit->distance, 3, 1e-13) << "seed 323, ray " << i;
      EXPECT_LE(largest_magnitude(hit->normal - unit), 1e-15);  // by winding
      EXPECT_EQ(hit->feature, (abut::Feature{abut::FeatureKind::face, 0}));
      EXPECT_FALSE(kite().cast_ray(target - 3 * direction, way, 2.99).has_value());
      EXPECT_FALSE(kite().cast_ray(target + 3 * direction, way, 10).has_value());
    }
  }
}

TEST(FreeTriangle, RaysMissWhatHasNoArea) {
  const FreeTriangle line = made<FreeTriangle>({-1, 0, 0, 0, 0, 0, 1, 0, 0});
  const FreeTriangle point = made<FreeTriangle>({1, 2, 3, 1, 2, 3, 1, 2, 3});
  EXPECT_FALSE(line.has_area());
  EXPECT_FALSE(point.has_area());
  const auto down = abut::UnitVec3::from_unit_unchecked({0, 0, -1});
  EXPECT_FALSE(line.cast_ray({0.5, 0, 3}, down, 10).has_value());
  EXPECT_FALSE(point.cast_ray({1, 2, 5}, down, 10).has_value());
}

TEST(FreeTriangle, SurfaceIsItself) {
  const abut::Triangles surface = kite().triangles();
  EXPECT_EQ(surface.vertices, (std::vector<Vec3>{a, b, c}));
  EXPECT_EQ(surface.indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
