// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;

namespace {

using abut::Vec3;

TEST(Rim, CosinesAreThoseOfSixteenthsOfATurn) {
  for (std::uint32_t corner = 0; corner < 48; ++corner) {
    EXPECT_NEAR(abut::rim_cosine(corner), std::cos(corner * std::numbers::pi / 8), 4e-15) << corner;
    EXPECT_EQ(abut::rim_cosine(corner), -abut::rim_cosine(corner + 8)) << corner;
    EXPECT_EQ(abut::rim_cosine(corner), abut::rim_cosine(48 - corner)) << corner;
  }
  EXPECT_EQ(abut::rim_cosine(1), std::cos(std::numbers::pi / 8));
  EXPECT_EQ(abut::rim_cosine(2), std::numbers::sqrt2 / 2);
  EXPECT_EQ(abut::rim_cosine(3), std::sin(std::numbers::pi / 8));
}

// Corner k lies k sixteenths of a turn from X towards Y. Edge k leads from it to corner k + 1, whichever way the disc
// looks.
void expect_rim(bool up, std::uint32_t first) {
  const abut::Face face = abut::rim_face({2.5, -0.75, up, 7, first});
  ASSERT_EQ(face.vertices.size(), 16u);
  EXPECT_EQ(face.index, 7u);
  EXPECT_EQ(face.normal, (Vec3{0, 0, up ? 1.0 : -1.0}));
  std::uint32_t corners_seen = 0, edges_seen = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    const abut::FaceVertex &here = face.vertices[i], &next = face.vertices[(i + 1) % 16],
                           &after = face.vertices[(i + 2) % 16];
    const std::uint32_t corner = here.vertex - first, edge = here.edge - first, to = next.vertex - first;
    ASSERT_LT(corner, 16u);
    ASSERT_LT(edge, 16u);
    corners_seen |= 1u << corner;
    edges_seen |= 1u << edge;
    const double angle = corner * std::numbers::pi / 8;
    EXPECT_NEAR(here.point.x, 2.5 * std::cos(angle), 4e-15);
    EXPECT_NEAR(here.point.y, 2.5 * std::sin(angle), 4e-15);
    EXPECT_EQ(here.point.z, -0.75);
    EXPECT_EQ(up ? corner : to, edge);
    EXPECT_EQ(up ? to : corner, (edge + 1) % 16);
    EXPECT_GT(dot(face.normal, cross(next.point - here.point, after.point - next.point)), 0);
  }
  EXPECT_EQ(corners_seen, 0xffffu);
  EXPECT_EQ(edges_seen, 0xffffu);
}

TEST(Rim, FacesAreCounterClockwiseAndNumberedByTheirCorners) {
  for (const std::uint32_t first : {0u, 16u}) {
    expect_rim(true, first);
    expect_rim(false, first);
  }
}

TEST(Rim, SidewaysIsThePartAcrossZ) {
  test::Random random(331);
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.uniform(-4, 4);
    for (const double length : {1.0, 1e-3, 1e50, 1e-130, 1e-150, 1e-200, 1e-300}) {
      const abut::Sideways side =
          abut::sideways_of({length * std::cos(angle), length * std::sin(angle), random.uniform(-1, 1)});
      ASSERT_NEAR(side.x, std::cos(angle), 1e-15) << "seed 331, length " << length;
      ASSERT_NEAR(side.y, std::sin(angle), 1e-15) << "seed 331, length " << length;
      ASSERT_NEAR(side.length / length, 1, 1e-15) << "seed 331, length " << length;
    }
  }
}

// Numbers without all their digits still have a direction, and what has none is taken for X.
TEST(Rim, SidewaysOfTheLeastNumbersAndOfNone) {
  const double least = 5e-324;
  EXPECT_EQ(abut::sideways_of({0, -least, 1}).x, 0);
  EXPECT_EQ(abut::sideways_of({0, -least, 1}).y, -1);
  EXPECT_NEAR(abut::sideways_of({least, least, 0}).x, std::numbers::sqrt2 / 2, 1e-15);
  for (const Vec3& along : {Vec3{0, 0, 1}, Vec3{0, 0, -3}, Vec3{0, 0, 0}, Vec3{-0.0, -0.0, 1e-200}}) {
    const abut::Sideways side = abut::sideways_of(along);
    EXPECT_EQ(side.x, 1);
    EXPECT_EQ(side.y, 0);
    EXPECT_EQ(side.length, 0);
  }
}

}  // namespace
