// SPDX-License-Identifier: Apache-2.0
// Other shapes for geometries under bad input.
#include "geometry_values.hpp"

namespace {

using namespace abut_test;

using Batch = GeometryValues<const abut_shape*>;

Batch make_batch(const Scene& scene) { return {abut_geometries_set_shapes, scene, {scene.block, scene.ball}}; }

TEST(GeometriesSetShapes, AcceptsTheBatchThatTheOthersSpoil) {
  const Scene scene;
  EXPECT_TRUE(succeeded(make_batch(scene).set()));
  EXPECT_EQ(scene.universe.describe(scene.geometry).shape, scene.block);
  EXPECT_EQ(scene.universe.describe(scene.second_geometry).shape, scene.ball);
  EXPECT_TRUE(succeeded(abut_geometries_set_shapes(scene.universe, nullptr, nullptr, 0)));
}

TEST(GeometriesSetShapes, TakesTheLastOfTwo) {
  const Scene scene;
  Batch batch = make_batch(scene);
  batch.geometries[1] = scene.geometry;
  EXPECT_TRUE(succeeded(batch.set()));
  EXPECT_EQ(scene.universe.describe(scene.geometry).shape, scene.ball);
  EXPECT_EQ(scene.universe.describe(scene.geometry).kind, abut_shape_kind_of(scene.ball));
}

TEST(GeometriesSetShapes, RefusesNullPointersAndSetsNone) {
  const Scene scene;
  Batch batch = make_batch(scene);
  refuse_null_pointers(batch, "shapes");
  batch.values[1] = nullptr;
  EXPECT_TRUE(refused(batch.set(), ABUT_NULL_ARGUMENT, {"shapes", "1", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetShapes, RefusesOverflowingCounts) {
  const Scene scene;
  refuse_overflowing_counts(make_batch(scene), sizeof(abut_geometry_id));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetShapes, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  refuse_stale_geometries(make_batch(scene), scene);
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
