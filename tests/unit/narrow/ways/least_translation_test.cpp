// SPDX-License-Identifier: Apache-2.0
// The shortest translation out of some half-spaces, against Dykstra's projections, which share no code with it.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.narrow.ways.least_translation;

namespace {

using abut::HalfSpaceToLeave;
using abut::Vec3;

// Boyle, Dykstra, "A method for finding projections onto the intersection of convex sets in Hilbert spaces", 1986.
Vec3 projected_origin(const std::vector<HalfSpaceToLeave>& planes) {
  constexpr int rounds = 20000;
  Vec3 move{0, 0, 0};
  std::vector<Vec3> corrections(planes.size(), Vec3{0, 0, 0});
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const Vec3 from = move + corrections[i];
      const double lacks = planes[i].least - dot(planes[i].normal, from);
      move = lacks > 0 ? from + lacks * planes[i].normal : from;
      corrections[i] = from - move;
    }
  }
  return move;
}

TEST(LeastTranslation, IsTheProjectionOfTheOrigin) {
  constexpr std::uint64_t seed = 7;
  test::Random random(seed);
  for (int scene = 0; scene < 200; ++scene) {
    std::vector<HalfSpaceToLeave> planes;
    const int count = 1 + scene % 7;
    for (int i = 0; i < count; ++i) {
      // All lead up, so that a translation leaves all.
      const Vec3 normal = random.point(1) + Vec3{0, 0, 1.5};
      planes.push_back({(1 / norm(normal)) * normal, random.uniform(0, 1)});
    }
    const auto found = abut::least_translation(planes);
    ASSERT_TRUE(found) << "scene " << scene << " of seed " << seed;
    EXPECT_NEAR(norm(*found), norm(projected_origin(planes)), 1e-7) << "scene " << scene << " of seed " << seed;
    for (const HalfSpaceToLeave& plane : planes) {
      EXPECT_GE(dot(plane.normal, *found), plane.least - 1e-10) << "scene " << scene << " of seed " << seed;
    }
  }
}

TEST(LeastTranslation, IsNoneBetweenPlanesThatFaceEachOther) {
  const std::vector<HalfSpaceToLeave> jammed{{{0, 0, 1}, 0.5}, {{0, 0, -1}, 0.5}};
  EXPECT_FALSE(abut::least_translation(jammed));
}

}  // namespace
