// SPDX-License-Identifier: Apache-2.0
// Single parts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

abut_part_options default_options() {
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  return options;
}

TEST(PartOptionsInit, IgnoresNull) { abut_part_options_init(nullptr, 0); }

TEST(PartOptionsInit, FillsInTheDefaults) {
  Out<abut_part_options> options;
  abut_part_options_init(options.address(), sizeof(abut_part_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_part_options));
  EXPECT_EQ(options.value().motion, abut_motion{ABUT_MOTION_DYNAMIC});
  EXPECT_EQ(options.value().pose.position.x, 0.0);
  EXPECT_EQ(options.value().pose.orientation.w, 1.0);
  EXPECT_EQ(options.value().pose.orientation.x, 0.0);
  EXPECT_EQ(options.value().user_data, 0U);
}

TEST(PartCreate, RefusesNullPointers) {
  const Scene scene;
  Out<abut_part_id> out;
  EXPECT_TRUE(refused(abut_part_create(nullptr, nullptr, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_part_create(scene.universe, nullptr, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartCreate, RefusesNonFiniteAndOtherBadPoses) {
  const Scene scene;
  Out<abut_part_id> out;
  expect_pose_field_checked([&](const abut_pose& pose) {
    abut_part_options options = default_options();
    options.pose = pose;
    return abut_part_create(scene.universe, &options, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartCreate, RefusesUnknownMotion) {
  const Scene scene;
  Out<abut_part_id> out;
  for (const abut_motion motion : {3U, 77U, 0xFFFFFFFFU}) {
    abut_part_options options = default_options();
    options.motion = motion;
    EXPECT_TRUE(refused(abut_part_create(scene.universe, &options, out.address()), ABUT_UNKNOWN_VALUE,
                        {"motion", std::to_string(motion)}));
  }
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartCreate, RefusesWrongStructSize) {
  const Scene scene;
  Out<abut_part_id> out;
  expect_struct_size_checked(default_options(), [&](const abut_part_options* wrong) {
    return abut_part_create(scene.universe, wrong, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartCreate, AcceptsLaterOptionsWithZeroTail) {
  const Scene scene;
  abut_part_id part{};
  expect_zero_tail_accepted(default_options(), [&](const abut_part_options* later) {
    return abut_part_create(scene.universe, later, &part);
  });
  EXPECT_NE(part.slot, 0U);
}

TEST(PartDestroy, RefusesNullUniverse) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_part_destroy(nullptr, scene.part), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

TEST(PartDestroy, RefusesStaleIds) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_destroy(scene.universe, stale), ABUT_STALE_ID, {"part", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartSetPose, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_part_set_pose(nullptr, scene.part, &identity), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_part_set_pose(scene.universe, scene.part, nullptr), ABUT_NULL_ARGUMENT, {"pose", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartSetPose, RefusesStaleIds) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_set_pose(scene.universe, stale, &identity), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartSetPose, RefusesNonFiniteAndOtherBadPoses) {
  const Scene scene;
  expect_pose_checked("pose",
                      [&](const abut_pose* pose) { return abut_part_set_pose(scene.universe, scene.part, pose); });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartPose, RefusesNullPointers) {
  const Scene scene;
  Out<abut_pose> out;
  EXPECT_TRUE(refused(abut_part_pose(nullptr, scene.part, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_part_pose(scene.universe, scene.part, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartPose, RefusesStaleIds) {
  const Scene scene;
  Out<abut_pose> out;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_pose(scene.universe, stale, out.address()), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartUserData, RefusesNullPointers) {
  const Scene scene;
  Out<std::uint64_t> out;
  EXPECT_TRUE(
      refused(abut_part_user_data(nullptr, scene.part, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_part_user_data(scene.universe, scene.part, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartUserData, RefusesStaleIds) {
  const Scene scene;
  Out<std::uint64_t> out;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_user_data(scene.universe, stale, out.address()), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartGeometries, RefusesNullPointers) {
  const Scene scene;
  OutArray<abut_geometry_id> out(2);
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_part_geometries(nullptr, scene.part, out.data(), 2, count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_part_geometries(scene.universe, scene.part, nullptr, 2, count.address()), ABUT_NULL_ARGUMENT,
                      {"geometries", "null"}));
  EXPECT_TRUE(refused(abut_part_geometries(scene.universe, scene.part, out.data(), 2, nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(PartGeometries, RefusesStaleIds) {
  const Scene scene;
  OutArray<abut_geometry_id> out(2);
  Out<std::size_t> count;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_geometries(scene.universe, stale, out.data(), 2, count.address()), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

}  // namespace
