// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.points.closest_of_faces;

namespace {

using abut::Face;
using abut::Vec3;

constexpr Vec3 up{0, 0, 1};
constexpr double slack = 1e-12;

Face face_of(const std::vector<Vec3>& corners, const Vec3& normal) {
  Face face;
  face.normal = normal;
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    face.vertices.push_back({corners[i], i, i});
  }
  return face;
}

void expect_across(const abut::AcrossPair& pair, double height) {
  EXPECT_NEAR(pair.point_b.x, pair.point_a.x, 1e-12);
  EXPECT_NEAR(pair.point_b.y, pair.point_a.y, 1e-12);
  EXPECT_NEAR(pair.point_b.z - pair.point_a.z, height, 1e-12);
}

const Face square = face_of({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, up);

TEST(Across, CornerOverAFace) {
  const abut::AcrossPair pair = abut::points_across(square, face_of({{0.25, 0.5, -0.125}}, {0, 0, 0}), up, slack);
  expect_across(pair, -0.125);
  EXPECT_EQ(pair.point_b, (Vec3{0.25, 0.5, -0.125}));
}

TEST(Across, EdgesThatCross) {
  const Face along_x = face_of({{-3, 0.5, 0}, {1, 0.5, 0}}, {0, 0, 0}),
             along_y = face_of({{-2, -1, 0.5}, {-2, 4, 0.5}}, {0, 0, 0});
  const abut::AcrossPair pair = abut::points_across(along_x, along_y, up, slack);
  expect_across(pair, 0.5);
  EXPECT_NEAR(pair.point_a.x, -2, 1e-12);
  EXPECT_NEAR(pair.point_a.y, 0.5, 1e-12);
}

TEST(Across, EdgesThatShareAStretch) {
  const Face one = face_of({{0, 0, 0}, {4, 0, 0}}, {0, 0, 0}), other = face_of({{3, 0, 1}, {9, 0, 1}}, {0, 0, 0});
  const abut::AcrossPair pair = abut::points_across(one, other, up, slack);
  expect_across(pair, 1);
  EXPECT_GE(pair.point_a.x, 3 - 1e-12);
  EXPECT_LE(pair.point_a.x, 4 + 1e-12);
}

// Only what is outermost counts: a face that leans over touches with one of its edges.
TEST(Across, LeaningFaceTouchesWithItsLowestEdge) {
  const Face leaning = face_of({{-0.5, 9, 5}, {-0.5, -9, 5}, {0.5, -9, 0.1}, {0.5, 9, 0.1}}, {-0.98, 0, -0.2});
  const abut::AcrossPair pair = abut::points_across(square, leaning, up, slack);
  expect_across(pair, 0.1);
  EXPECT_NEAR(pair.point_b.x, 0.5, 1e-12);
}

TEST(Across, LeastAsideWhereNothingMeets) {
  const abut::AcrossPair pair = abut::points_across(square, face_of({{5, 0, 2}}, {0, 0, 0}), up, slack);
  EXPECT_NEAR(pair.point_a.x, 1, 1e-12);
  EXPECT_NEAR(pair.point_a.y, 0, 1e-12);
  EXPECT_EQ(pair.point_b, (Vec3{5, 0, 2}));
}

// Beyond the end of a needle all its edges run by within rounding, on sides that say nothing.
TEST(Across, BesideTheEndOfANeedle) {
  test::Random random(82);
  for (int i = 0; i < 2000; ++i) {
    const double turn = random.uniform(0, 6), width = 1e-14 * random.uniform(0, 2), beyond = random.uniform(0.01, 1);
    const Vec3 along{std::cos(turn), std::sin(turn), 0}, aside{-along.y, along.x, 0}, start = random.point(1);
    const Face needle = face_of({start, start + along, start + 0.5 * along + width * aside}, up);
    const Vec3 tip = start - beyond * along + random.uniform(-1e-15, 1e-15) * aside;
    const abut::AcrossPair pair = abut::points_across(needle, face_of({tip}, {0, 0, 0}), up, slack);
    EXPECT_GE(abut::dot(pair.point_a - start, along), -1e-12) << i;
  }
}

TEST(Across, RandomSquaresThatOverlap) {
  test::Random random(81);
  for (int i = 0; i < 1000; ++i) {
    const double turn = random.uniform(0, 6), c = std::cos(turn), s = std::sin(turn);
    const Vec3 centre{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), 0.25};
    const Face other = face_of({centre + Vec3{-c + s, -s - c, 0}, centre + Vec3{-c - s, -s + c, 0},
                                centre + Vec3{c - s, s + c, 0}, centre + Vec3{c + s, s - c, 0}},
                               -up);
    const abut::AcrossPair pair = abut::points_across(square, other, up, slack);
    // Where the circle inside the other one reaches into the square, they overlap.
    if (std::fabs(centre.x) < 1.4 && std::fabs(centre.y) < 1.4) {
      expect_across(pair, 0.25);
      EXPECT_LE(std::fmax(std::fabs(pair.point_a.x), std::fabs(pair.point_a.y)), 1 + 1e-12);
    }
  }
}

}  // namespace
