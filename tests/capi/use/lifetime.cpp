// SPDX-License-Identifier: Apache-2.0
// Who owns what, and for how long.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(Lifetime, AUniverseKeepsItsShapes) {
  Universe universe;
  {
    const Shape ball = make_sphere(1.0);
    const Shape block = make_box(1.0, 1.0, 1.0);
    universe.add(ball, at(0, 0, 0));
    universe.add(block, at(1.5, 0, 0));
  }
  const auto contacts = universe.step();
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].distance, -0.5, 1e-12);
}

TEST(Lifetime, AShapeOutlivesItsUniverse) {
  const Shape ball = make_sphere(2.0);
  {
    Universe universe;
    universe.add(ball, identity);
  }
  double radius = 0.0;
  std::size_t count = 0;
  ASSERT_TRUE(succeeded(abut_shape_parameters(ball, &radius, 1, &count)));
  EXPECT_EQ(radius, 2.0);
}

TEST(Lifetime, ARetainedShapeOfADestroyedGeometryLives) {
  Universe universe;
  const abut_geometry_id geometry = [&] {
    const Shape ball = make_sphere(2.0);
    return universe.add(ball, identity);
  }();
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  ASSERT_TRUE(succeeded(abut_geometry_describe(universe, geometry, &info)));
  abut_shape_retain(info.shape);
  const Shape kept(info.shape);
  ASSERT_TRUE(succeeded(abut_geometry_destroy(universe, geometry)));
  EXPECT_EQ(abut_shape_kind_of(kept), abut_shape_kind_by_name("sphere"));
}

TEST(Lifetime, DestroyingAPartDestroysItsGeometries) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id geometry = universe.add_geometry(part, ball);
  universe.add(ball, at(1, 0, 0));
  ASSERT_EQ(universe.step().size(), 1U);
  ASSERT_TRUE(succeeded(abut_part_destroy(universe, part)));
  EXPECT_EQ(abut_geometry_destroy(universe, geometry), abut_status{ABUT_STALE_ID});
  EXPECT_TRUE(universe.step().empty());
}

TEST(Lifetime, AReusedSlotMakesTheOldIdStale) {
  Universe universe;
  abut_part_id part = universe.add_part(identity);
  for (int round = 0; round < 100; ++round) {
    ASSERT_TRUE(succeeded(abut_part_destroy(universe, part)));
    const abut_part_id next = universe.add_part(identity);
    EXPECT_FALSE(next == part);
    EXPECT_EQ(abut_part_destroy(universe, part), abut_status{ABUT_STALE_ID});
    part = next;
  }
}

TEST(Lifetime, SlotsAreOneBased) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id geometry = universe.add_geometry(part, ball);
  EXPECT_GE(part.slot, 1U);
  EXPECT_GE(geometry.slot, 1U);
}

TEST(Lifetime, UserDataComesBack) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const abut_part_id part = universe.add_part(identity, ABUT_MOTION_STATIC, 0xFFFF'FFFF'FFFF'FFFFU);
  std::uint64_t user_data = 0;
  ASSERT_TRUE(succeeded(abut_part_user_data(universe, part, &user_data)));
  EXPECT_EQ(user_data, 0xFFFF'FFFF'FFFF'FFFFU);

  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  options.user_data = 0x1234'5678'9ABC'DEF0U;
  options.tolerance = 0.25;
  options.pose = at(1, 2, 3);
  abut_geometry_id geometry{};
  ASSERT_TRUE(succeeded(abut_geometry_create(universe, part, ball, &options, &geometry)));
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  ASSERT_TRUE(succeeded(abut_geometry_describe(universe, geometry, &info)));
  EXPECT_EQ(info.user_data, 0x1234'5678'9ABC'DEF0U);
  EXPECT_EQ(info.tolerance, 0.25);
  EXPECT_EQ(info.part, part);
  EXPECT_EQ(info.shape, ball);
  EXPECT_EQ(info.kind, abut_shape_kind_by_name("sphere"));
  EXPECT_EQ(info.local.position.y, 2.0);
  EXPECT_EQ(info.pose.position.z, 3.0);
}

TEST(Lifetime, RevisionGrowsWithChangesOnly) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  abut_revision before{};
  abut_revision after{};
  const auto part = universe.add_part(identity);
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &before)));
  const auto geometry = universe.add_geometry(part, ball);
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &after)));
  EXPECT_GT(after.geometries, before.geometries);
  before = after;
  const abut_pose pose = at(1, 0, 0);
  ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &after)));
  EXPECT_GT(after.poses, before.poses);
  EXPECT_EQ(after.geometries, before.geometries);
  before = after;
  universe.step();
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &after)));
  EXPECT_EQ(after.poses, before.poses);
  EXPECT_EQ(after.geometries, before.geometries);
  ASSERT_TRUE(succeeded(abut_geometry_destroy(universe, geometry)));
  ASSERT_TRUE(succeeded(abut_universe_revision(universe, &after)));
  EXPECT_GT(after.geometries, before.geometries);
}

TEST(Lifetime, CountersAreThoseOfTheRevision) {
  Universe universe;
  const Shape ball = make_sphere(1.0);
  const std::uint64_t* geometries = nullptr;
  const std::uint64_t* poses = nullptr;
  ASSERT_TRUE(succeeded(abut_universe_counters(universe, &geometries, &poses)));
  const auto agree = [&] {
    abut_revision revision{};
    EXPECT_TRUE(succeeded(abut_universe_revision(universe, &revision)));
    return *geometries == revision.geometries && *poses == revision.poses;
  };
  EXPECT_TRUE(agree());
  const auto part = universe.add_part(identity);
  const auto geometry = universe.add_geometry(part, ball);
  EXPECT_TRUE(agree());
  const abut_pose pose = at(1, 0, 0);
  ASSERT_TRUE(succeeded(abut_part_set_pose(universe, part, &pose)));
  EXPECT_TRUE(agree());
  ASSERT_TRUE(succeeded(abut_geometry_destroy(universe, geometry)));
  EXPECT_TRUE(agree());
}

}  // namespace
