// SPDX-License-Identifier: Apache-2.0
// Accelerations of parts, fast geometries and their impacts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Lets both geometries of the scene move at this speed, of which one is fast.
void make_fast(Scene& scene, const abut_velocity& velocity) {
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_FAST;
  require(abut_geometry_set_options(scene.universe, scene.geometry, &options));
  require(abut_part_set_velocity(scene.universe, scene.second_part, &velocity));
  require(abut_universe_step(scene.universe, 0));
}

TEST(UniverseStep, RefusesMotionsThatNoWayHas) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "this build is without the feature motion";
  Scene scene;
  make_fast(scene, {{1e70, 0, 0}, {0, 0, 60}});
  const auto before = snapshot(scene.universe);
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, 2), ABUT_OUT_OF_RANGE,
                      {"dt is 2", "slot " + std::to_string(scene.second_part.slot), "velocity[0]", "2e+70"}));
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, 1e300), ABUT_NOT_FINITE, {"dt is 1e+300", "velocity[0]"}));
  const abut_velocity spinning{{0, 0, 0}, {0, 0, 60}};
  require(abut_part_set_velocity(scene.universe, scene.second_part, &spinning));
  EXPECT_TRUE(
      refused(abut_universe_step(scene.universe, 2), ABUT_OUT_OF_RANGE, {"dt is 2", "revolutions", "19.09", "16"}));
  EXPECT_EQ(snapshot(scene.universe), before);
  EXPECT_TRUE(succeeded(abut_universe_step(scene.universe, 1)));
  const abut_geometry_options slow = default_geometry_options();
  require(abut_geometry_set_options(scene.universe, scene.geometry, &slow));
  EXPECT_TRUE(succeeded(abut_universe_step(scene.universe, 2))) << "nobody looks at ways";
}

TEST(GeometrySetOptions, RefusesFlagsOfTwoWaysToLookAtMotion) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "this build is without the feature motion";
  const Scene scene;
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_FAST | ABUT_GEOMETRY_SPECULATIVE;
  EXPECT_TRUE(refused(abut_geometry_set_options(scene.universe, scene.geometry, &options), ABUT_INVALID_ARGUMENT,
                      {"options.flags", "12", "not both"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseStep, RefusesToBeFastWithoutTheFeature) {
  if (abut_has_feature("motion") != 0) GTEST_SKIP() << "this build has the feature motion";
  const Scene scene;
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_FAST;
  EXPECT_TRUE(
      refused(abut_geometry_set_options(scene.universe, scene.geometry, &options), ABUT_UNSUPPORTED, {"motion"}));
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
