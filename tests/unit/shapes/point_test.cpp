// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.point;

namespace {

using abut::Errc;
using abut::Point;
using abut::Vec3;
using test::made;

Point dot_shape() { return made<Point>({}); }

TEST(Point, HasNoParameters) {
  EXPECT_EQ(dot_shape().parameters(), std::vector<double>{});
  EXPECT_EQ(dot_shape().half(), (Vec3{0, 0, 0}));
  EXPECT_EQ(dot_shape().radius(), 0);
  EXPECT_EQ(dot_shape().extent(), 0);
}

TEST(Point, BadInputIsRefusedByName) {
  test::expect_refused<Point>({1}, {}, {}, Errc::invalid_argument, "parameter_count is 1; it must be 0");
  test::expect_refused<Point>({}, {0}, {}, Errc::invalid_argument, "real_count is 1; it must be 0");
  test::expect_refused<Point>({}, {}, {0, 1}, Errc::invalid_argument, "index_count is 2; it must be 0");
}

TEST(Point, BoxIsTight) {
  test::expect_tight_boxes(
      dot_shape(), [](const abut::Pose& pose, const Vec3& direction) { return dot(pose.position, direction); }, 0, 301);
}

TEST(Point, CoreIsItself) {
  test::expect_support(dot_shape(), {{0, 0, 0}}, 1, 302);
  for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{1e-200, 0, 1e-200}, Vec3{0, 0, 0}}) {
    EXPECT_EQ(dot_shape().support(direction).point, (Vec3{0, 0, 0}));
    EXPECT_EQ(dot_shape().support(direction).index, 0u);
    EXPECT_EQ(dot_shape().reach(direction), 0);
    const abut::Face face = dot_shape().supporting_face(direction);
    ASSERT_EQ(face.vertices.size(), 1u);
    EXPECT_EQ(face.vertices[0].point, (Vec3{0, 0, 0}));
    EXPECT_EQ(face.vertices[0].vertex, 0u);
    EXPECT_EQ(face.normal, (Vec3{0, 0, 0}));
    EXPECT_EQ(abut::supporting_feature(dot_shape(), direction), (abut::Feature{abut::FeatureKind::vertex, 0}));
  }
}

TEST(Point, NoRayMeetsIt) {
  const auto up = abut::UnitVec3::axis_z();
  EXPECT_FALSE(dot_shape().cast_ray({0, 0, -1}, up, 10).has_value());
  EXPECT_FALSE(dot_shape().cast_ray({0, 0, 0}, up, 10).has_value());
}

}  // namespace
