// SPDX-License-Identifier: Apache-2.0
// Batches of parts under bad input: one bad element spoils all, whichever it is.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

std::vector<abut_part_options> three_options() {
  std::vector<abut_part_options> options(3);
  for (abut_part_options& each : options) abut_part_options_init(&each, sizeof each);
  return options;
}

TEST(PartsCreate, RefusesNullPointers) {
  const Scene scene;
  const auto options = three_options();
  OutArray<abut_part_id> out(3);
  EXPECT_TRUE(
      refused(abut_parts_create(nullptr, options.data(), 3, out.data()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_create(scene.universe, nullptr, 3, out.data()), ABUT_NULL_ARGUMENT, {"options", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_create(scene.universe, options.data(), 3, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsCreate, RefusesOverflowingCounts) {
  const Scene scene;
  const auto options = three_options();
  OutArray<abut_part_id> out(3);
  expect_overflow_refused(sizeof(abut_part_options), "count", [&](std::size_t count) {
    return abut_parts_create(scene.universe, options.data(), count, out.data());
  });
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsCreate, RefusesOneBadElementAndCreatesNone) {
  const Scene scene;
  OutArray<abut_part_id> out(3);
  for (std::size_t place = 0; place < 3; ++place) {
    auto options = three_options();
    options.at(place).motion = 77;
    EXPECT_TRUE(refused(abut_parts_create(scene.universe, options.data(), 3, out.data()), ABUT_UNKNOWN_VALUE,
                        {"options", std::to_string(place), "motion", "77"}));
  }
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsCreate, RefusesNonFiniteAndOtherBadPoses) {
  const Scene scene;
  OutArray<abut_part_id> out(3);
  expect_pose_field_checked([&](const abut_pose& pose) {
    auto options = three_options();
    options[2].pose = pose;
    return abut_parts_create(scene.universe, options.data(), 3, out.data());
  });
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsCreate, RefusesWrongStructSize) {
  const Scene scene;
  Out<abut_part_id> out;
  expect_struct_size_checked(three_options()[0], [&](const abut_part_options* wrong) {
    return abut_parts_create(scene.universe, wrong, 1, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

// An array of structs steps by what the caller's header calls their size.
TEST(PartsCreate, StepsByTheStructSizeOfTheCaller) {
  const Universe universe;
  std::array<Grown<abut_part_options>, 3> later{};
  for (std::size_t i = 0; i < later.size(); ++i) {
    abut_part_options_init(&later.at(i).known, sizeof(abut_part_options));
    later.at(i).known.struct_size = sizeof(later[0]);
    later.at(i).known.user_data = 100 + i;
  }
  std::array<abut_part_id, 3> parts{};
  ASSERT_TRUE(succeeded(abut_parts_create(universe, &later[0].known, 3, parts.data())));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::uint64_t user_data = 0;
    ASSERT_TRUE(succeeded(abut_part_user_data(universe, parts.at(i), &user_data)));
    EXPECT_EQ(user_data, 100 + i);
  }
}

TEST(PartsCreate, RefusesArraysOfDifferentStructSizes) {
  const Scene scene;
  OutArray<abut_part_id> out(3);
  auto options = three_options();
  options[1].struct_size = 0;
  EXPECT_TRUE(refused(abut_parts_create(scene.universe, options.data(), 3, out.data()), ABUT_WRONG_STRUCT_SIZE,
                      {"struct_size", "1", "0"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsCreate, AcceptsNone) {
  const Universe universe;
  EXPECT_TRUE(succeeded(abut_parts_create(universe, nullptr, 0, nullptr)));
}

TEST(PartsDestroy, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_parts_destroy(nullptr, &scene.part, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_parts_destroy(scene.universe, nullptr, 1), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsDestroy, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_part_id), "count",
                          [&](std::size_t count) { return abut_parts_destroy(scene.universe, &scene.part, count); });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsDestroy, RefusesStaleIdsAndDestroysNone) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 3> parts{scene.part, scene.second_part, stale};
    EXPECT_TRUE(refused(abut_parts_destroy(scene.universe, parts.data(), 3), ABUT_STALE_ID,
                        {"parts", "2", std::to_string(stale.slot)}));
  }
  const std::array<abut_part_id, 3> twice{scene.part, scene.second_part, scene.part};
  EXPECT_TRUE(refused(abut_parts_destroy(scene.universe, twice.data(), 3), ABUT_STALE_ID, {"parts", "2"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsSetPoses, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(
      refused(abut_parts_set_poses(nullptr, &scene.part, &identity, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_set_poses(scene.universe, nullptr, &identity, 1), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_set_poses(scene.universe, &scene.part, nullptr, 1), ABUT_NULL_ARGUMENT, {"poses", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsSetPoses, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_pose), "count", [&](std::size_t count) {
    return abut_parts_set_poses(scene.universe, &scene.part, &identity, count);
  });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsSetPoses, RefusesStaleIdsAndMovesNone) {
  const Scene scene;
  const std::array<abut_pose, 2> poses{at(1, 1, 1), at(2, 2, 2)};
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_set_poses(scene.universe, parts.data(), poses.data(), 2), ABUT_STALE_ID,
                        {"parts", "1", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsSetPoses, RefusesNonFiniteAndOtherBadPosesAndMovesNone) {
  const Scene scene;
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  for (const BadPose& bad : bad_poses()) {
    const std::array<abut_pose, 2> poses{at(1, 1, 1), bad.pose};
    EXPECT_TRUE(refused(abut_parts_set_poses(scene.universe, parts.data(), poses.data(), 2), bad.status,
                        {"poses", "1", bad.word}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsPoses, RefusesNullPointers) {
  const Scene scene;
  Out<abut_pose> out;
  EXPECT_TRUE(
      refused(abut_parts_poses(nullptr, &scene.part, 1, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_poses(scene.universe, nullptr, 1, out.address()), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(refused(abut_parts_poses(scene.universe, &scene.part, 1, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartsPoses, RefusesOverflowingCounts) {
  const Scene scene;
  Out<abut_pose> out;
  expect_overflow_refused(sizeof(abut_pose), "count", [&](std::size_t count) {
    return abut_parts_poses(scene.universe, &scene.part, count, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartsPoses, RefusesStaleIdsAndWritesNothing) {
  const Scene scene;
  OutArray<abut_pose> out(2);
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_poses(scene.universe, parts.data(), 2, out.data()), ABUT_STALE_ID,
                        {"parts", "1", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
