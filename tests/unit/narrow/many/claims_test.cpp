// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

import abut.math;
import abut.math.four_vec3;
import abut.narrow.many.claims;

namespace {

using abut::Claims;
using abut::Vec3;

constexpr Vec3 x{1, 0, 0}, z{0, 0, 1};

// What the claims leave of a depth of 0.9 along z, to a triangle that is parted by `overlap` along any direction.
double left_of(Claims claims, double overlap) {
  claims.settle([](const Vec3&) { return 0.0; });
  return claims.allowed_depth(z, 0.9, 1e-15,
                              [&](const abut::Columns&, abut::Lanes) { return abut::all_lanes(overlap); });
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

// Many more than count, some of them alike.
TEST(Claims, DoNotDependOnTheirOrder) {
  struct Each {
    Vec3 normal;
    double depth;
    bool is_turned;
  };
  std::mt19937 random(811);
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Each> all;
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.02 * number(random) * i;
    all.push_back({{std::sin(angle), 0, std::cos(angle)}, std::fabs(number(random)), i % 3 == 0});
  }
  const auto left = [&] {
    Claims claims;
    for (const Each& each : all) {
      claims.add(each.normal, each.depth, each.is_turned);
    }
    claims.settle([](const Vec3& direction) { return direction.x; });
    const auto overlaps = [](const abut::Columns&, abut::Lanes lowest) { return lowest; };
    std::vector<double> allowed;
    for (int i = -8; i <= 8; ++i) {
      const double angle = 0.15 * i;
      allowed.push_back(claims.allowed_depth({std::sin(angle), 0, std::cos(angle)}, 0.9, 1e-15, overlaps));
    }
    return allowed;
  };
  const std::vector<double> first = left();
  for (int i = 0; i < 20; ++i) {
    std::shuffle(all.begin(), all.end(), random);
    EXPECT_EQ(left(), first);
  }
}

// Whichever lane it has, and whatever stands in the lanes beside it.
TEST(Claims, TakeTheLeastThatAnyOfManyLeaves) {
  for (int count = 1; count <= 12; ++count) {
    for (int best = 0; best < count; ++best) {
      Claims claims;
      for (int i = 0; i < count; ++i) {
        const double angle = 0.1 * i;
        claims.add({std::cos(angle), std::sin(angle), 0}, i == best ? 0.2 : 0.6, false);
      }
      // Only the best way parts the triangle.
      claims.settle([](const Vec3&) { return 0.0; });
      const double angle = 0.1 * best;
      const auto overlaps = [&](const abut::Columns& directions, abut::Lanes) {
        const abut::Lanes cosine = std::cos(angle) * directions.x + std::sin(angle) * directions.y;
        return cosine > 1 - 1e-9 ? abut::all_lanes(0.2) : abut::all_lanes(0.7);
      };
      EXPECT_NEAR(claims.allowed_depth(z, 0.9, 1e-15, overlaps), 0, 1e-5) << best << " of " << count;
    }
  }
}

TEST(Claims, OfLikeNormalsTheDeepestCounts) {
  Claims claims;
  claims.add(x, 0.1, false);
  claims.add(x, 0.3, false);
  EXPECT_NEAR(left_of(claims, 0.25), 0, 1e-5);
}

}  // namespace
