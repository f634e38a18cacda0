// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.cores.difference;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;
import abut.narrow.polytope.epa;
import abut.shapes.box;

namespace {

using abut::Pose;
using abut::Real;
using abut::Vec3;

abut::Box box(const Vec3& half) { return test::made<abut::Box>({half.x, half.y, half.z}); }

abut::EpaResult depth_of(const Vec3& half_a, const Vec3& half_b, const Pose& ab) {
  const abut::GjkResult start = abut::gjk(box(half_a), box(half_b), ab, ab.position, 10, 1e-12, abut::infinity);
  EXPECT_TRUE(start.overlap);
  return abut::with_difference(box(half_a), box(half_b), ab, 10,
                               [&](const abut::Difference& cores) { return abut::epa(cores, 1e-12, start.simplex); });
}

// The depth of boxes is known exactly from their fifteen axes.
TEST(Epa, DepthOfRandomBoxesIsThatOfTheirAxes) {
  test::Random random(61);
  int deep = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)) + Vec3{0.05, 0.05, 0.05};
    const Vec3 half_b = abut::absolute(random.point(1)) + Vec3{0.05, 0.05, 0.05};
    const Pose ab{random.rotation(), random.point(1)};
    const abut::SatResult expected = abut::sat_of_boxes(half_a, half_b, ab, 0, abut::infinity);
    if (expected.separation > -1e-6) {
      continue;
    }
    ++deep;
    const abut::EpaResult found = depth_of(half_a, half_b, ab);
    EXPECT_NEAR(found.depth, -expected.separation, 1e-11) << i;
    EXPECT_LE(found.lower, found.upper);
    EXPECT_LE(found.lower, -expected.separation + 1e-12);
    EXPECT_GE(found.upper, -expected.separation - 1e-12);
    EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), -found.depth, 1e-12);
    EXPECT_TRUE(test::is_inside(half_a, found.point_a, 1e-10));
    EXPECT_TRUE(test::is_inside(half_b, ab.undo(found.point_b), 1e-10));
  }
  EXPECT_GT(deep, 1000);
}

// The depth alone, where it is less than a limit, also without volume.
TEST(Epa, DepthBelowALimitIsThatOfTheAxes) {
  test::Random random(67);
  const auto least_below = [](Real most, const Vec3& half_a, const Vec3& half_b, const Pose& ab) {
    return abut::with_difference(box(half_a), box(half_b), ab, 10, [&](const abut::Difference& cores) {
      return abut::least_overlap_below(most, cores, 1e-12);
    });
  };
  int deep = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 half_a = abut::absolute(random.point(1)) + Vec3{0.05, 0.05, 0.05};
    const Vec3 half_b = abut::absolute(random.point(1)) + Vec3{0.05, 0.05, i % 10 == 0 ? 0 : 0.05};
    const Pose ab{random.rotation(), random.point(1)};
    const abut::SatResult expected = abut::sat_of_boxes(half_a, half_b, ab, 0, abut::infinity);
    const Real depth = -expected.separation;
    if (depth < 1e-6) {
      continue;
    }
    ++deep;
    for (const Real most : {1.001 * depth, abut::infinity}) {
      const auto found = least_below(most, half_a, half_b, ab);
      ASSERT_TRUE(found.has_value()) << i;
      EXPECT_NEAR(found->depth, depth, 1e-11) << i;
      const Real reach = dot(half_a, abut::absolute(found->normal)) +
                         dot(half_b, abut::absolute(ab.rotation.undo(found->normal))) - dot(ab.position, found->normal);
      EXPECT_NEAR(reach, depth, 1e-11) << i;
    }
    EXPECT_FALSE(least_below(0.999 * depth, half_a, half_b, ab).has_value()) << i;
  }
  EXPECT_GT(deep, 300);
  const Pose beside{abut::Rotation::identity(), {0.5, 0.5, 0}};
  const auto flat = least_below(1, {1, 1, 0}, {1, 1, 0}, beside);
  ASSERT_TRUE(flat.has_value());
  EXPECT_EQ(flat->depth, 0);
  EXPECT_NEAR(std::fabs(flat->normal.z), 1, 1e-12);
}

TEST(Epa, ConcentricBoxes) {
  const abut::EpaResult found = depth_of({3, 2, 1}, {3, 2, 1}, Pose::identity());
  EXPECT_NEAR(found.depth, 2, 1e-12);
  EXPECT_NEAR(std::fabs(found.normal.z), 1, 1e-12);
}

// A plate in a plate in the same plane: the difference has no volume, and no depth.
TEST(Epa, DifferenceWithoutVolume) {
  const abut::EpaResult found = depth_of({1, 1, 0}, {1, 1, 0}, {abut::Rotation::identity(), {0.5, 0.5, 0}});
  EXPECT_EQ(found.depth, 0);
  EXPECT_NEAR(std::fabs(found.normal.z), 1, 1e-12);
}

// A wedge hardly thicker than rounding, whose slope is above the origin: the depth is that of the slope, whatever the
// ends of the wedge reach.
TEST(Epa, ThinWedge) {
  constexpr Real rise = 1.5e-13;  // from the middle to an end
  std::vector<Vec3> corners;
  for (const Real x : {-1.0, 1.0}) {
    for (const Real y : {-1.0, 1.0}) {
      corners.push_back({x, y, -3e-13});
      corners.push_back({x, y, 2e-13 + x * rise});
    }
  }
  abut::Difference wedge;
  wedge.support = [&](const Vec3& direction) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < corners.size(); ++i) {
      best = dot(direction, corners[i]) > dot(direction, corners[best]) ? i : best;
    }
    return abut::SupportPair{corners[best], {0, 0, 0}, best, 0};
  };
  wedge.size = 1;
  wedge.is_curved = false;
  const auto found = abut::least_overlap_below(1, wedge, 1e-15);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->depth, 2e-13, 2e-15);
  EXPECT_NEAR(found->normal.x, -rise, 2e-15);
}

}  // namespace
