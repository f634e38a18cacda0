// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

import abut.math;
import abut.narrow.many.claims;

namespace {

using abut::Claims;
using abut::Vec3;

constexpr Vec3 x{1, 0, 0}, z{0, 0, 1};

// What the claims leave of a depth of 0.9 along z, to a triangle that is parted by `overlap` along any direction.
double left_of(const Claims& claims, double overlap) {
  return claims.allowed_depth(z, 0.9, 1e-15, [&](const Vec3&) { return overlap; });
}

TEST(Claims, LeaveAllWhereThereIsNone) { EXPECT_EQ(left_of({}, 0), abut::infinity); }

TEST(Claims, TakeWhatAnotherWayOutParts) {
  Claims claims;
  claims.add(x, 0.1, false);
  EXPECT_NEAR(left_of(claims, 0.05), 0, 1e-5);
  EXPECT_EQ(left_of(claims, 0.2), abut::infinity);  // the other way leaves an overlap here
}

TEST(Claims, LeaveWhatPointsTheSameWay) {
  Claims claims;
  claims.add(z, 0.9, false);
  EXPECT_EQ(left_of(claims, 0.9), abut::infinity);
}

TEST(Claims, OfTwoTurnedOnesTheLessDeepOneIsRight) {
  Claims claims;
  claims.add(x, 0.95, true);
  EXPECT_EQ(left_of(claims, 0.05), abut::infinity);
  claims.add({0, 1, 0}, 0.5, true);
  EXPECT_NEAR(left_of(claims, 0.05), 0, 1e-5);
}

TEST(Claims, OfLikeNormalsTheDeepestCounts) {
  Claims claims;
  claims.add(x, 0.1, false);
  claims.add(x, 0.3, false);
  EXPECT_NEAR(left_of(claims, 0.25), 0, 1e-5);
}

}  // namespace
