// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "../shape_casts.hpp"

import abut.pairs.any_shape;

namespace {

using namespace test::casts;

TEST(CastShapes, OfBallsIsTheClosedForm) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Real r = random.in(0.1, 1), s = random.in(0.1, 1);
    const Pose pose_a = random.pose(random.vector(1)), pose_b = random.pose(Vec3{4, 0, 0} + random.vector(1));
    const Vec3 by_a{random.in(0, 6), random.in(-1, 1), random.in(-1, 1)}, by_b = random.vector(2);
    const auto hit = cast(make("sphere", {r}), pose_a, by_a, make("sphere", {s}), pose_b, by_b);
    // |p + t v| = r + s
    const Vec3 p = pose_b.position - pose_a.position, v = by_b - by_a;
    const Real half = dot(p, v), under = half * half - squared_norm(v) * (squared_norm(p) - (r + s) * (r + s));
    const Real root = under < 0 ? infinity : (-half - std::sqrt(under)) / squared_norm(v);
    const bool is_met = root >= 0 && root <= 1;
    ASSERT_EQ(hit.has_value(), is_met) << i;
    if (hit) {
      ++hits;
      const Real slant = std::fabs(dot(v, hit->contact.normal)) / norm(v);
      EXPECT_NEAR(hit->fraction, root, 1e-13 / std::max(slant, 1e-6));
      const Vec3 centre_a = pose_a.position + hit->fraction * by_a, centre_b = pose_b.position + hit->fraction * by_b;
      EXPECT_NEAR(norm(hit->contact.point_a - centre_a), r, 1e-13);
      EXPECT_NEAR(norm(hit->contact.point_b - centre_b), s, 1e-13);
      EXPECT_GT(dot(hit->contact.normal, centre_b - centre_a), 0);
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(CastShapes, OfBallAndPlaneIsTheClosedForm) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Pose ball = random.pose({random.in(-5, 5), random.in(-5, 5), random.in(1.5, 5)});
    const Vec3 by{random.in(-5, 5), random.in(-5, 5), random.in(-8, 1)};
    const Real way = (1 - ball.position.z) / by.z;
    for (const bool is_plane_first : {false, true}) {
      const ShapeHandle a = make("sphere", {1}), b = make("plane", {0, 0, 1, 0});
      const auto hit =
          is_plane_first ? cast(b, at({0, 0, 0}), {0, 0, 0}, a, ball, by) : cast(a, ball, by, b, at({0, 0, 0}));
      ASSERT_EQ(hit.has_value(), way >= 0 && way <= 1);
      if (hit) {
        EXPECT_NEAR(hit->fraction, way, 1e-13);
        EXPECT_NEAR(hit->contact.normal.z, is_plane_first ? 1 : -1, 1e-15);
      }
    }
  }
}

// Boxes along the axes meet when they have met along each.
TEST(CastShapes, OfAlignedBoxesIsTheClosedForm) {
  Random random(3);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 half_a{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)},
        half_b{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)};
    const Vec3 p = Vec3{4, 0, 0} + random.vector(1.5), v = Vec3{-5, 0, 0} + random.vector(2);
    Real enter = 0, leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Real reach = half_a[axis] + half_b[axis], first = (-reach - p[axis]) / v[axis],
                 last = (reach - p[axis]) / v[axis];
      enter = std::max(enter, std::min(first, last));
      leave = std::min(leave, std::max(first, last));
    }
    for (const bool as_hulls : {false, true}) {
      const ShapeHandle a = as_hulls ? make_hull_of_box(half_a) : make("box", {half_a.x, half_a.y, half_a.z});
      const ShapeHandle b = make("box", {half_b.x, half_b.y, half_b.z});
      const auto hit = cast(a, at({0, 0, 0}), {0, 0, 0}, b, at(p), v);
      ASSERT_EQ(hit.has_value(), enter <= leave) << i;
      if (hit) {
        ++hits;
        EXPECT_NEAR(hit->fraction, enter, 1e-12);
      }
    }
  }
  EXPECT_GT(hits, 300);
}

// The first zero of the distance, found without looking at normals: the distance of convex shapes is convex in time, so
// its minimum brackets the zero.
std::optional<Real> bisected(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b,
                             const Vec3& by_b, Real slack) {
  const auto distance = [&](Real t) {
    Distance out{};
    EXPECT_EQ(pair_distance(a, b, pose_a, {pose_b.rotation, pose_b.position + t * by_b}, {}, out), Outcome::ok);
    return out.distance;
  };
  if (distance(0) <= 0) {
    return 0;
  }
  Real low = 0, high = 1;
  for (int i = 0; i < 70 && distance(high) > -slack; ++i) {
    const Real third = (high - low) / 3;
    if (distance(low + third) <= 0) {
      high = low + third;
    } else if (distance(high - third) <= 0 || distance(low + third) > distance(high - third)) {
      low = distance(high - third) <= 0 ? low : low + third;
      high = distance(high - third) <= 0 ? high - third : high;
    } else {
      high = high - third;
    }
  }
  if (distance(high) > slack) {
    return std::nullopt;
  }
  low = 0;
  for (int i = 0; i < 60; ++i) {
    const Real middle = 0.5 * (low + high);
    (distance(middle) > slack ? low : high) = middle;
  }
  return high;
}

std::vector<ShapeHandle> make_solids() {
  return {make("sphere", {0.7}),
          make("box", {0.5, 0.7, 0.3}),
          make("capsule", {0.3, 0.6}),
          make_hull_of_box({0.4, 0.5, 0.6}),
          make("cylinder", {0.5, 0.6}),
          make("cone", {0.6, 0.7}),
          make("ellipsoid", {0.4, 0.6, 0.8}),
          make("segment", {0.8}),
          make("triangle", {0.8, 0, 0, -0.4, 0.7, 0.1, -0.4, -0.7, -0.1}),
          make("point", {})};
}

TEST(CastShapes, OfSolidsAgreesWithBisection) {
  Random random(4);
  const std::vector<ShapeHandle> solids = make_solids();
  constexpr Real size = 2;
  int hits = 0, misses = 0;
  for (const AnyShape& a : solids) {
    for (const AnyShape& b : solids) {
      for (int i = 0; i < 3; ++i) {
        const Pose pose_a = random.pose({0, 0, 0}), pose_b = random.pose(Vec3{3, 0, 0} + random.vector(0.7));
        const Vec3 by{-random.in(2, 5), random.in(-1, 1), random.in(-1, 1)};
        const auto hit = cast(a, pose_a, {0, 0, 0}, b, pose_b, by);
        const auto nearest = bisected(a, pose_a, b, pose_b, by, -1e-9 * size),
                   furthest = bisected(a, pose_a, b, pose_b, by, 1e-9 * size);
        // A hit that a shift by the tolerance undoes may be either.
        if (nearest) {
          ASSERT_TRUE(hit) << kind_name(kind_in_pairs(a)) << " " << kind_name(kind_in_pairs(b));
        }
        if (!furthest) {
          ASSERT_FALSE(hit) << kind_name(kind_in_pairs(a)) << " " << kind_name(kind_in_pairs(b));
        }
        if (hit && nearest) {
          ++hits;
          EXPECT_LE(hit->fraction, *nearest + 1e-12)
              << kind_name(kind_in_pairs(a)) << " " << kind_name(kind_in_pairs(b));
          EXPECT_GE(hit->fraction, *furthest - 1e-12)
              << kind_name(kind_in_pairs(a)) << " " << kind_name(kind_in_pairs(b));
          EXPECT_LE(hit->contact.distance, 1e-9 * size);
        }
        misses += hit ? 0 : 1;
      }
    }
  }
  EXPECT_GT(hits, 50);
  EXPECT_GT(misses, 20);
}

TEST(CastShapes, SwappedSidesGiveTheSameTouch) {
  Random random(5);
  std::vector<ShapeHandle> shapes = make_solids();
  shapes.push_back(make_square(2, false));
  shapes.push_back(make("particles", {0.3}, {0, 0, 0, 0.8, 0.2, 0, -0.5, 0.6, 0.1}));
  for (const AnyShape& a : shapes) {
    for (const AnyShape& b : shapes) {
      const Pose pose_a = random.pose({0, 0, 0}), pose_b = random.pose({5, 0.1, 0.2});
      const Vec3 by_a{2, 0.1, 0}, by_b{-4, 0, 0.1};
      const auto forth = cast(a, pose_a, by_a, b, pose_b, by_b), back = cast(b, pose_b, by_b, a, pose_a, by_a);
      ASSERT_EQ(forth.has_value(), back.has_value())
          << kind_name(kind_in_pairs(a)) << " " << kind_name(kind_in_pairs(b));
      if (forth) {
        EXPECT_NEAR(forth->fraction, back->fraction, 1e-9);
        EXPECT_EQ(forth->child_a, back->child_b);
        EXPECT_EQ(forth->feature_b, back->feature_a);
      }
    }
  }
}

// What is thin, far, fast or of unlike sizes is met all the same.
TEST(CastShapes, NothingTunnels) {
  const std::vector<ShapeHandle> plates{make("box", {1, 1, 1e-6}),
                                        make_hull_of_box({1, 1, 1e-6}),
                                        make_square(1, false),
                                        make_square(1, true),
                                        make("triangle", {-2, -2, 0, 2, -2, 0, 0, 2, 0}),
                                        make("cylinder", {1, 1e-6})};
  for (const AnyShape& plate : plates) {
    for (const AnyShape& bullet :
         {make("sphere", {0.01}), make("box", {0.02, 0.03, 1e-6}), make("point", {}), make("capsule", {1e-3, 0.01})}) {
      for (const Real way : {10.0, 1e3, 1e6}) {
        const Aabb box = aabb_of(bullet, Pose::identity()), wall = aabb_of(plate, Pose::identity());
        const auto hit = cast(bullet, at({0.1, 0.05, 0.3 * way}), {0, 0, -way}, plate, at({0, 0, 0}));
        ASSERT_TRUE(hit) << kind_name(kind_in_pairs(plate)) << " " << kind_name(kind_in_pairs(bullet)) << " " << way;
        EXPECT_NEAR(hit->fraction * way, 0.3 * way - wall.high.z + box.low.z, 1e-9 + 1e-15 * way)
            << kind_name(kind_in_pairs(plate)) << " " << kind_name(kind_in_pairs(bullet));
      }
    }
  }
  const auto speck =
      cast(make("sphere", {1}), at({0.3, 0.2, 2e6}), {0, 0, -2e6}, make("box", {1e6, 1e6, 1e6}), at({0, 0, 0}));
  ASSERT_TRUE(speck);
  EXPECT_NEAR(speck->fraction, (1e6 - 1) / 2e6, 1e-15);
}

TEST(CastShapes, TellsTheDepthOfWhatOverlapsAtTheStart) {
  for (const Vec3& by : {Vec3{0, 0, 0}, Vec3{0, 0, 5}, Vec3{0, 0, -5}}) {
    for (const AnyShape& ground : {make("box", {3, 3, 1}), make("plane", {0, 0, 1, 1})}) {
      const auto hit = cast(make("sphere", {1}), at({0, 0, 1.75}), by, ground, at({0, 0, 0}));
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->fraction, 0);
      EXPECT_NEAR(hit->contact.distance, -0.25, 1e-14);
    }
    const auto hit = cast(make("sphere", {1}), at({0, 0, 0.75}), by, make_square(3, true), at({0, 0, 0}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->fraction, 0);
    EXPECT_NEAR(hit->contact.distance, -0.25, 1e-14);
  }
}

TEST(CastShapes, KeepsTheMargin) {
  const ShapeHandle ball = make("sphere", {1});
  const auto solids = cast(ball, at({0, 0, 0}), {10, 0, 0}, ball, at({5, 0, 0}), {0, 0, 0}, 0.5);
  ASSERT_TRUE(solids);
  EXPECT_NEAR(solids->fraction, 0.25, 1e-14);
  EXPECT_NEAR(solids->contact.distance, 0.5, 1e-14);
  const auto sheet = cast(ball, at({0, 0, 5}), {0, 0, -5}, make_square(3, false), at({0, 0, 0}), {0, 0, 0}, 0.5);
  ASSERT_TRUE(sheet);
  EXPECT_NEAR(sheet->fraction, 0.7, 1e-14);
}

TEST(CastShapes, SaysWhatHasNoAnswer) {
  std::optional<ShapeCastHit> hit;
  const ShapeHandle plane = make("plane", {0, 0, 1, 0});
  EXPECT_EQ(cast_shapes(plane, at({0, 0, 0}), {0, 0, -1}, plane, at({0, 0, -3}), {0, 0, 0}, {}, 1, hit),
            Outcome::unsupported);
  EXPECT_FALSE(hit);
}

}  // namespace
