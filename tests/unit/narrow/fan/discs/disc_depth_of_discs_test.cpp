// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "../../../made.hpp"
#include "../../../least_overlap.hpp"
#include "../../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.fan.discs.disc_depth_of_pair;
import abut.shapes.cone;
import abut.shapes.cylinder;

namespace {

using abut::Pose;
using abut::Real;
using abut::Rotation;
using abut::Vec3;
using test::Solid;

constexpr Real error = 1e-10, size = 4;

struct Case {
  Solid a, b;
  Pose ab;  // of b in the frame of a
};

// The overlap along a direction from a to b.
Real overlap(const Case& c, const Vec3& d) {
  return (c.a.reach(d) + c.b.reach(-c.ab.rotation.undo(d)) - dot(d, c.ab.position)) / norm(d);
}

template <class Visit>
auto with_shape(const Solid& solid, Visit&& visit) {
  const std::vector<Real> parameters{solid.radius, solid.half_height};
  return solid.is_cone ? visit(test::made<abut::Cone>(parameters)) : visit(test::made<abut::Cylinder>(parameters));
}
std::optional<abut::ProvenDepth> depth_of(const Case& c) {
  return with_shape(c.a, [&](const auto& a) {
    return with_shape(c.b, [&](const auto& b) { return abut::disc_depth(a, b, c.ab, size, error); });
  });
}

// Of solids that overlap: whether a depth was found.
void check(const Case& c, int number) {
  const auto overlap_along = [&](const Vec3& d) { return overlap(c, d); };
  const Real least = test::least_overlap(overlap_along);
  if (least <= error) {
    return;
  }
  const std::optional<abut::ProvenDepth> found = depth_of(c);
  ASSERT_TRUE(found) << number;
  test::expect_least(*found, least, error, overlap_along, number);
}

Solid random_solid(test::Random& random, bool is_cone) {
  return {random.uniform(0.05, 1), random.uniform(0.05, 1), is_cone};
}

TEST(DiscDepthOfDiscs, NoDirectionHasLess) {
  test::Random random(30);
  for (int i = 0; i < 400; ++i) {
    const Case c{
        random_solid(random, i % 2 == 0), random_solid(random, i % 4 < 2), {random.rotation(), random.point(0.7)}};
    check(c, i);
  }
}

// Thin ones of one size cross deeply: rims pass near the axis of the other, or nowhere near it.
TEST(DiscDepthOfDiscs, NoDirectionHasLessForPlatesAndNeedles) {
  test::Random random(31);
  for (int i = 0; i < 200; ++i) {
    const auto solid = [&](bool is_cone) {
      const Real thin = random.uniform(0.001, 0.02), wide = random.uniform(0.3, 1);
      return random.uniform(0, 1) < 0.5 ? Solid{thin, wide, is_cone} : Solid{wide, thin, is_cone};
    };
    const Case c{solid(i % 2 == 0), solid(i % 4 < 2), {random.rotation(), random.point(0.2)}};
    check(c, i);
  }
}

// Axes along each other and across each other, exactly and nearly, in one plane and not.
TEST(DiscDepthOfDiscs, NoDirectionHasLessWhereAxesAreAligned) {
  test::Random random(32);
  for (int i = 0; i < 240; ++i) {
    const Real tilt = i % 4 == 0 ? 0 : i % 4 == 1 ? 1e-13 : i % 4 == 2 ? 1e-7 : std::numbers::pi / 4;
    const Real c = std::cos(tilt), s = std::sin(tilt);
    const Rotation turned{{1, 0, 0}, {0, c, s}, {0, -s, c}};
    const Rotation onto = i % 3 == 0   ? Rotation{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}
                          : i % 3 == 1 ? Rotation{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}
                                       : Rotation::identity();
    Vec3 offset = random.point(0.6);
    offset.x = i % 5 < 2 ? 0 : offset.x;
    offset.z = i % 5 == 1 ? 0 : offset.z;
    const Case one{random_solid(random, i % 2 == 0), random_solid(random, i % 8 < 4), {turned * onto, offset}};
    check(one, i);
  }
}

// The point of the rim on the axis is as near to the side all around.
TEST(DiscDepthOfDiscs, NothingWrongIsProvenWhereARimMeetsTheAxis) {
  for (const Real half_height : {0.0, 0.25, 0.5}) {
    for (const bool is_cone : {false, true}) {
      const Case c{{1, 0.9, true}, {1, half_height, is_cone}, {Rotation::identity(), {1, 0, 0.125}}};
      const Real least = test::least_overlap([&](const Vec3& d) { return overlap(c, d); });
      const std::optional<abut::ProvenDepth> found = depth_of(c);
      EXPECT_TRUE(!found || found->depth <= least + error) << half_height << (found ? found->depth : 0) << " " << least;
    }
  }
}

// Rims in one plane cross, or a rim crosses the axis of the other body: there the normal is across both lines.
TEST(DiscDepthOfDiscs, IsFoundWhereRimsMeetRimsAndAxes) {
  const Rotation sideways{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const std::vector<Case> cases{
      {{0.5, 1, false}, {0.5, 1, false}, {Rotation::identity(), {0.5, 0.25, 0}}},
      {{1.25, 1, false}, {1, 0.5, true}, {Rotation::identity(), {0.5, -0.25, -0.5}}},
      {{1, 0.5, false}, {0.75, 1, false}, {sideways, {-0.5, -0.5, -0.5}}},
      {{1, 0.25, false}, {0.75, 0.5, false}, {Rotation{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {0.5, -0.5, -0.25}}},
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_GT(test::least_overlap([&](const Vec3& d) { return overlap(cases[i], d); }), 0.1) << i;
    check(cases[i], static_cast<int>(i));
  }
}

// Of a speck in the middle of a giant every direction is nearly as good.
TEST(DiscDepthOfDiscs, IsFoundForASpeckInAGiant) {
  test::Random random(34);
  for (int i = 0; i < 40; ++i) {
    const Solid giant{800, 1000, i % 2 == 0}, speck{1e-3, 2e-3, i % 4 < 2};
    const Case c{giant, speck, {random.rotation(), {0, 0, 0}}};
    const auto found = with_shape(giant, [&](const auto& a) {
      return with_shape(speck, [&](const auto& b) { return abut::disc_depth(a, b, c.ab, 4000, 4e-7); });
    });
    ASSERT_TRUE(found) << i;
    EXPECT_LE(found->depth, test::least_overlap([&](const Vec3& d) { return overlap(c, d); }) + 4e-7) << i;
  }
}

TEST(DiscDepthOfDiscs, IsTheSameFromTheOtherSide) {
  test::Random random(33);
  for (int i = 0; i < 200; ++i) {
    const Case c{
        random_solid(random, i % 2 == 0), random_solid(random, i % 4 < 2), {random.rotation(), random.point(0.5)}};
    const auto found = depth_of(c), other = depth_of({c.b, c.a, c.ab.inverse()});
    ASSERT_EQ(found.has_value(), other.has_value()) << i;
    if (found) {
      EXPECT_NEAR(found->depth, other->depth, error) << i;
    }
  }
}

TEST(DiscDepthOfDiscs, SaysNothingOfBodiesThatTouch) {
  const Solid cylinder{0.5, 1, false}, cone{0.5, 1, true};
  EXPECT_FALSE(depth_of({cylinder, cylinder, {Rotation::identity(), {0.1, 0, 2}}}));
  EXPECT_FALSE(depth_of({cylinder, cylinder, {Rotation::identity(), {1, 0, 0.1}}}));
  EXPECT_FALSE(depth_of({cylinder, cone, {Rotation::identity(), {0.1, 0, 2}}}));
  EXPECT_FALSE(depth_of({cone, cone, {Rotation::identity(), {0.1, 0, 2}}}));
  EXPECT_FALSE(depth_of({cone, cylinder, {Rotation{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, {0.1, 0, -1.5}}}));
}

}  // namespace
