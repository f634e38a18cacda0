// SPDX-License-Identifier: Apache-2.0
// Values of the caller on parts and geometries, set while these exist.
#include "support.hpp"

namespace {

using namespace abut_test;

TEST(UserData, IsWhatWasSetLast) {
  const Scene scene;
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  const std::array<abut_geometry_id, 2> geometries{scene.geometry, scene.second_geometry};
  const std::array<std::uint64_t, 2> given{11, ~std::uint64_t{0}};
  ASSERT_TRUE(succeeded(abut_parts_set_user_data(scene.universe, parts.data(), given.data(), 2)));
  ASSERT_TRUE(succeeded(abut_geometries_set_user_data(scene.universe, geometries.data(), given.data(), 2)));
  ASSERT_TRUE(succeeded(abut_part_set_user_data(scene.universe, scene.part, 12)));
  ASSERT_TRUE(succeeded(abut_geometry_set_user_data(scene.universe, scene.geometry, 13)));
  std::uint64_t first = 0, second = 0;
  ASSERT_TRUE(succeeded(abut_part_user_data(scene.universe, parts[0], &first)));
  ASSERT_TRUE(succeeded(abut_part_user_data(scene.universe, parts[1], &second)));
  EXPECT_EQ(first, 12U);
  EXPECT_EQ(second, ~std::uint64_t{0});
  EXPECT_EQ(scene.universe.describe(geometries[0]).user_data, 13U);
  EXPECT_EQ(scene.universe.describe(geometries[1]).user_data, ~std::uint64_t{0});
}

// Unlike new options, which wake parts and have all pairs of the geometry asked again.
TEST(UserData, ChangesNothingElse) {
  Universe universe;
  const Shape ball = make_sphere(1);
  const abut_part_id part = universe.add_part(identity);
  const abut_geometry_id geometry = universe.add_geometry(part, ball);
  universe.add(ball, at(1.5, 0, 0), ABUT_MOTION_STATIC);
  const abut_sleep sleep = default_sleep();
  require(abut_part_set_sleep(universe, part, &sleep));
  std::uint32_t is_asleep = 0;
  for (int i = 0; i < 20; ++i) require(abut_universe_step(universe, 0.01));
  require(abut_part_is_asleep(universe, part, &is_asleep));
  ASSERT_EQ(is_asleep, 1U);
  abut_revision before{}, after{};
  require(abut_universe_revision(universe, &before));
  ASSERT_TRUE(succeeded(abut_part_set_user_data(universe, part, 5)));
  ASSERT_TRUE(succeeded(abut_geometry_set_user_data(universe, geometry, 6)));
  require(abut_universe_step(universe, 0.01));
  require(abut_universe_revision(universe, &after));
  require(abut_part_is_asleep(universe, part, &is_asleep));
  EXPECT_EQ(is_asleep, 1U);
  EXPECT_EQ(universe.stats().examined_pairs, 0U);
  EXPECT_EQ(after.geometries, before.geometries);
  EXPECT_EQ(after.poses, before.poses);
}

}  // namespace
