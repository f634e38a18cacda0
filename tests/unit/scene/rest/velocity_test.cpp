// SPDX-License-Identifier: Apache-2.0
// Velocities by the poses of parts, and the table of them, without a universe around it.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

import abut.math;
import abut.math.turn;
import abut.scene.state.options;
import abut.scene.rest.velocity;

namespace {

using namespace abut;

Quat turned(const Vec3& axis, Real angle) {
  const Real s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
}
Quat product(const Quat& a, const Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

TEST(TurnBetween, IsTheAxisTimesTheAngle) {
  const Quat before = turned({0.6, 0, 0.8}, 1.1);
  const Vec3 axis{2. / 3, -2. / 3, 1. / 3};
  for (const Real angle : {1e-150, 1e-9, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14159}) {
    const Vec3 turn = turn_between(before, product(turned(axis, angle), before));
    EXPECT_LE(norm(turn - angle * axis), 1e-14 + 4e-16 * angle) << angle;
    const Vec3 small = turn_between({1, 0, 0, 0}, turned(axis, angle));
    EXPECT_LE(norm(small - angle * axis), 2e-15 * angle) << angle << ": relative where nothing cancels";
  }
}

TEST(TurnBetween, IsZeroOnlyForEqualOrientations) {
  for (const Quat& q :
       {Quat{1, 0, 0, 0}, Quat{0.5, 0.5, -0.5, 0.5}, turned({0.6, 0, 0.8}, 1.1), turned({0, 0.28, 0.96}, 0.3)}) {
    EXPECT_EQ(turn_between(q, q), (Vec3{0, 0, 0}));
    EXPECT_EQ(turn_between(q, {-q.w, -q.x, -q.y, -q.z}), (Vec3{0, 0, 0})) << "the same rotation";
    EXPECT_GT(norm(turn_between(q, product(turned({1, 0, 0}, 1e-12), q))), 0);
  }
}

TEST(TurnBetween, TakesTheShorterWayAndAnyLength) {
  const Quat half = turned({0, 0, 1}, 3.5);
  EXPECT_NEAR(turn_between({1, 0, 0, 0}, half).z, 3.5 - 2 * 3.141592653589793, 1e-14);
  EXPECT_NEAR(turn_between({1.001, 0, 0, 0}, {0.999 * std::cos(0.5), 0.999 * std::sin(0.5), 0, 0}).x, 1, 1e-14);
  EXPECT_NEAR(norm(turn_between({1, 0, 0, 0}, {0, 0, 1, 0})), 3.141592653589793, 1e-14);
}

TEST(VelocityBetween, LeadsFromOnePlacementToTheOther) {
  const Vec3 axis{2. / 3, -2. / 3, 1. / 3};
  const Placement before{{1, 2, 3}, turned({0.6, 0, 0.8}, 1.1)};
  const Placement after{{1.5, 2, 2}, product(turned(axis, 0.25), before.orientation)};
  const Velocity found = velocity_between(before, after, 0.5);
  EXPECT_EQ(found.linear, (Vec3{1, 0, -2}));
  EXPECT_LE(norm(found.angular - 0.5 * axis), 1e-14);
  EXPECT_EQ(velocity_between(before, before, 0.5), Velocity{});
}

TEST(VelocityBetween, IsFiniteForTheShortestTimes) {
  const Placement before{{0, 0, 0}, {1, 0, 0, 0}}, after{{1e70, -1, 0}, turned({0, 0, 1}, 1)};
  for (const Real dt : {1e-300, std::numeric_limits<Real>::min(), std::numeric_limits<Real>::denorm_min()}) {
    const Velocity found = velocity_between(before, after, dt);
    EXPECT_EQ(found.linear, (Vec3{1e70, -1e70, 0})) << dt;
    EXPECT_EQ(found.angular, (Vec3{0, 0, 1e70})) << dt;
  }
}

constexpr Velocity some_velocity{{1, 2, 3}, {4, 5, 6}};
const Placement origin{};
const Placement ahead{{1, 0, 0}, {1, 0, 0, 0}};

TEST(VelocityTable, HoldsNothingUntilOneIsSet) {
  VelocityTable table;
  table.forget(9);
  EXPECT_TRUE(table.is_empty());
  EXPECT_EQ(table.bytes(), 0U);
  EXPECT_EQ(table.of(9), Velocity{});
  EXPECT_EQ(table.source_of(9), VelocitySource::none);
  table.give(9, some_velocity);
  EXPECT_FALSE(table.is_empty());
  EXPECT_EQ(table.of(9), some_velocity);
  EXPECT_EQ(table.of(8), Velocity{});
  EXPECT_EQ(table.source_of(9), VelocitySource::given);
  table.forget(9);
  EXPECT_TRUE(table.is_empty());
  EXPECT_EQ(table.of(9), Velocity{});
}

TEST(VelocityTable, TellsWhatIsStill) {
  VelocityTable table;
  EXPECT_TRUE(table.is_still(2));
  table.give(4, some_velocity);
  EXPECT_FALSE(table.is_still(4));
  EXPECT_TRUE(table.is_still(2)) << "it has room, and no velocity";
  table.forget(4);
  EXPECT_TRUE(table.is_still(4));
  table.accelerate(4, {{1, 0, 0}, {0, 0, 0}});
  EXPECT_FALSE(table.is_still(4));
  table.give(4, some_velocity);
  table.accelerate(4, {});
  EXPECT_FALSE(table.is_still(4)) << "a velocity is left";
  table.forget(4);
  EXPECT_TRUE(table.is_still(4));
  table.measure({4, 1}, origin);
  EXPECT_FALSE(table.is_still(4));
  EXPECT_NE(table.start_of(4), nullptr);
}

TEST(VelocityTable, MeasuresFromUpdateToUpdate) {
  VelocityTable table;
  table.measure({3, 1}, origin);
  EXPECT_EQ(table.of(3), Velocity{});
  table.update(0.5, [](PartId) { return ahead; });
  EXPECT_EQ(table.of(3), (Velocity{{2, 0, 0}, {0, 0, 0}}));
  table.settle([](PartId) { return ahead; });
  table.measure({3, 1}, origin);
  EXPECT_EQ(table.of(3), (Velocity{{2, 0, 0}, {0, 0, 0}})) << "it goes on";
  table.update(0.5, [](PartId) { return ahead; });
  EXPECT_EQ(table.of(3), Velocity{}) << "it stands";
  table.give(3, some_velocity);
  table.update(0.5, [](PartId) { return origin; });
  EXPECT_EQ(table.of(3), some_velocity);
}

TEST(VelocityTable, ForgetsOneOfManyThatAreMeasured) {
  for (std::uint32_t gone = 1; gone <= 4; ++gone) {
    VelocityTable table;
    for (std::uint32_t slot = 1; slot <= 4; ++slot) {
      table.measure({slot, 1}, origin);
    }
    table.forget(gone);
    EXPECT_EQ(table.count(VelocitySource::poses), 3U);
    table.update(1, [](PartId part) { return Placement{{1.0 * part.slot, 0, 0}, {1, 0, 0, 0}}; });
    for (std::uint32_t slot = 1; slot <= 4; ++slot) {
      EXPECT_EQ(table.of(slot).linear.x, slot == gone ? 0.0 : 1.0 * slot) << slot << " without " << gone;
    }
    table.measure({gone, 2}, origin);
    EXPECT_EQ(table.count(VelocitySource::poses), 4U);
  }
}

}  // namespace
