// SPDX-License-Identifier: Apache-2.0
// What wakes parts that sleep: VX-23 of the specification.
#include <functional>

#include "archive_support.hpp"
#include "sleep_room.hpp"

namespace {

using namespace abut_test;

TEST(Sleep, RemovingTheBottomWakesAll) {
  Room room;
  auto stack = room.add_stack(4);
  const auto other = room.add_stack(2, 10);
  room.step(until_asleep);
  ASSERT_EQ(room.asleep(), 6U);
  ASSERT_TRUE(succeeded(abut_part_destroy(room.universe, stack[0])));
  room.step();
  EXPECT_EQ(room.changed(false), (std::vector{stack[1].slot, stack[2].slot, stack[3].slot}));
  EXPECT_EQ(room.asleep(), 2U) << "the other stack sleeps on";
  room.step(9);
  EXPECT_EQ(room.asleep(), 2U);
  room.step();
  EXPECT_EQ(room.asleep(), 5U) << "what nobody moves sleeps again ten steps later";
}

TEST(Sleep, NobodyFallsAsleepInTheStepThatTakesTheSupportAway) {
  Room room;
  const auto stack = room.add_stack(3);
  room.step(until_asleep - 1);
  ASSERT_TRUE(succeeded(abut_part_destroy(room.universe, stack[0])));
  room.step();
  EXPECT_EQ(room.asleep(), 0U);
}

// Ways in which a support ends, each of which wakes what stands on it.
class SleepOnSupport : public testing::TestWithParam<std::string_view> {
 protected:
  void take_away(Room& room, abut_part_id part, abut_geometry_id geometry) {
    abut_geometry_options options = default_geometry_options();
    if (GetParam() == "destroyed") require(abut_part_destroy(room.universe, part));
    if (GetParam() == "its geometry destroyed") require(abut_geometry_destroy(room.universe, geometry));
    if (GetParam() == "parked") room.universe.park(geometry, ABUT_PARKING_SHORT_TERM);
    if (GetParam() == "parked for long") room.universe.park(geometry, ABUT_PARKING_LONG_TERM);
    if (GetParam() == "filtered") require(set_rule(room, part));
    if (GetParam() == "moved away") room.universe.move(part, at(0, 50, 0));
    if (GetParam() == "moved a little") room.universe.move(part, at(0, 0, 0.001));
    if (GetParam() == "a sensor") options.flags = ABUT_GEOMETRY_SENSOR;
    if (GetParam() == "masked") options.mask = 0;
    if (GetParam() == "reshaped") require(abut_geometry_set_shape(room.universe, geometry, room.ball));
    if (options.flags != 0 || options.mask == 0) require(abut_geometry_set_options(room.universe, geometry, &options));
  }
  static abut_status set_rule(const Room& room, abut_part_id part) {
    const abut_collidable its{ABUT_COLLIDABLE_PART, part.slot, part.generation};
    return abut_rule_set(room.universe, &its, &anything, ABUT_RULE_DISABLE);
  }
};

TEST_P(SleepOnSupport, WakesWhatItCarried) {
  for (const abut_motion motion : {ABUT_MOTION_DYNAMIC, ABUT_MOTION_ANIMATED, ABUT_MOTION_STATIC}) {
    Room room;
    const abut_part_id table = room.add_box(identity, motion);
    const abut_geometry_id top = room.boxes.back();
    const abut_part_id low = room.add_box(at(0, 0, 0.99)), high = room.add_box(at(0, 0, 1.98));
    const abut_part_id aside = room.add_box(at(20, 0, 0.49));
    room.step(until_asleep);
    ASSERT_TRUE(room.is_asleep(low) && room.is_asleep(high) && room.is_asleep(aside));
    take_away(room, table, top);
    room.step();
    EXPECT_FALSE(room.is_asleep(low));
    EXPECT_FALSE(room.is_asleep(high)) << "through what it stands on";
    EXPECT_TRUE(room.is_asleep(aside));
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, SleepOnSupport,
                         testing::Values("destroyed", "its geometry destroyed", "parked", "parked for long", "filtered",
                                         "moved away", "moved a little", "a sensor", "masked", "reshaped"));

TEST(Sleep, AProjectileWakesTheWholeStack) {
  Room room;
  const auto stack = room.add_stack(3);
  const abut_part_id bullet = room.universe.add_part(at(5, 0, 2.5));
  room.universe.add_geometry(bullet, room.ball);
  room.step(until_asleep);
  ASSERT_EQ(room.asleep(), 3U);
  room.universe.move(bullet, at(1.1, 0, 2.5));
  room.step();
  EXPECT_EQ(room.asleep(), 3U) << "near, not touching";
  room.universe.move(bullet, at(0.9, 0, 2.5));
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
  room.step(50);
  EXPECT_EQ(room.asleep(), 0U) << "as long as the bullet, which never sleeps, touches";
}

TEST(Sleep, AnyOtherPoseWakesAndTheSameOneDoesNot) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep);
  abut_pose pose{};
  require(abut_part_pose(room.universe, stack[1], &pose));
  room.universe.move(stack[1], pose);
  room.step();
  EXPECT_EQ(room.asleep(), 2U);
  pose.position.x = 1e-9;
  room.universe.move(stack[1], pose);
  EXPECT_TRUE(room.is_asleep(stack[1])) << "until the next step";
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
}

TEST(Sleep, WakingCountsAnewAsleepOrNot) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep - 1);
  ASSERT_TRUE(succeeded(abut_part_wake(room.universe, stack[0])));
  room.step(10);
  EXPECT_EQ(room.asleep(), 0U);
  room.step();
  EXPECT_EQ(room.asleep(), 2U);
  ASSERT_TRUE(succeeded(abut_parts_wake(room.universe, stack.data(), 1)));
  EXPECT_TRUE(room.is_asleep(stack[0])) << "until the next step";
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
  room.step(9);
  EXPECT_EQ(room.asleep(), 0U);
  room.step();
  EXPECT_EQ(room.asleep(), 2U);
}

TEST(Sleep, OtherThresholdsWakeAndEqualOnesDoNot) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep);
  room.set_sleep(stack[0], default_sleep());
  room.step();
  EXPECT_EQ(room.asleep(), 2U);
  abut_sleep other = default_sleep();
  other.steps = 11;
  room.set_sleep(stack[0], other);
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
  room.step(10);
  EXPECT_EQ(room.asleep(), 0U);
  room.step();
  EXPECT_EQ(room.asleep(), 2U);
  ASSERT_TRUE(succeeded(abut_parts_set_sleep(room.universe, stack.data(), nullptr, 2)));
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
  room.step(50);
  EXPECT_EQ(room.asleep(), 0U);
}

// Of a part that touches others before and after, and a geometry that touches nobody.
TEST(Sleep, ChangesOfItsGeometriesWake) {
  for (const std::string_view change : {"created", "destroyed", "another shape", "other options"}) {
    Room room;
    const auto stack = room.add_stack(2);
    const Shape crumb = make_sphere(0.1);
    const abut_geometry_id inside = room.universe.add_geometry(stack[1], crumb);
    abut_geometry_options options = default_geometry_options();
    options.user_data = 5;
    room.step(until_asleep);
    ASSERT_EQ(room.asleep(), 2U);
    if (change == "created") room.universe.add_geometry(stack[1], crumb);
    if (change == "destroyed") require(abut_geometry_destroy(room.universe, inside));
    if (change == "another shape") require(abut_geometry_set_shape(room.universe, inside, crumb));
    if (change == "other options") require(abut_geometry_set_options(room.universe, inside, &options));
    room.step();
    EXPECT_EQ(room.changed(false), slots_of(stack)) << change;
  }
}

TEST(Sleep, APartThatIsMadeStaticIsNotAsleep) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep);
  require(abut_part_set_motion(room.universe, stack[0], ABUT_MOTION_STATIC));
  room.step();
  EXPECT_EQ(room.changed(false), slots_of(stack));
  room.step(10);
  EXPECT_FALSE(room.is_asleep(stack[0]));
  EXPECT_TRUE(room.is_asleep(stack[1]));
}

TEST(Sleep, AMovingPlatformKeepsAwakeWhatItCarries) {
  Room room;
  const abut_part_id platform = room.add_box(at(0, 0, 5), ABUT_MOTION_ANIMATED), load = room.add_box(at(0, 0, 5.99));
  for (int step = 1; step <= 30; ++step) {
    room.universe.move(platform, at(0, 0, 5 + 1e-4 * (step % 2)));
    room.step();
    ASSERT_EQ(room.asleep(), 0U);
  }
  room.step();
  EXPECT_TRUE(room.is_asleep(load)) << "it has been calm all the time";
  room.universe.move(platform, at(0, 0, 5.001));
  room.step();
  EXPECT_FALSE(room.is_asleep(load));
}

TEST(Sleep, ADetectionWithoutTimeWakesForAReason) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep);
  room.universe.move(stack[0], at(30, 0, 0.49));
  require(abut_universe_refresh(room.universe));
  EXPECT_EQ(room.asleep(), 2U);
  require(abut_universe_detect_changed(room.universe));
  EXPECT_EQ(room.changed(false), slots_of(stack));
}

TEST(Sleep, DestroyedPartsLeaveNothingToTheirSlots) {
  Room room;
  const auto stack = room.add_stack(2);
  room.step(until_asleep);
  ASSERT_EQ(room.asleep(), 2U);
  require(abut_parts_destroy(room.universe, stack.data(), 2));
  std::uint32_t out = 0;
  EXPECT_TRUE(refused(abut_part_is_asleep(room.universe, stack[0], &out), ABUT_STALE_ID, {"part"}));
  const abut_part_id heir = room.universe.add_part(at(0, 0, 0.49));
  room.universe.add_geometry(heir, room.box);
  ASSERT_TRUE(heir.slot == stack[0].slot || heir.slot == stack[1].slot);
  EXPECT_FALSE(room.is_asleep(heir));
  room.step(50);
  EXPECT_EQ(room.asleep(), 0U);
  EXPECT_FALSE(room.is_asleep(heir)) << "it has no thresholds";
  room.set_sleep(heir, default_sleep());
  room.step(until_asleep - 1);
  EXPECT_EQ(room.asleep(), 0U);
  room.step();
  EXPECT_EQ(room.asleep(), 1U);
}

// An edit of a field wakes what lies on the samples that change.
TEST(Sleep, AnEditOfTerrainWakesWhatLiesThere) {
  constexpr std::uint32_t samples = 41;
  for (const bool raises : {false, true}) {
    Room room;
    const Shape flat =
        make_of_kind("height_field", {samples, samples, 1, 1, 0, 1}, std::vector<double>(samples * samples, 5.0));
    const abut_geometry_id ground = room.universe.add(flat, identity, ABUT_MOTION_STATIC);
    const abut_part_id near = room.add_box(at(10.5, 10.5, 5.49)), on_top = room.add_box(at(10.5, 10.5, 6.48));
    const abut_part_id beside = room.add_box(at(14.5, 10.5, 5.49)), far = room.add_box(at(35.5, 35.5, 5.49));
    room.step(until_asleep);
    ASSERT_EQ(room.asleep(), 4U);
    const std::vector<double> heights(4, raises ? 5.001 : 4);
    require(abut_geometry_set_heights(room.universe, ground, 10, 10, 2, 2, heights.data()));
    room.step();
    EXPECT_FALSE(room.is_asleep(near));
    EXPECT_FALSE(room.is_asleep(on_top)) << "through what it stands on";
    EXPECT_TRUE(room.is_asleep(beside));
    EXPECT_TRUE(room.is_asleep(far));
    room.step(until_asleep);
    EXPECT_EQ(room.asleep(), 4U);
  }
}

TEST(Sleep, AnEditOfTerrainThatADetectionHasSeenWakes) {
  Room room;
  const Shape flat = make_of_kind("height_field", {11, 11, 1, 1, 0, 1}, std::vector<double>(121, 5.0));
  const abut_geometry_id ground = room.universe.add(flat, identity, ABUT_MOTION_STATIC);
  const abut_part_id near = room.add_box(at(2.5, 2.5, 5.49)), far = room.add_box(at(8.5, 8.5, 5.49));
  room.step(until_asleep);
  const std::vector<double> heights(4, 5.001);
  require(abut_geometry_set_heights(room.universe, ground, 2, 2, 2, 2, heights.data()));
  require(abut_universe_detect_changed(room.universe));
  EXPECT_FALSE(room.is_asleep(near));
  EXPECT_TRUE(room.is_asleep(far));
}

// A strip of 40 cells, 5 above the floor but for two columns in the middle, which hold the box of the mesh.
Shape make_strip() {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t column = 0; column <= 40; ++column) {
    const double height = column == 19 ? 4 : column == 21 ? 6 : 5;
    xyz.insert(xyz.end(), {double(column), -2, height, double(column), 2, height});
    if (const std::uint32_t first = 2 * column; column < 40) {
      triangles.insert(triangles.end(), {first, first + 2, first + 3, first, first + 3, first + 1});
    }
  }
  abut_shape* out = nullptr;
  require(abut_mesh_create(xyz.data(), xyz.size() / 3, triangles.data(), triangles.size() / 3, nullptr, &out));
  return Shape(out);
}

// A loaded universe has meshes of which nothing was asked so far.
TEST(Sleep, AnEditOfAMeshWakesWhatLiesThereAlsoAfterLoading) {
  const std::vector<double> raised{2, -2, 5.001, 2, 2, 5.001};
  const std::vector<std::uint32_t> vertices{4, 5}, triangles{4, 5};
  const std::vector<std::function<abut_status(abut_universe*, abut_geometry_id)>> edits{
      [&](abut_universe* universe, abut_geometry_id ground) {
        return abut_geometry_set_vertices(universe, ground, 4, raised.data(), 2);
      },
      [&](abut_universe* universe, abut_geometry_id ground) {
        return abut_geometry_set_vertices_at(universe, ground, vertices.data(), raised.data(), 2);
      },
      [&](abut_universe* universe, abut_geometry_id ground) {
        return abut_geometry_remove_triangles(universe, ground, triangles.data(), 2);
      }};
  for (const auto& edit : edits) {
    Room room;
    const abut_geometry_id ground = room.universe.add(make_strip(), identity, ABUT_MOTION_STATIC);
    const abut_part_id near = room.add_box(at(2.5, 0, 5.49)), far = room.add_box(at(35.5, 0, 5.49));
    room.step(until_asleep);
    ASSERT_EQ(room.asleep(), 2U);
    const Owned copy = loaded(saved(room.universe));
    require(edit(room.universe, ground));
    require(edit(copy.get(), ground));
    room.step();
    require(abut_universe_step(copy.get(), dt));
    EXPECT_FALSE(room.is_asleep(near));
    EXPECT_TRUE(room.is_asleep(far));
    std::uint64_t hash = 0;
    require(abut_universe_hash(copy.get(), &hash));
    EXPECT_EQ(hash, room.universe.hash());
  }
}

}  // namespace
