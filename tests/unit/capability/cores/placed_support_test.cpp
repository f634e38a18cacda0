// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "../../shapes/surface_checks.hpp"

import abut.capability;
import abut.math;

namespace {

using abut::Pose;
using abut::Vec3;

TEST(Place, PointIsItsOwnSupport) {
  const abut::PlacedPoint point{{1, 2, 3}};
  EXPECT_EQ(point.support({5, -1, 0}).point, (Vec3{1, 2, 3}));
  EXPECT_EQ(point.reach({5, -1, 0}), 0);
}

TEST(Place, SegmentReachesToItsEnds) {
  test::Random random(241);
  for (int i = 0; i < 500; ++i) {
    const abut::PlacedSegment segment{random.point(5), random.point(2)};
    const Vec3 direction = random.point(3);
    const std::vector<Vec3> ends{segment.centre - segment.half, segment.centre + segment.half};
    const abut::SupportPoint top = segment.support(direction);
    EXPECT_EQ(top.point, ends[top.index]);
    EXPECT_NEAR(dot(top.point, direction), test::furthest(ends, direction), 1e-14);
    EXPECT_NEAR(segment.reach(direction), test::furthest(ends, direction) - dot(segment.centre, direction), 3e-14);
  }
}

// A shape without a way of its own is asked in its frame, and answers in the world.
TEST(Place, SupportIsThatOfThePlacedCorners) {
  test::Random random(242);
  for (int i = 0; i < 500; ++i) {
    const abut::Triangle shape(random.point(1), random.point(1), random.point(1), 0, false);
    const Pose pose{random.rotation(), random.point(5)};
    const Vec3 direction = test::towards(random);
    std::vector<Vec3> corners;
    for (const Vec3& corner : shape.corners()) {
      corners.push_back(pose * corner);
    }
    const abut::SupportPoint top = placed_support(shape, place(shape, pose), direction);
    EXPECT_NEAR(dot(top.point, direction), test::furthest(corners, direction), 1e-14);
    EXPECT_EQ(top.point, corners[top.index]);
  }
}

TEST(Place, FaceIsMovedWithItsNormal) {
  test::Random random(243);
  for (int i = 0; i < 500; ++i) {
    const abut::Triangle shape(random.point(1), random.point(1), random.point(1), 0, false);
    const Pose pose{random.rotation(), random.point(5)};
    const Vec3 direction = test::towards(random);
    const abut::Face face = placed_face(shape, pose, direction);
    ASSERT_EQ(face.vertices.size(), 3u);
    EXPECT_GE(dot(face.normal, direction), -1e-15);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(face.vertices[k].point, pose * shape.corners()[face.vertices[k].vertex]);
      EXPECT_NEAR(dot(face.normal, face.vertices[k].point - face.vertices[0].point), 0, 1e-13);
    }
  }
}

}  // namespace
