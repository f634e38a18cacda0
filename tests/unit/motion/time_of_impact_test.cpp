// SPDX-License-Identifier: Apache-2.0
// Times of impact against closed forms, against dense samples, and against themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

import abut.capability;
import abut.core;
import abut.math;
import abut.math.turn;
import abut.motion.paths.path;
import abut.motion.time_of_impact;
import abut.pairs.any_shape;

namespace {

using namespace abut;

ShapeHandle shape_of(std::string_view kind, const std::vector<Real>& parameters, const std::vector<Real>& reals = {},
                     const std::vector<std::uint32_t>& indices = {}) {
  return make_shape(find_kind(kind).value(), parameters, reals, indices).value();
}
ShapeHandle box(Real x, Real y, Real z) { return shape_of("box", {x, y, z}); }
ShapeHandle sphere(Real radius) { return shape_of("sphere", {radius}); }
ShapeHandle floor_at_zero() { return shape_of("plane", {0, 0, 1, 0}); }

Pose at(const Vec3& position, const Vec3& turn = {0, 0, 0}) { return {rotation_by(turn), position}; }
Path moving(const Pose& start, const Motion& motion, Real duration = 1) {
  return Path::along(start, {0, 0, 0}, motion, duration).value();
}

Impact impact_of(const AnyShape& a, const Path& path_a, const AnyShape& b, const Path& path_b,
                 const ImpactOptions& options = {}) {
  Impact out;
  EXPECT_EQ(time_of_impact({a, path_a}, {b, path_b}, options, out), Outcome::ok);
  return out;
}

// The interval holds the time, and is no wider than the tolerance of the distance over the speed makes it.
void expect_touch(const Impact& found, Real time, Real error) {
  EXPECT_EQ(found.state, ImpactState::touches);
  EXPECT_LE(found.lower, time + 1e-14);
  EXPECT_LE(found.lower, found.upper);
  EXPECT_NEAR(found.lower, time, error);
  EXPECT_NEAR(found.upper, time, error);
}

TEST(TimeOfImpact, OfABallThatFallsOnAFloor) {
  for (const Real speed : {0.0, 3.0, -2.0}) {
    const Motion fall{.velocity = {1, 0, speed}, .angular_velocity = {3, 2, 1}, .acceleration = {0, 0, -9.81}};
    const Path path = moving(at({0, 0, 2.5}), fall, 2);
    const Real time = (speed + std::sqrt(speed * speed + 2 * 9.81 * 2)) / 9.81;
    const Impact found = impact_of(sphere(0.5), path, floor_at_zero(), Path::at_rest(at({0, 0, 0}), 2));
    expect_touch(found, time, 1e-11);
    EXPECT_NEAR(found.contact.normal.z, -1, 1e-14);
    EXPECT_NEAR(found.contact.point_b.x, time, 1e-11);
    EXPECT_NEAR(found.contact.point_b.z, 0, 1e-11);
  }
}

TEST(TimeOfImpact, OfARodThatSpinsUpOntoAFloor) {
  // Its end is at height 1 - sin(angle) of the half length 2, less the radius.
  const ShapeHandle rod = shape_of("capsule", {0.25, 2});
  const Path path = moving(at({0, 0, 1.25}, {0, 0.5 * std::numbers::pi, 0}),
                           {.angular_velocity = {0, 0.5, 0}, .angular_acceleration = {0, 1.5, 0}}, 2);
  const Real angle = std::asin(0.5), time = (-0.5 + std::sqrt(0.25 + 3 * angle)) / 1.5;
  expect_touch(impact_of(rod, path, floor_at_zero(), Path::at_rest(at({0, 0, 0}), 2)), time, 1e-11);
}

TEST(TimeOfImpact, OfAFloorThatTiltsOntoABall) {
  // A floor that turns around the x axis meets a ball at (0, 3, 1), of radius 0.5: 3 sin(angle) = cos(angle) - 0.5.
  Real low = 0, high = 1;
  for (int i = 0; i < 100; ++i) {
    const Real middle = 0.5 * (low + high);
    (std::cos(middle) - 3 * std::sin(middle) > 0.5 ? low : high) = middle;
  }
  const Impact found = impact_of(floor_at_zero(), moving(at({0, 0, 0}), {.angular_velocity = {1, 0, 0}}), sphere(0.5),
                                 Path::at_rest(at({0, 3, 1}), 1));
  expect_touch(found, low, 1e-11);
}

TEST(TimeOfImpact, OfBoxesFaceToFaceAndCornerToFace) {
  const Path still = Path::at_rest(at({0, 0, 0}), 1);
  expect_touch(impact_of(box(1, 1, 1), still, box(1, 1, 1), moving(at({5, 0.3, 0.2}), {.velocity = {-6, 0, 0}})), 0.5,
               1e-12);
  // A corner of a cube that spins around its vertical axis.
  const Path spin = moving(at({2.3, 0, 0}), {.angular_velocity = {0, 0, 1}});
  const Real time = 0.25 * std::numbers::pi - std::acos(1.3 / std::numbers::sqrt2);
  expect_touch(impact_of(box(1, 1, 1), still, box(1, 1, 1), spin), time, 1e-9);
}

TEST(TimeOfImpact, KnowsOverlapAtTheStart) {
  const Impact found = impact_of(box(1, 1, 1), moving(at({0, 0, 0}), {.velocity = {1, 0, 0}}), box(1, 1, 1),
                                 Path::at_rest(at({1.5, 0, 0}), 1));
  EXPECT_EQ(found.state, ImpactState::starts_together);
  EXPECT_EQ(found.upper, 0);
  EXPECT_NEAR(found.contact.distance, -0.5, 1e-14);
  EXPECT_NEAR(found.contact.normal.x, 1, 1e-14);
}

TEST(TimeOfImpact, OfWhatNeverMovesTowardsEachOtherIsNone) {
  const ShapeHandle body = box(1, 0.5, 0.25);
  const Motion fast{.velocity = {100, 20, 3}, .angular_velocity = {5, 6, 7}, .acceleration = {10, 0, -9.81}};
  // Alike, and one that slides along a face of the other while it spins.
  const Impact alike = impact_of(body, moving(at({0, 0, 0}), {.velocity = {100, 20, 3}}), body,
                                 moving(at({2.001, 0, 0}), {.velocity = {100, 20, 3}}));
  EXPECT_EQ(alike.state, ImpactState::apart);
  EXPECT_EQ(alike.lower, 1);
  const Impact slides =
      impact_of(box(10, 10, 1), Path::at_rest(at({0, 0, 0}), 1), body,
                moving(at({-5, 0, 1.2500001}), {.velocity = {10, 0, 0}, .angular_velocity = {0, 0, 9}}));
  EXPECT_EQ(slides.state, ImpactState::apart);
  EXPECT_LE(slides.rounds, 8u);
  const Impact leaves = impact_of(body, moving(at({0, 0, 0}), fast), body, Path::at_rest(at({-3, 0, 0}), 1));
  EXPECT_EQ(leaves.state, ImpactState::apart);
}

TEST(TimeOfImpact, TellsAGrazeFromAMiss) {
  // Two balls that pass each other at a distance of their radii, and a little more or less.
  const auto pass = [](Real aside) {
    return impact_of(sphere(1), Path::at_rest(at({0, 0, 0}), 1), sphere(1),
                     moving(at({-5, aside, 0}), {.velocity = {10, 0, 0}}));
  };
  EXPECT_EQ(pass(2 + 1e-9).state, ImpactState::apart);
  const Impact graze = pass(2 - 1e-9);
  EXPECT_EQ(graze.state, ImpactState::touches);
  EXPECT_NEAR(graze.upper, 0.5 - std::sqrt(4 - (2 - 1e-9) * (2 - 1e-9)) / 10, 1e-7);
}

TEST(TimeOfImpact, OfAPropellerThatOnlySpins) {
  const ShapeHandle blade = box(1, 0.05, 0.01), post = box(0.01, 0.01, 1);
  const Path spin = moving(at({0, 0, 0}), {.angular_velocity = {0, 0, 60}});
  const Impact found = impact_of(blade, spin, post, Path::at_rest(at({0, 0.9, 0}), 1));
  EXPECT_EQ(found.state, ImpactState::touches);
  EXPECT_NEAR(found.upper, (0.5 * std::numbers::pi - 0.06 / 0.9) / 60, 1e-3);
  EXPECT_EQ(impact_of(blade, spin, post, Path::at_rest(at({0, 1.02, 0}), 1)).state, ImpactState::apart);
}

TEST(TimeOfImpact, OfAGiantAndASpeckAndOfThinSheets) {
  const Impact speck = impact_of(sphere(1e4), Path::at_rest(at({0, 0, 0}), 1), box(1e-3, 1e-3, 1e-3),
                                 moving(at({1e4 + 5, 0, 0}), {.velocity = {-10, 0, 0}, .angular_velocity = {1, 2, 3}}));
  EXPECT_EQ(speck.state, ImpactState::touches);
  EXPECT_NEAR(speck.upper, 0.5, 2e-4);
  const ShapeHandle sheet = shape_of("mesh", {0}, {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, {0, 1, 2, 0, 2, 3});
  const Impact bullet = impact_of(sheet, moving(at({0, 0, 0}), {.angular_velocity = {0, 0, 2}}), sphere(1e-3),
                                  moving(at({0.3, 0.2, 100}), {.velocity = {0, 0, -1000}}));
  expect_touch(bullet, (100 - 1e-3) / 1000, 1e-11);
}

TEST(TimeOfImpact, IsAnIntervalWhereTheRoundsAreUsedUp) {
  const Path path_a = moving(at({0, 0, 0}), {.angular_velocity = {1, 2, 3}});
  const Path path_b = moving(at({4, 0, 0}), {.velocity = {-3, 0, 0}, .angular_velocity = {-3, 1, 2}});
  const Impact full = impact_of(box(1, 0.5, 0.2), path_a, box(1, 0.5, 0.2), path_b);
  ASSERT_EQ(full.state, ImpactState::touches);
  ASSERT_GT(full.rounds, 2u);
  const Impact cut = impact_of(box(1, 0.5, 0.2), path_a, box(1, 0.5, 0.2), path_b, {.most_rounds = 1});
  EXPECT_EQ(cut.state, ImpactState::undecided);
  EXPECT_GT(cut.lower, 0);
  EXPECT_LE(cut.lower, full.upper);
  EXPECT_EQ(cut.upper, 1);
}

TEST(TimeOfImpact, TakesAMarginForATouch) {
  const Path still = Path::at_rest(at({0, 0, 0}), 1), path = moving(at({5, 0, 0}), {.velocity = {-6, 0, 0}});
  expect_touch(impact_of(box(1, 1, 1), still, box(1, 1, 1), path, {.margin = 0.6}), 0.4, 1e-12);
}

}  // namespace
