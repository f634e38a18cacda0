// Other shapes for geometries under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(GeometrySetShape, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_geometry_set_shape(nullptr, scene.geometry, scene.block), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometry_set_shape(scene.universe, scene.geometry, nullptr), ABUT_NULL_ARGUMENT, {"shape", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometrySetShape, RefusesStaleIds) {
  const Scene scene;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    EXPECT_TRUE(refused(abut_geometry_set_shape(scene.universe, stale, scene.block), ABUT_STALE_ID,
                        {"geometry", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

// Other shapes for both geometries of a scene, ready to be spoiled.
struct Batch {
  explicit Batch(const Scene& scene)
      : universe(scene.universe), geometries{scene.geometry, scene.second_geometry}, shapes{scene.block, scene.ball} {}
  abut_status set() const { return abut_geometries_set_shapes(universe, geometries.data(), shapes.data(), 2); }

  abut_universe* universe;
  std::array<abut_geometry_id, 2> geometries;
  std::array<const abut_shape*, 2> shapes;
};

TEST(GeometriesSetShapes, AcceptsTheBatchThatTheOthersSpoil) {
  const Scene scene;
  EXPECT_TRUE(succeeded(Batch(scene).set()));
  EXPECT_EQ(scene.universe.describe(scene.geometry).shape, scene.block);
  EXPECT_EQ(scene.universe.describe(scene.second_geometry).shape, scene.ball);
  EXPECT_TRUE(succeeded(abut_geometries_set_shapes(scene.universe, nullptr, nullptr, 0)));
}

TEST(GeometriesSetShapes, TakesTheLastOfTwo) {
  const Scene scene;
  Batch batch(scene);
  batch.geometries[1] = scene.geometry;
  EXPECT_TRUE(succeeded(batch.set()));
  EXPECT_EQ(scene.universe.describe(scene.geometry).shape, scene.ball);
  EXPECT_EQ(scene.universe.describe(scene.geometry).kind, abut_shape_kind_of(scene.ball));
}

TEST(GeometriesSetShapes, RefusesNullPointersAndSetsNone) {
  const Scene scene;
  Batch batch(scene);
  EXPECT_TRUE(refused(abut_geometries_set_shapes(nullptr, batch.geometries.data(), batch.shapes.data(), 2), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometries_set_shapes(scene.universe, nullptr, batch.shapes.data(), 2), ABUT_NULL_ARGUMENT,
                      {"geometries", "null"}));
  EXPECT_TRUE(refused(abut_geometries_set_shapes(scene.universe, batch.geometries.data(), nullptr, 2), ABUT_NULL_ARGUMENT,
                      {"shapes", "null"}));
  batch.shapes[1] = nullptr;
  EXPECT_TRUE(refused(batch.set(), ABUT_NULL_ARGUMENT, {"shapes", "1", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetShapes, RefusesOverflowingCounts) {
  const Scene scene;
  const Batch batch(scene);
  for (const std::size_t count : overflowing_counts(sizeof(abut_geometry_id))) {
    EXPECT_TRUE(refused(abut_geometries_set_shapes(scene.universe, batch.geometries.data(), batch.shapes.data(), count),
                        ABUT_SIZE_OVERFLOW, {"count", std::to_string(count)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesSetShapes, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  Batch batch(scene);
  for (const abut_geometry_id stale : scene.stale_geometries) {
    batch.geometries[1] = stale;
    EXPECT_TRUE(refused(batch.set(), ABUT_STALE_ID, {"geometries", "1", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
