// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.segment;

namespace {

using abut::Errc;
using abut::Segment;
using abut::Vec3;
using test::made;

constexpr double half_length = 1.5;

Segment rod() { return made<Segment>({half_length}); }

TEST(Segment, KeepsItsHalfLength) {
  EXPECT_EQ(rod().parameters(), std::vector{half_length});
  EXPECT_EQ(rod().half(), (Vec3{0, 0, half_length}));
  EXPECT_EQ(rod().radius(), 0);
  EXPECT_EQ(rod().extent(), half_length);
}

TEST(Segment, BadInputIsRefusedByName) {
  test::expect_refused<Segment>({-1}, {}, {}, Errc::out_of_range, "half_length is -1; it must be zero or positive");
  test::expect_refused<Segment>({2e70}, {}, {}, Errc::out_of_range,
                                "half_length is 2e+70; it must be at most 1e70 in magnitude");
  test::expect_refused<Segment>({std::numeric_limits<double>::quiet_NaN()}, {}, {}, Errc::not_finite,
                                "half_length is nan;");
  test::expect_refused<Segment>({std::numeric_limits<double>::infinity()}, {}, {}, Errc::not_finite,
                                "half_length is inf; it must be finite");
  test::expect_refused<Segment>({}, {}, {}, Errc::invalid_argument, "parameter_count is 0; it must be 1");
  test::expect_refused<Segment>({1, 1}, {}, {}, Errc::invalid_argument, "parameter_count is 2;");
  test::expect_refused<Segment>({1}, {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Segment>({1}, {}, {0}, Errc::invalid_argument, "index_count is 1;");
}

TEST(Segment, BoxIsTight) {
  const auto reach = [](const abut::Pose& pose, const Vec3& direction) {
    return test::furthest({pose * Vec3{0, 0, half_length}, pose * Vec3{0, 0, -half_length}}, direction);
  };
  test::expect_tight_boxes(rod(), reach, 2, 311);
}

TEST(Segment, CoreIsItself) {
  test::expect_support(rod(), {{0, 0, half_length}, {0, 0, -half_length}}, 2, 312);
  EXPECT_EQ(rod().support({0, 0, 1}).index, 1u);
  EXPECT_EQ(rod().support({0, 0, -1}).index, 0u);
  EXPECT_EQ(rod().support({1e-200, 0, 1e-200}).point, (Vec3{0, 0, half_length}));
  EXPECT_EQ(rod().support({1e-200, 0, -1e-200}).point, (Vec3{0, 0, -half_length}));
  test::Random random(313);
  for (int i = 0; i < 300; ++i) {
    const Vec3 direction = random.point(3);
    const abut::Pose pose{random.rotation(), random.point(5)};
    EXPECT_NEAR(rod().reach(direction), std::fmax(half_length * direction.z, -half_length * direction.z), 1e-15)
        << "seed 313";
    const Vec3 end = pose.rotation * Vec3{0, 0, half_length};
    EXPECT_NEAR(rod().placed(pose).reach(direction), test::furthest({end, -end}, direction), 1e-14) << "seed 313";
  }
}

TEST(Segment, FaceIsTheWholeSegment) {
  for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1e-200, -1e-200}}) {
    const abut::Face face = rod().supporting_face(direction);
    ASSERT_EQ(face.vertices.size(), 2u);
    EXPECT_EQ(face.normal, (Vec3{0, 0, 0}));
    EXPECT_EQ(face.vertices[0].point, (Vec3{0, 0, -half_length}));
    EXPECT_EQ(face.vertices[1].point, (Vec3{0, 0, half_length}));
    EXPECT_EQ(face.vertices[0].vertex, 0u);
    EXPECT_EQ(face.vertices[1].vertex, 1u);
    EXPECT_EQ(face.vertices[0].edge, face.vertices[1].edge);
    EXPECT_EQ(abut::supporting_feature(rod(), direction), abut::feature_of(face));
  }
}

TEST(Segment, WithoutLengthItIsAPoint) {
  const Segment point = made<Segment>({0});
  const abut::Face face = point.supporting_face({1, 2, 3});
  ASSERT_EQ(face.vertices.size(), 1u);
  EXPECT_EQ(face.vertices[0].point, (Vec3{0, 0, 0}));
  EXPECT_EQ(abut::supporting_feature(point, {1, 2, 3}), (abut::Feature{abut::FeatureKind::vertex, 0}));
  EXPECT_EQ(point.support({1, 2, 3}).point, (Vec3{0, 0, 0}));
}

TEST(Segment, NoRayMeetsIt) {
  const auto up = abut::UnitVec3::axis_z(), across = abut::UnitVec3::from_unit_unchecked({1, 0, 0});
  EXPECT_FALSE(rod().cast_ray({0, 0, -5}, up, 10).has_value());
  EXPECT_FALSE(rod().cast_ray({-1, 0, 0}, across, 10).has_value());
}

}  // namespace
