// SPDX-License-Identifier: Apache-2.0
// Options of geometries that exist under bad input.
#include "geometry_values.hpp"

namespace {

using namespace abut_test;

TEST(GeometrySetOptions, RefusesUnknownValues) {
  const Scene scene;
  expect_unknown_geometry_values_refused([&](const abut_geometry_options& options) {
    return abut_geometry_set_options(scene.universe, scene.geometry, &options);
  });
  EXPECT_TRUE(scene.is_unchanged());
}

using Batch = GeometryValues<abut_geometry_options>;

Batch make_batch(const Scene& scene) {
  abut_geometry_options options = default_geometry_options();
  options.material = 7;
  return {abut_geometries_set_options, scene, {options, options}};
}

TEST(GeometriesSetOptions, AcceptsTheBatchThatTheOthersSpoil) {
  const Scene scene;
  EXPECT_TRUE(succeeded(make_batch(scene).set()));
  EXPECT_EQ(scene.universe.describe(scene.second_geometry).material, 7U);
  EXPECT_TRUE(succeeded(abut_geometries_set_options(scene.universe, nullptr, nullptr, 0)));
}

TEST(GeometriesSetOptions, TakesTheLastOfTwo) {
  const Scene scene;
  Batch batch = make_batch(scene);
  batch.geometries[1] = scene.geometry;
  batch.values[1].material = 8;
  EXPECT_TRUE(succeeded(batch.set()));
  EXPECT_EQ(scene.universe.describe(scene.geometry).material, 8U);
}

TEST(GeometriesSetOptions, RefusesNullPointers) {
  const Scene scene;
  refuse_null_pointers(make_batch(scene), "options");
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetOptions, RefusesOverflowingCounts) {
  const Scene scene;
  refuse_overflowing_counts(make_batch(scene), sizeof(abut_geometry_options));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetOptions, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  refuse_stale_geometries(make_batch(scene), scene);
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetOptions, RefusesUnknownValuesAndSetsNone) {
  const Scene scene;
  Batch batch = make_batch(scene);
  expect_unknown_geometry_values_refused([&](const abut_geometry_options& options) {
    batch.values[1] = options;
    return batch.set();
  });
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
