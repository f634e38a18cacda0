// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "../../made.hpp"

import abut.capability;
import abut.math;
import abut.narrow.libccd;
import abut.shapes.box;
import abut.shapes.ellipsoid;

namespace {

using abut::Algorithm;
using abut::Distance;
using abut::Outcome;
using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr std::initializer_list<Algorithm> both{Algorithm::libccd_gjk, Algorithm::libccd_mpr};

class Libccd : public testing::Test {
 protected:
  void SetUp() override {
    Distance found{};
    const auto cube = test::made<abut::Box>({1, 1, 1});
    if (abut::libccd_distance(cube, cube, Pose::identity(), {.algorithm = Algorithm::libccd_gjk}, found) ==
        Outcome::unsupported) {
      GTEST_SKIP() << "this build lacks libccd";
    }
  }
};

TEST_F(Libccd, FindsTheDepthOfBoxes) {
  for (const Algorithm algorithm : both) {
    Distance found{};
    const Pose ab{abut::Rotation::identity(), {1.75, 0, 0}};
    ASSERT_EQ(abut::libccd_distance(test::made<abut::Box>({1, 1, 1}), test::made<abut::Box>({1, 0.5, 0.5}), ab,
                                    {.algorithm = algorithm}, found),
              Outcome::ok);
    EXPECT_NEAR(found.distance, -0.25, 1e-8);
    EXPECT_NEAR(found.normal.x, 1, 1e-8);
    EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), found.distance, 1e-8);
  }
}

// Lengths and the error at which the search ends grow alike.
TEST_F(Libccd, FindsTheSameInAnyUnit) {
  const auto depth = [](Algorithm algorithm, Real unit, Real error_bound) {
    const auto a = test::made<abut::Ellipsoid>({1 * unit, 0.75 * unit, 0.5 * unit}),
               b = test::made<abut::Ellipsoid>({0.5 * unit, 1 * unit, 0.75 * unit});
    const Pose ab{abut::Rotation::from({0.9, 0.1, -0.3, 0.3}), {0.5 * unit, -0.25 * unit, 0.125 * unit}};
    Distance found{};
    EXPECT_EQ(abut::libccd_distance(a, b, ab, {.algorithm = algorithm, .error_bound = error_bound}, found),
              Outcome::ok);
    return found.distance / unit;
  };
  const Real large = std::ldexp(1, 20), small = std::ldexp(1, -20);
  for (const Algorithm algorithm : both) {
    const Real expected = depth(algorithm, 1, 0);
    EXPECT_NEAR(depth(algorithm, large, 0), expected, 1e-8);
    EXPECT_NEAR(depth(algorithm, small, 0), expected, 1e-8);
  }
  const Real fine = depth(Algorithm::libccd_gjk, small, 0), coarse = depth(Algorithm::libccd_gjk, small, 1e-4);
  EXPECT_GT(std::fabs(coarse - fine), 1e-6);
  EXPECT_NEAR(coarse, fine, 0.1);
}

TEST_F(Libccd, TellsThatShapesAreApart) {
  for (const Algorithm algorithm : both) {
    Distance found{};
    const auto cube = test::made<abut::Box>({1, 1, 1});
    EXPECT_EQ(
        abut::libccd_distance(cube, cube, {abut::Rotation::identity(), {4, 0, 0}}, {.algorithm = algorithm}, found),
        Outcome::apart);
  }
}

// Its polytope knows no limit: where it is to end by no error at all, it would go on for ever.
TEST_F(Libccd, GivesUpAfterAThousandSupportPoints) {
  int asked = 0;
  const Vec3 place{0.1, 0.03, 0.02};
  const auto ball = [&](const Vec3& direction) {
    ++asked;
    return (1 / norm(direction)) * direction;
  };
  const auto beside = [&](const Vec3& direction) { return ball(direction) + place; };
  Distance found{};
  EXPECT_EQ(abut::libccd_query(ball, beside, {0, 0, 0}, place, Algorithm::libccd_gjk, 2, 0, found),
            Outcome::not_converged);
  EXPECT_EQ(asked, 2 * 1000);
}

TEST_F(Libccd, NeverPassesOnWhatIsNotANumber) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const auto broken = [&](const Vec3&) { return Vec3{nan, nan, nan}; };
  for (const Algorithm algorithm : both) {
    Distance found{};
    const Outcome outcome = abut::libccd_query(broken, broken, {0, 0, 0}, {0.5, 0, 0}, algorithm, 1, 1e-9, found);
    EXPECT_EQ(outcome, Outcome::not_converged);
  }
}

}  // namespace
