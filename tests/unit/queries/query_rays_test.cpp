// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "query_scene.hpp"

import abut.universe;

namespace {

using namespace test::queries;

std::vector<RayContact> cast(const Universe& universe, const Vec3& origin, const Vec3& direction, Real most,
                             RayStart start = RayStart::far_side) {
  return cast_ray(universe, {origin, UnitVec3::make(direction).value(), most}, {}, HitMode::all, start);
}

TEST(RayQueries, MeetASurfaceThatTheyJustReach) {
  Random random(9);
  for (int i = 0; i < 500; ++i) {
    Universe universe({}, 1);
    const Placement placement{random.vector(3), random.turn()};
    add(universe, make_handle("box", {0.5, 0.6, 0.7}), placement);
    universe.refresh();
    // To a point of a face, as far as that is.
    const Vec3 above = placement.pose() * Vec3{0.3, -0.2, 4}, down = placement.pose() * Vec3{0.1, 0.2, 0.7} - above;
    EXPECT_EQ(cast(universe, above, down, norm(down)).size(), 1U) << i;
    const Vec3 inside = placement.pose() * Vec3{0.1, 0.2, 0.3}, origin = random.vector(1) + Vec3{9, 0, 0};
    const Vec3 direction = inside - origin;
    const auto hit = cast(universe, origin, direction, infinity);
    ASSERT_EQ(hit.size(), 1U);
    const Real most = hit.front().distance;
    const auto again = cast(universe, origin, direction, most);
    ASSERT_EQ(again.size(), 1U) << i;
    EXPECT_LE(again.front().distance, most);
    EXPECT_TRUE(cast(universe, origin, direction, most * (1 - 1e-12)).empty());
  }
  Universe universe({}, 1);
  add(universe, make_handle("sphere", {1}), at(0, 0, 0));
  universe.refresh();
  EXPECT_EQ(cast(universe, {-5, 0, 0}, {1, 0, 0}, 4).size(), 1U);
  EXPECT_EQ(cast(universe, {-5, 0, 0}, {1, 0, 0}, 3.9999999).size(), 0U);
}

TEST(RayQueries, CountSharedEdgesAndCornersOnce) {
  Universe universe({}, 1);
  const GeometryId sheet = add(universe, make_square(1), at(0, 0, 0));
  add(universe, make_handle("box", {1, 1, 1}), at(-1, 0, -2));
  add(universe, make_handle("box", {1, 1, 1}), at(1, 0, -2));
  universe.refresh();
  for (const Vec3& through : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{1, 1, 0}, Vec3{1, 0.3, 0}}) {
    const auto hits = cast(universe, through + Vec3{0, 0, 5}, {0, 0, -1}, 5.5);
    ASSERT_EQ(hits.size(), 1U) << through.x;
    EXPECT_EQ(hits.front().geometry, sheet);
    EXPECT_EQ(hits.front().distance, 5);
  }
  // Between two boxes that share a face, each is met once, and the first slot wins.
  const auto both = cast(universe, {0, 0, 5}, {0, 0, -1}, 100);
  ASSERT_EQ(both.size(), 3U);
  EXPECT_EQ(both[1].distance, both[2].distance);
  EXPECT_LT(both[1].geometry.slot, both[2].geometry.slot);
}

TEST(RayQueries, StartInsideAsAskedFor) {
  struct Case {
    ShapeHandle shape;
    Vec3 inside, outside;
  };
  const std::vector<PlacedShape> pierced{{make_handle("box", {1, 1, 1}), Pose::identity()},
                                         {make_handle("sphere_hole", {0.5}), Pose::identity()}};
  for (const Case& each : {Case{make_handle("sphere", {1}), {0.2, 0, 0}, {0, 0, 1.2}},
                           Case{make_handle("box", {1, 1, 1}), {0.9, 0, 0}, {0, 0, 1.2}},
                           Case{make_handle("plane", {0, 0, 1, 0.5}), {0, 0, -3}, {0, 0, 1.2}},
                           Case{make_dumbbell(), {-0.8, 0.2, 0}, {0, 0.3, 0}},
                           Case{make_handle("particles", {0.2}, {0, 0, 0, 1, 0, 0}), {1.1, 0, 0}, {0.5, 0, 0}},
                           Case{ShapeHandle(make_composite(pierced).value()), {0.8, 0, 0}, {0.3, 0, 0}}}) {
    Universe universe({}, 1);
    Random random(10);
    const Placement placement{random.vector(3), random.turn()};
    const GeometryId id = add(universe, each.shape, placement);
    universe.refresh();
    const Pose pose = placement.pose();
    const Vec3 up = pose.rotation * Vec3{0.1, 0.2, 1}, start = pose * each.inside;
    const auto far_side = cast(universe, start, up, infinity),
               solid = cast(universe, start, up, infinity, RayStart::solid);
    ASSERT_EQ(far_side.size(), 1U);
    EXPECT_GT(far_side.front().distance, 0.01);
    ASSERT_EQ(solid.size(), 1U);
    EXPECT_EQ(solid.front().geometry, id);
    EXPECT_EQ(solid.front().distance, 0);
    EXPECT_EQ(solid.front().normal, (Vec3{0, 0, 0}));
    EXPECT_EQ(solid.front().point, start);
    EXPECT_TRUE(cast(universe, start, up, infinity, RayStart::skip).empty());
    // Outside of it all three are the same.
    const Vec3 beside = pose * each.outside;
    const auto plain = cast(universe, beside, pose * each.inside - beside, infinity);
    ASSERT_EQ(plain.size(), 1U);
    for (const RayStart other : {RayStart::solid, RayStart::skip}) {
      const auto same = cast(universe, beside, pose * each.inside - beside, infinity, other);
      ASSERT_EQ(same.size(), 1U);
      EXPECT_EQ(same.front().distance, plain.front().distance);
    }
  }
}

TEST(RayQueries, NameTheChildOfAComposite) {
  Universe universe({}, 1);
  const Placement placement{{1, 2, 3}, normalized(Quat{1, 0.3, 0.2, 0.1}).value()};
  add(universe, make_dumbbell(), placement);
  universe.refresh();
  const Pose pose = placement.pose();
  for (const auto& [x, child] : {std::pair{-0.8, 0U}, std::pair{0.05, 1U}, std::pair{0.8, 2U}}) {
    const auto hits = cast(universe, pose * Vec3{x, 0.02, 5}, pose.rotation * Vec3{0, 0, -1}, 10);
    ASSERT_EQ(hits.size(), 1U);
    EXPECT_EQ(hits.front().child, child);
  }
}

TEST(QueriesOfAUniverse, SeePosesOfTheLastRefresh) {
  Universe universe({}, 1);
  const GeometryId id = add(universe, make_handle("sphere", {1}), at(0, 0, 0));
  universe.refresh();
  const PartId part = universe.describe(id).value().part;
  const Placement aside = at(0, 10, 0);
  ASSERT_TRUE(universe.set_poses(std::span(&part, 1), std::span(&aside, 1)));
  EXPECT_EQ(cast(universe, {-5, 0, 0}, {1, 0, 0}, 10).size(), 1U);
  universe.refresh();
  EXPECT_EQ(cast(universe, {-5, 0, 0}, {1, 0, 0}, 10).size(), 0U);
  EXPECT_EQ(cast(universe, {-5, 10, 0}, {1, 0, 0}, 10).size(), 1U);
}

TEST(PointQueries, FindSolidsAndSurfaces) {
  Universe universe({}, 1);
  const GeometryId ball = add(universe, make_handle("sphere", {1}), at(0, 0, 0));
  const GeometryId sheet = add(universe, make_square(2), at(0, 0, 0));
  const GeometryId ground = add(universe, make_handle("plane", {0, 0, 1, 0}), at(0, 0, -0.5));
  universe.refresh();
  const auto at_point = [&](const Vec3& point) { return find_at_point(universe, point, {}); };
  EXPECT_EQ(at_point({0.2, 0.1, 0}), (std::vector{ball, sheet}));
  EXPECT_EQ(at_point({0.2, 0.1, 0.1}), std::vector{ball});
  EXPECT_EQ(at_point({0, 0, -0.75}), (std::vector{ball, ground}));
  EXPECT_EQ(at_point({0, 0, 1}), std::vector{ball});
  EXPECT_EQ(at_point({0, 0, 1 + 1e-9}), std::vector<GeometryId>{});
  EXPECT_EQ(at_point({0, 0, -1e6}), std::vector{ground});
  EXPECT_EQ(at_point({1.5, 0, 0}), std::vector{sheet});
}

}  // namespace
