// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.shapes.box;
import abut.shapes.hull;

namespace {

using abut::Face;
using abut::FewCorners;
using abut::Pose;
using abut::Vec3;

// A face of more than four corners, or without an area, stands for none.
void expect_face(const FewCorners& found, const Face& face) {
  if (!has_few_corners(face)) {
    EXPECT_EQ(found.normal, (Vec3{0, 0, 0}));
    return;
  }
  EXPECT_EQ(found.normal, face.normal);
  EXPECT_EQ(found.index, face.index);
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const abut::FaceVertex& vertex = face.vertices[lane < face.vertices.size() ? lane : face.vertices.size() - 1];
    EXPECT_EQ(found.at[lane], vertex.point);
    EXPECT_EQ(found.vertices[lane], vertex.vertex);
    EXPECT_EQ(found.edges[lane], vertex.edge);
  }
}

template <class S>
void expect_faces(const S& shape, std::uint64_t seed) {
  test::Random random(seed);
  for (int i = 0; i < 200; ++i) {
    const Vec3 direction = random.point(1);
    const Pose pose{random.rotation(), random.point(5)};
    expect_face(few_corners(shape, direction, {}), shape.supporting_face(direction));
    expect_face(placed_few_corners(shape, pose, direction, {}), placed_face(shape, pose, direction));
  }
}

std::vector<double> random_points(std::size_t count, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<double> xyz;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 point = random.point(1);
    xyz.insert(xyz.end(), {point.x, point.y, point.z});
  }
  return xyz;
}

TEST(FewCorners, AreThoseOfTheFaceOfATriangle) {
  test::Random random(51);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    expect_faces(abut::Triangle(random.point(1), random.point(1), random.point(1), 0, false), seed);
  }
}

TEST(FewCorners, AreThoseOfTheSidesOfABox) {
  const double half[]{0.5, 1, 2};
  expect_faces(abut::Box::make(half, {}, {}).value(), 52);
}

TEST(FewCorners, OfAFlatBoxAreNone) {
  for (int axis = 0; axis < 3; ++axis) {
    double half[]{0.5, 1, 2};
    half[axis] = 0;
    const auto box = abut::Box::make(half, {}, {}).value();
    test::Random random(53);
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(box.few_corners(random.point(1)).normal, (Vec3{0, 0, 0}));
    }
  }
}

TEST(FewCorners, AreThoseOfTheFaceOfAHull) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    expect_faces(abut::Hull::make({}, random_points(24, seed), {}).value(), seed);
  }
}

// The sides of a prism have four corners, its ends have six.
TEST(FewCorners, OfAFaceOfSixCornersAreNone) {
  std::vector<double> xyz;
  for (const double z : {-1.0, 1.0}) {
    xyz.insert(xyz.end(), {1, 0, z, 0.5, 0.8, z, -0.5, 0.8, z, -1, 0, z, -0.5, -0.8, z, 0.5, -0.8, z});
  }
  const auto prism = abut::Hull::make({}, xyz, {}).value();
  EXPECT_EQ(prism.few_corners({0, 0, 1}).normal, (Vec3{0, 0, 0}));
  EXPECT_EQ(prism.few_corners({0, 1, 0}).normal, (Vec3{0, 1, 0}));
  expect_faces(prism, 54);
}

// A point and a segment have no face.
TEST(FewCorners, OfAHullWithoutFacesAreNone) {
  const auto segment = abut::Hull::make({}, std::vector<double>{0, 0, 0, 1, 1, 1}, {}).value();
  EXPECT_EQ(segment.few_corners({0, 0, 1}).normal, (Vec3{0, 0, 0}));
}

}  // namespace
