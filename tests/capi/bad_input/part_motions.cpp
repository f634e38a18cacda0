// SPDX-License-Identifier: Apache-2.0
// Motions of parts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<std::uint32_t, 3> unknown_motions{3, 77, 0xFFFFFFFF};

TEST(PartSetMotion, RefusesUnknownMotions) {
  const Scene scene;
  for (const std::uint32_t motion : unknown_motions) {
    EXPECT_TRUE(refused(abut_part_set_motion(scene.universe, scene.part, motion), ABUT_UNKNOWN_VALUE,
                        {"motion", std::to_string(motion)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsSetMotions, RefusesUnknownMotionsAndSetsNone) {
  const Scene scene;
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  for (const std::uint32_t motion : unknown_motions) {
    const std::array<abut_motion, 2> motions{ABUT_MOTION_STATIC, motion};
    EXPECT_TRUE(refused(abut_parts_set_motions(scene.universe, parts.data(), motions.data(), 2), ABUT_UNKNOWN_VALUE,
                        {"motions", "1", std::to_string(motion)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(PartsSetMotions, TakesNoneAndTheLastOfTwo) {
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_parts_set_motions(scene.universe, nullptr, nullptr, 0)));
  EXPECT_TRUE(scene.is_unchanged());
  const std::array<abut_part_id, 2> parts{scene.part, scene.part};
  const std::array<abut_motion, 2> motions{ABUT_MOTION_STATIC, ABUT_MOTION_ANIMATED};
  EXPECT_TRUE(succeeded(abut_parts_set_motions(scene.universe, parts.data(), motions.data(), 2)));
  abut_motion motion = 0;
  EXPECT_TRUE(succeeded(abut_part_motion(scene.universe, scene.part, &motion)));
  EXPECT_EQ(motion, abut_motion{ABUT_MOTION_ANIMATED});
}

}  // namespace
