// SPDX-License-Identifier: Apache-2.0
// Parking under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<std::uint32_t, 3> unknown_parkings{3, 77, 0xFFFFFFFF};

TEST(GeometryPark, RefusesUnknownValues) {
  const Scene scene;
  for (const std::uint32_t parking : unknown_parkings) {
    EXPECT_TRUE(refused(abut_geometry_park(scene.universe, scene.geometry, parking), ABUT_UNKNOWN_VALUE,
                        {"parking", std::to_string(parking)}));
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
