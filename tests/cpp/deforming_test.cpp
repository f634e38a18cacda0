// SPDX-License-Identifier: Apache-2.0
// Vertices on straight lines.
#include <abut/abut.hpp>
#include <gtest/gtest.h>

#include <vector>

namespace {

// A vertex over a triangle that stays, and the same with two edges that cross.
const std::vector<double> over{0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0},
    below{0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<double> edges_over{-1, 0, 0, 1, 0, 0, 0, -1, 1, 0, 1, 1},
    edges_below{-1, 0, 0, 1, 0, 0, 0, -1, -1, 0, 1, -1};

TEST(Deforming, TellsTheFirstTouch) {
  const std::vector<abut::FirstTouch> touches = abut::vertices_touch_faces(over, below);
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].touches, 1U);
  EXPECT_NEAR(touches[0].upper, 0.5, 1e-9);
  EXPECT_EQ(abut::vertices_touch_faces(over, over)[0].touches, 0U);
  EXPECT_NEAR(abut::edges_touch_edges(edges_over, edges_below)[0].upper, 0.5, 1e-9);
}

TEST(Deforming, TakesASeparation) {
  abut::TouchOptions near;
  near.separation = 0.25;
  EXPECT_NEAR(abut::edges_touch_edges(edges_over, edges_below, near)[0].upper, 0.375, 1e-8);
}

TEST(Deforming, RefusesPartsOfAQuery) {
  const std::vector<double> eleven(11);
  EXPECT_THROW(static_cast<void>(abut::vertices_touch_faces(eleven, eleven)), abut::Error);
  EXPECT_THROW(static_cast<void>(abut::edges_touch_edges(over, {})), abut::Error);
}

}  // namespace
