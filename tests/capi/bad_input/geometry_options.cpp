// SPDX-License-Identifier: Apache-2.0
// Options of geometries that exist under bad input.
#include "geometry_values.hpp"

namespace {

using namespace abut_test;

TEST(GeometrySetOptions, RefusesNullPointers) {
  const Scene scene;
  const abut_geometry_options options = default_geometry_options();
  EXPECT_TRUE(
      refused(abut_geometry_set_options(nullptr, scene.geometry, &options), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometry_set_options(scene.universe, scene.geometry, nullptr), ABUT_NULL_ARGUMENT,
                      {"options", "null"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometrySetOptions, RefusesStaleIds) {
  const Scene scene;
  abut_geometry_options options = default_geometry_options();
  options.material = 7;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    EXPECT_TRUE(refused(abut_geometry_set_options(scene.universe, stale, &options), ABUT_STALE_ID,
                        {"geometry", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometrySetOptions, RefusesNonFiniteAndOtherBadNumbers) {
  const Scene scene;
  abut_geometry_options options = default_geometry_options();
  expect_pose_field_checked([&](const abut_pose& pose) {
    options.pose = pose;
    return abut_geometry_set_options(scene.universe, scene.geometry, &options);
  });
  options = default_geometry_options();
  expect_non_finite_refused("tolerance", [&](double bad) {
    options.tolerance = bad;
    return abut_geometry_set_options(scene.universe, scene.geometry, &options);
  });
  options.tolerance = -2.5;
  EXPECT_TRUE(refused(abut_geometry_set_options(scene.universe, scene.geometry, &options), ABUT_OUT_OF_RANGE,
                      {"tolerance", "-2.5"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometrySetOptions, RefusesUnknownValues) {
  const Scene scene;
  expect_unknown_geometry_values_refused([&](const abut_geometry_options& options) {
    return abut_geometry_set_options(scene.universe, scene.geometry, &options);
  });
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometrySetOptions, RefusesWrongStructSize) {
  const Scene scene;
  expect_struct_size_checked(default_geometry_options(), [&](const abut_geometry_options* wrong) {
    return abut_geometry_set_options(scene.universe, scene.geometry, wrong);
  });
  EXPECT_TRUE(scene.is_unchanged());
  expect_zero_tail_accepted(default_geometry_options(), [&](const abut_geometry_options* later) {
    return abut_geometry_set_options(scene.universe, scene.geometry, later);
  });
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

TEST(GeometriesSetOptions, RefusesNonFiniteAndOtherBadNumbersAndSetsNone) {
  const Scene scene;
  Batch batch = make_batch(scene);
  for (const BadPose& bad : bad_poses()) {
    batch.values[1].pose = bad.pose;
    EXPECT_TRUE(refused(batch.set(), bad.status, {"options", "1", "pose", bad.word}));
  }
  batch.values[1].pose = identity;
  expect_non_finite_refused("options[1].tolerance", [&](double bad) {
    batch.values[1].tolerance = bad;
    return batch.set();
  });
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

TEST(GeometriesSetOptions, RefusesWrongStructSize) {
  const Scene scene;
  Batch batch = make_batch(scene);
  expect_struct_size_checked(batch.values[0], [&](const abut_geometry_options* wrong) {
    return abut_geometries_set_options(scene.universe, batch.geometries.data(), wrong, 1);
  });
  batch.values[1].struct_size = 0;
  EXPECT_TRUE(refused(batch.set(), ABUT_WRONG_STRUCT_SIZE, {"struct_size", "0"}));
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
