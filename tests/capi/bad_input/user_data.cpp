// SPDX-License-Identifier: Apache-2.0
// Values of the caller on parts and geometries, under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<std::uint64_t, 2> values{7, 8};

TEST(PartsSetUserData, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_set_user_data(scene.universe, parts.data(), values.data(), 2), ABUT_STALE_ID,
                        {"parts", "1", std::to_string(stale.slot)}));
  }
  std::uint64_t found = 1;
  ASSERT_TRUE(succeeded(abut_part_user_data(scene.universe, scene.part, &found)));
  EXPECT_EQ(found, 0U);
}

TEST(GeometriesSetUserData, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    const std::array<abut_geometry_id, 2> geometries{scene.geometry, stale};
    EXPECT_TRUE(refused(abut_geometries_set_user_data(scene.universe, geometries.data(), values.data(), 2),
                        ABUT_STALE_ID, {"geometries", "1", std::to_string(stale.slot)}));
  }
  EXPECT_EQ(scene.universe.describe(scene.geometry).user_data, 0U);
}

}  // namespace
