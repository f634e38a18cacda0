// SPDX-License-Identifier: Apache-2.0
// Detections and what they found under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(UniverseDetectRegion, RefusesNonFiniteSidesThatAreNotInfinite) {
  const Scene scene;
  for (const auto side : {&abut_vec3::x, &abut_vec3::y, &abut_vec3::z}) {
    for (const auto end : {&abut_aabb::minimum, &abut_aabb::maximum}) {
      abut_aabb region{{0, 0, 0}, {1, 1, 1}};
      region.*end.*side = not_a_number;
      EXPECT_TRUE(refused(abut_universe_detect_region(scene.universe, &region), ABUT_NOT_FINITE, {"region", "nan"}));
    }
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseDetectRegion, RefusesAMinimumAboveTheMaximum) {
  const Scene scene;
  for (const auto side : {&abut_vec3::x, &abut_vec3::y, &abut_vec3::z}) {
    abut_aabb region{{0, 0, 0}, {1, 1, 1}};
    region.minimum.*side = 1.5;
    EXPECT_TRUE(
        refused(abut_universe_detect_region(scene.universe, &region), ABUT_INVALID_ARGUMENT, {"region", "1.5"}));
    region.minimum.*side = infinity;
    EXPECT_TRUE(
        refused(abut_universe_detect_region(scene.universe, &region), ABUT_INVALID_ARGUMENT, {"region", "inf"}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseDetectRegion, AcceptsInfiniteAndFlatRegions) {
  const Scene scene;
  const abut_aabb everything{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  EXPECT_TRUE(succeeded(abut_universe_detect_region(scene.universe, &everything)));
  const abut_aabb point{{1, 2, 3}, {1, 2, 3}};
  EXPECT_TRUE(succeeded(abut_universe_detect_region(scene.universe, &point)));
}

}  // namespace
