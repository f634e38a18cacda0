// SPDX-License-Identifier: Apache-2.0
// Parking under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<std::uint32_t, 3> unknown_parkings{3, 77, 0xFFFFFFFF};

TEST(GeometryPark, RefusesNullUniverse) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_geometry_park(nullptr, scene.geometry, ABUT_PARKING_LONG_TERM), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
}

TEST(GeometryPark, RefusesStaleIds) {
  const Scene scene;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    EXPECT_TRUE(refused(abut_geometry_park(scene.universe, stale, ABUT_PARKING_LONG_TERM), ABUT_STALE_ID,
                        {"geometry", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometryPark, RefusesUnknownValues) {
  const Scene scene;
  for (const std::uint32_t parking : unknown_parkings) {
    EXPECT_TRUE(refused(abut_geometry_park(scene.universe, scene.geometry, parking), ABUT_UNKNOWN_VALUE,
                        {"parking", std::to_string(parking)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesPark, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_geometries_park(nullptr, &scene.geometry, 1, ABUT_PARKING_LONG_TERM), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometries_park(scene.universe, nullptr, 1, ABUT_PARKING_LONG_TERM), ABUT_NULL_ARGUMENT,
                      {"geometries", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesPark, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_geometry_id), "count", [&](std::size_t count) {
    return abut_geometries_park(scene.universe, &scene.geometry, count, ABUT_PARKING_LONG_TERM);
  });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesPark, RefusesStaleIdsAndParksNone) {
  const Scene scene;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    const std::array<abut_geometry_id, 3> geometries{scene.geometry, scene.second_geometry, stale};
    EXPECT_TRUE(refused(abut_geometries_park(scene.universe, geometries.data(), 3, ABUT_PARKING_SHORT_TERM),
                        ABUT_STALE_ID, {"geometries", "2", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesPark, RefusesUnknownValuesAndParksNone) {
  const Scene scene;
  for (const std::uint32_t parking : unknown_parkings) {
    EXPECT_TRUE(refused(abut_geometries_park(scene.universe, &scene.geometry, 1, parking), ABUT_UNKNOWN_VALUE,
                        {"parking", std::to_string(parking)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesPark, TakesNoneAndTheSameTwice) {
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_geometries_park(scene.universe, nullptr, 0, ABUT_PARKING_SHORT_TERM)));
  EXPECT_TRUE(scene.is_unchanged());
  const std::array<abut_geometry_id, 2> twice{scene.geometry, scene.geometry};
  EXPECT_TRUE(succeeded(abut_geometries_park(scene.universe, twice.data(), 2, ABUT_PARKING_SHORT_TERM)));
  EXPECT_EQ(scene.universe.describe(scene.geometry).parking, abut_parking{ABUT_PARKING_SHORT_TERM});
}

}  // namespace
