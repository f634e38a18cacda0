// SPDX-License-Identifier: Apache-2.0
// Detections and what they found under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(UniverseDetectAll, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_universe_detect_all(nullptr), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

TEST(UniverseDetectChanged, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_universe_detect_changed(nullptr), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

TEST(UniverseRefresh, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_universe_refresh(nullptr), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

TEST(UniverseDetectPairs, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_universe_detect_pairs(nullptr, &scene.geometry, &scene.second_geometry, 1),
                      ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_detect_pairs(scene.universe, nullptr, &scene.second_geometry, 1),
                      ABUT_NULL_ARGUMENT, {"a is null"}));
  EXPECT_TRUE(refused(abut_universe_detect_pairs(scene.universe, &scene.geometry, nullptr, 1), ABUT_NULL_ARGUMENT,
                      {"b is null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseDetectPairs, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_geometry_id), "count", [&](std::size_t count) {
    return abut_universe_detect_pairs(scene.universe, &scene.geometry, &scene.second_geometry, count);
  });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseDetectPairs, RefusesStaleIdsAndDetectsNothing) {
  Scene scene;
  const std::array<abut_geometry_id, 2> good{scene.geometry, scene.second_geometry};
  for (const abut_geometry_id stale : scene.stale_geometries) {
    const std::array<abut_geometry_id, 2> bad{scene.second_geometry, stale};
    EXPECT_TRUE(refused(abut_universe_detect_pairs(scene.universe, bad.data(), good.data(), 2), ABUT_STALE_ID,
                        {"a[1]", std::to_string(stale.slot)}));
    EXPECT_TRUE(refused(abut_universe_detect_pairs(scene.universe, good.data(), bad.data(), 2), ABUT_STALE_ID,
                        {"b[1]", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
  EXPECT_TRUE(succeeded(abut_universe_detect_pairs(scene.universe, nullptr, nullptr, 0)));
}

TEST(UniverseDetectRegion, RefusesNullPointers) {
  const Scene scene;
  const abut_aabb region{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(refused(abut_universe_detect_region(nullptr, &region), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_detect_region(scene.universe, nullptr), ABUT_NULL_ARGUMENT, {"region", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

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

TEST(UniverseEvents, RefusesNullPointers) {
  const Scene scene;
  Out<const abut_event*> events;
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_events(nullptr, events.address(), count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_events(scene.universe, nullptr, count.address()), ABUT_NULL_ARGUMENT, {"events", "null"}));
  EXPECT_TRUE(
      refused(abut_universe_events(scene.universe, events.address(), nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(events.is_untouched());
  EXPECT_TRUE(count.is_untouched());
}

TEST(UniverseHash, RefusesNullPointers) {
  const Scene scene;
  Out<std::uint64_t> out;
  EXPECT_TRUE(refused(abut_universe_hash(nullptr, out.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_hash(scene.universe, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
