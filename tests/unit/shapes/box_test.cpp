// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "surface_checks.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.box;

namespace {

using abut::Box;
using abut::Errc;
using abut::Vec3;
using test::made;

constexpr Vec3 half{0.5, 1, 2};

Box brick() { return made<Box>({half.x, half.y, half.z}); }
std::vector<Vec3> corners(const Vec3& halves) { return test::corners_of(halves, abut::Pose::identity()); }

TEST(Box, KeepsItsHalfExtents) {
  EXPECT_EQ(brick().parameters(), (std::vector{0.5, 1.0, 2.0}));
  EXPECT_EQ(brick().half(), half);
}

TEST(Box, BadInputIsRefusedByName) {
  test::expect_refused<Box>({-1, 1, 1}, {}, {}, Errc::out_of_range, "half_x is -1;");
  test::expect_refused<Box>({1, -0.5, 1}, {}, {}, Errc::out_of_range, "half_y is -0.5;");
  test::expect_refused<Box>({1, 1, -1e-300}, {}, {}, Errc::out_of_range, "half_z is -1e-300;");
  test::expect_refused<Box>({1, std::numeric_limits<double>::infinity(), 1}, {}, {}, Errc::not_finite,
                            "half_y is inf;");
  test::expect_refused<Box>({1, 1, 2e70}, {}, {}, Errc::out_of_range, "half_z is 2e+70;");
  test::expect_refused<Box>({1, 1}, {}, {}, Errc::invalid_argument, "parameter_count is 2;");
  test::expect_refused<Box>({1, 1, 1}, {0}, {}, Errc::invalid_argument, "real_count is 1;");
  test::expect_refused<Box>({1, 1, 1}, {}, {0, 1}, Errc::invalid_argument, "index_count is 2;");
}

TEST(Box, BoxIsTight) {
  const auto reach = [](const abut::Pose& pose, const Vec3& direction) {
    return test::furthest(test::corners_of(half, pose), direction);
  };
  test::expect_tight_boxes(brick(), reach, 2, 111);
}

TEST(Box, SupportIsTheFurthestCorner) {
  test::expect_support(brick(), corners(half), 2.3, 112);
  test::expect_support(made<Box>({1, 1, 0}), corners({1, 1, 0}), 1.5, 113);
}

TEST(Box, NumberOfACornerHasItsSigns) {
  for (std::uint32_t bits = 0; bits < 8; ++bits) {
    const Vec3 signs{bits & 1u ? 1.0 : -1.0, bits & 2u ? 1.0 : -1.0, bits & 4u ? 1.0 : -1.0};
    EXPECT_EQ(brick().support(signs).index, bits);
    EXPECT_EQ(brick().support(signs).point, (Vec3{signs.x * half.x, signs.y * half.y, signs.z * half.z}));
  }
}

TEST(Box, ReachIsTheSupportOfTheDirection) {
  test::Random random(114);
  for (int i = 0; i < 300; ++i) {
    const Vec3 direction = random.point(3);
    const abut::Pose pose{random.rotation(), random.point(5)};
    EXPECT_NEAR(brick().reach(direction), test::furthest(corners(half), direction), 1e-14);
    EXPECT_NEAR(brick().placed(pose).reach(direction),
                test::furthest(test::corners_of(half, {pose.rotation, {0, 0, 0}}), direction), 2e-14);
  }
}

TEST(Box, FacesArePlaneOutwardAndNumbered) {
  test::expect_faces(brick(), corners(half), 2.3, 115);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const abut::Face face = brick().supporting_face(test::axis_vector(axis, sign));
      EXPECT_EQ(face.index, static_cast<std::uint32_t>(2 * axis + (sign > 0 ? 1 : 0)));
      EXPECT_EQ(face.normal, test::axis_vector(axis, sign));
      EXPECT_EQ(face.vertices.size(), 4u);
    }
  }
}

// What is left of a side of a flat box has no area.
TEST(Box, SideOfAFlatBoxIsAnEdgeOrAVertex) {
  const Box plate = made<Box>({1, 2, 0});
  const abut::Face side = plate.supporting_face({1, 0, 0});
  ASSERT_EQ(side.vertices.size(), 2u);
  EXPECT_EQ(side.normal, (Vec3{0, 0, 0}));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(side.vertices[i].point.x, 1);
    EXPECT_EQ(std::fabs(side.vertices[i].point.y), 2);
  }
  EXPECT_NE(side.vertices[0].point, side.vertices[1].point);
  EXPECT_EQ(plate.supporting_face({0, 0, -1}).vertices.size(), 4u);
  const abut::Face tip = made<Box>({3, 0, 0}).supporting_face({-1, 0, 0});
  ASSERT_EQ(tip.vertices.size(), 1u);
  EXPECT_EQ(tip.vertices[0].point.x, -3);
}

TEST(Box, RaysMeetTheFirstCrossing) {
  const auto outside = [](const Vec3& p) {
    return std::fmax(std::fmax(std::fabs(p.x) - half.x, std::fabs(p.y) - half.y), std::fabs(p.z) - half.z);
  };
  test::expect_rays(brick(), outside, 2, 116);
}

TEST(Box, RaysNameTheFaceTheyMeet) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const auto inward = abut::UnitVec3::from_unit_unchecked(test::axis_vector(axis, -sign));
      const auto hit = brick().cast_ray(test::axis_vector(axis, 5 * sign), inward, 10);
      ASSERT_TRUE(hit.has_value());
      EXPECT_EQ(hit->distance, 5 - half[axis]);
      EXPECT_EQ(hit->normal, test::axis_vector(axis, sign));
      EXPECT_EQ(hit->feature,
                (abut::Feature{abut::FeatureKind::face, static_cast<std::uint32_t>(2 * axis + (sign > 0 ? 1 : 0))}));
    }
  }
}

TEST(Box, RaysMeetFlatBoxes) {
  const Box plate = made<Box>({1, 2, 0});
  const auto down = abut::UnitVec3::from_unit_unchecked({0, 0, -1});
  EXPECT_EQ(plate.cast_ray({0.5, 1.5, 3}, down, 10)->distance, 3);
  EXPECT_EQ(plate.cast_ray({0.5, 1.5, 3}, down, 10)->normal, (Vec3{0, 0, 1}));
  EXPECT_FALSE(plate.cast_ray({1.5, 1.5, 3}, down, 10).has_value());
}

void expect_closed_surface(const Box& box, const Vec3& halves) {
  const abut::Triangles surface = box.triangles();
  ASSERT_EQ(surface.vertices.size(), 8u);
  ASSERT_EQ(surface.indices.size(), 36u);
  double volume = 0;
  for (std::size_t i = 0; i < 36; i += 3) {
    const Vec3 &a = surface.vertices[surface.indices[i]], &b = surface.vertices[surface.indices[i + 1]],
               &c = surface.vertices[surface.indices[i + 2]];
    volume += dot(a, cross(b, c)) / 6;
    const Vec3 normal = cross(b - a, c - a);
    // Two triangles per face, in the order of the faces.
    const std::size_t face = i / 6;
    EXPECT_GE(normal[static_cast<int>(face / 2)] * (face % 2 == 0 ? -1 : 1), 0);
  }
  EXPECT_NEAR(volume, 8 * halves.x * halves.y * halves.z, 1e-14);
}

TEST(Box, TrianglesEncloseTheVolume) { expect_closed_surface(brick(), half); }

// Two coincident sides and four without area: twelve triangles as for any box.
TEST(Box, FlatBoxesHaveTrianglesToo) {
  for (const Vec3& halves : {Vec3{1, 2, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 0}}) {
    const abut::Triangles surface = made<Box>({halves.x, halves.y, halves.z}).triangles();
    EXPECT_EQ(surface.indices.size(), 36u);
    EXPECT_EQ(surface.vertices.size(), 8u);
  }
}

}  // namespace
