// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

import abut.capability;
import abut.math;
import abut.narrow.cast.linear_cast;

namespace {

using namespace abut;

// Two balls at the ends of an offset, of which the second one moves: the closed form that searches are held against.
struct Balls {
  Vec3 offset;
  Real radii;
  std::uint32_t asked = 0;

  Outcome distance(const LinearMotion& motion, Real way, Distance& out) {
    ++asked;
    const Vec3 apart = offset + way * motion.direction.vec();
    out.distance = out.lower = out.upper = norm(apart) - radii;
    out.normal = UnitVec3::make(apart).value_or(UnitVec3::axis_z());
    return Outcome::ok;
  }
  std::optional<FirstTouch> cast(const LinearMotion& motion, Real margin = 0) {
    std::optional<FirstTouch> out;
    const Outcome outcome = first_touch(
        motion, norm(offset) + radii, margin, [&](Real way, Distance& found) { return distance(motion, way, found); },
        [&](const Vec3& normal) { return dot(offset, normal) - radii; }, out);
    EXPECT_EQ(outcome, Outcome::ok);
    return out;
  }
  // The lesser root of |offset + way * direction| = radii.
  [[nodiscard]] std::optional<Real> root(const LinearMotion& motion) const {
    const Real along = dot(offset, motion.direction);
    const Real under = radii * radii - squared_norm(offset - along * motion.direction.vec());
    const Real way = under < 0 ? infinity : -along - std::sqrt(under);
    return way >= 0 && way <= motion.length ? std::optional(way) : std::nullopt;
  }
};

LinearMotion along(const Vec3& direction, Real length) { return {*UnitVec3::make(direction), length}; }

TEST(FirstTouch, OfBallsIsTheLesserRoot) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Real> any(-1, 1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    Balls balls{{4 + any(random), 1.2 * any(random), 1.2 * any(random)}, 1 + 0.5 * any(random)};
    const LinearMotion motion = along({-1, 0.5 * any(random), 0.5 * any(random)}, 4 + 3 * any(random));
    const auto expected = balls.root(motion);
    const auto found = balls.cast(motion);
    ASSERT_EQ(found.has_value(), expected.has_value()) << i;
    if (found) {
      ++hits;
      // Where the paths meet at a slant the root is as uncertain as the distance over the speed of approach.
      const Real speed = std::fabs(dot(motion.direction, found->contact.normal));
      EXPECT_NEAR(found->travelled, *expected, 1e-13 / std::max(speed, 1e-7));
      EXPECT_LE(found->contact.distance, 1e-14);
    }
    EXPECT_LE(balls.asked, 40U);
  }
  EXPECT_GT(hits, 2500);
}

TEST(FirstTouch, WhatTouchesAtTheStartHasNoWay) {
  for (const Real gap : {0.0, -0.5, -1.5}) {
    for (const Real direction : {1.0, -1.0}) {
      Balls balls{{2 + gap, 0, 0}, 2};
      const auto found = balls.cast(along({direction, 0, 0}, 3));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->travelled, 0);
      EXPECT_NEAR(found->contact.distance, gap, 1e-15);
      EXPECT_EQ(balls.asked, 1U);
    }
  }
}

TEST(FirstTouch, EndsWhereTheWayDoes) {
  for (const Real beside : {-1e-9, 0.0, 1e-9}) {
    Balls balls{{5, 0, 0}, 2};
    EXPECT_EQ(balls.cast(along({-1, 0, 0}, 3 + beside)).has_value(), beside >= 0) << beside;
  }
  // Short of the contact by less than rounding.
  Balls short_by_rounding{{5, 0, 0}, 2};
  EXPECT_TRUE(short_by_rounding.cast(along({-1, 0, 0}, 3 * (1 - epsilon))));
  Balls apart{{5, 0, 0}, 2};
  EXPECT_FALSE(apart.cast({UnitVec3::axis_z(), 0}));
  EXPECT_FALSE(apart.cast(along({1, 0, 0}, 1e6)));
  EXPECT_FALSE(apart.cast(along({0, 1, 0}, 1e6)));
}

// Off the tangent by less than rounding the answer may be either; beyond it is certain, and never needs many steps.
TEST(FirstTouch, GrazingIsDecided) {
  for (const Real offset : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    Balls inside{{10, 2 - offset, 0}, 2}, outside{{10, 2 + offset, 0}, 2};
    const LinearMotion motion = along({-1, 0, 0}, 20);
    const auto found = inside.cast(motion);
    ASSERT_TRUE(found) << offset;
    // The chord begins sqrt(2 r d - d^2) before the tangent point.
    EXPECT_NEAR(found->travelled, 10 - std::sqrt((4 - offset) * offset), 1e-6) << offset;
    EXPECT_LE(inside.asked, 64U);
    if (offset > 1e-13) {
      EXPECT_FALSE(outside.cast(motion)) << offset;
    }
    EXPECT_LE(outside.asked, 64U);
  }
}

TEST(FirstTouch, LongWaysDoNotTunnel) {
  for (const Real way : {1e3, 1e6, 1e9}) {
    for (const Real radius : {1.0, 1e-3}) {
      Balls balls{{way, 0, 0}, radius};
      const auto found = balls.cast(along({-1, 0, 0}, 2 * way));
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->travelled, way - radius, 16 * epsilon * way);
    }
  }
}

TEST(FirstTouch, StopsAtTheMargin) {
  Balls balls{{5, 0, 0}, 2};
  const auto found = balls.cast(along({-1, 0, 0}, 5), 0.25);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->travelled, 2.75, 1e-14);
  EXPECT_NEAR(found->contact.distance, 0.25, 1e-14);
}

// A normal that is worth nothing costs steps and never the contact: what is certain is the distance alone.
TEST(FirstTouch, NeverPassesTheContactUnderAWrongNormal) {
  Balls balls{{5, 0.5, 0}, 2};
  const LinearMotion motion = along({-1, 0, 0}, 5);
  std::optional<FirstTouch> out;
  const auto distance_at = [&](Real way, Distance& found) {
    const Outcome outcome = balls.distance(motion, way, found);
    found.normal = {0, 0, 1};
    return outcome;
  };
  EXPECT_EQ(first_touch(
                motion, 7, 0, distance_at, [&](const Vec3& normal) { return dot(balls.offset, normal) - 2; }, out),
            Outcome::ok);
  ASSERT_TRUE(out);
  EXPECT_LE(out->travelled, *balls.root(motion) + 1e-14);
  EXPECT_NEAR(out->travelled, *balls.root(motion), 1e-12);
}

TEST(FirstTouch, HandsFailuresOn) {
  std::optional<FirstTouch> out;
  const auto fail = [](Real, Distance&) { return Outcome::unsupported; };
  EXPECT_EQ(first_touch(along({1, 0, 0}, 1), 1, 0, fail, [](const Vec3&) { return 0.0; }, out), Outcome::unsupported);
  EXPECT_FALSE(out);
}

TEST(FirstTouchByStrides, AgreesWithTheRoot) {
  Balls balls{{5, 0.5, 0}, 2};
  const LinearMotion motion = along({-1, 0, 0}, 9);
  for (const Real stride : {0.01, 0.3, 1.0}) {
    std::optional<FirstTouch> out;
    const auto distance_at = [&](Real way, Distance& found) { return balls.distance(motion, way, found); };
    EXPECT_EQ(first_touch_by_strides({0, 9}, 7, 0, stride, distance_at, out), Outcome::ok);
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->travelled, *balls.root(motion), 1e-13);
    EXPECT_NEAR(out->contact.distance, 0, 1e-13);
    out.reset();
    EXPECT_EQ(first_touch_by_strides({0, 1}, 7, 0, stride, distance_at, out), Outcome::ok);
    EXPECT_FALSE(out);
  }
}

// Overlap that counts for nothing is passed through.
TEST(FirstTouchByStrides, PassesWhatIsNotThere) {
  std::optional<FirstTouch> out;
  const auto distance_at = [](Real way, Distance& found) {
    found.distance = std::fabs(way - 2) - 1;
    found.upper = way < 1.5 ? infinity : found.distance;
    return Outcome::ok;
  };
  EXPECT_EQ(first_touch_by_strides({0, 9}, 7, 0, 0.1, distance_at, out), Outcome::ok);
  ASSERT_TRUE(out);
  EXPECT_NEAR(out->travelled, 1.5, 1e-13);
}

TEST(PassageOf, IsTheTimeThatBoxesOverlap) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<Real> any(-1, 1);
  const auto random_box = [&](Real spread) {
    return Aabb::around({spread * any(random), spread * any(random), spread * any(random)},
                        {0.6 + 0.5 * any(random), 0.6 + 0.5 * any(random), 0.6 + 0.5 * any(random)});
  };
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Aabb still = random_box(2), moving = random_box(2);
    Vec3 direction{any(random), any(random), any(random)};
    if (i % 4 == 0) {
      direction.x = 0;
    }
    const LinearMotion motion = along(direction, 3);
    const auto passage = passage_of(still, moving, motion);
    met += passage ? 1 : 0;
    for (int sample = 0; sample <= 300; ++sample) {
      const Real way = sample / 100.0;
      const Vec3 by = way * motion.direction.vec();
      const bool overlaps = still.overlaps({moving.low + by, moving.high + by});
      const bool says = passage && way >= passage->enter && way <= passage->leave;
      const bool is_at_end =
          passage && (std::fabs(way - passage->enter) < 1e-12 || std::fabs(way - passage->leave) < 1e-12);
      ASSERT_TRUE(overlaps == says || is_at_end) << i << " " << way;
    }
  }
  EXPECT_GT(met, 200);
  EXPECT_LT(met, 1800);
}

TEST(Swept, HoldsTheBoxAtBothEnds) {
  const Aabb box{{0, 0, 0}, {1, 2, 3}};
  const Aabb all = swept(box, along({0, -1, 0}, 9), 1, 4);
  EXPECT_EQ(all.low, (Vec3{0, -4, 0}));
  EXPECT_EQ(all.high, (Vec3{1, 1, 3}));
}

}  // namespace
