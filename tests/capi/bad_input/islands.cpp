// SPDX-License-Identifier: Apache-2.0
// Islands under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(UniverseFollowIslands, RefusesNullAndUnknownValues) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_universe_follow_islands(nullptr, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  for (const std::uint32_t value : {2U, 0xffffffffU}) {
    EXPECT_TRUE(refused(abut_universe_follow_islands(scene.universe, value), ABUT_UNKNOWN_VALUE,
                        {"are_followed", std::to_string(value)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseIslands, RefusesNullPointersAndUniversesWithout) {
  const Scene scene;
  Out<const abut_island*> islands;
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_islands(nullptr, islands.address(), count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_islands(scene.universe, nullptr, count.address()), ABUT_NULL_ARGUMENT,
                      {"islands", "null"}));
  EXPECT_TRUE(refused(abut_universe_islands(scene.universe, islands.address(), nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(refused(abut_universe_islands(scene.universe, islands.address(), count.address()), ABUT_UNSUPPORTED,
                      {"islands", "follow"}));
  EXPECT_TRUE(islands.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(UniverseIslandParts, RefusesNullPointersAndUniversesWithout) {
  const Scene scene;
  Out<const abut_part_id*> parts;
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_island_parts(nullptr, parts.address(), count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_island_parts(scene.universe, nullptr, count.address()), ABUT_NULL_ARGUMENT,
                      {"parts", "null"}));
  EXPECT_TRUE(refused(abut_universe_island_parts(scene.universe, parts.address(), nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(refused(abut_universe_island_parts(scene.universe, parts.address(), count.address()), ABUT_UNSUPPORTED,
                      {"islands"}));
  EXPECT_TRUE(parts.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(PartIsland, RefusesNullPointersAndUniversesWithout) {
  const Scene scene;
  Out<abut_island> out;
  EXPECT_TRUE(refused(abut_part_island(nullptr, scene.part, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_part_island(scene.universe, scene.part, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(refused(abut_part_island(scene.universe, scene.part, out.address()), ABUT_UNSUPPORTED, {"islands"}));
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
