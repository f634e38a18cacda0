// SPDX-License-Identifier: Apache-2.0
// Batches of geometries under bad input: one bad element spoils all, whichever it is.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// A batch of three geometries for a scene, ready to be spoiled.
struct Batch {
  explicit Batch(const Scene& scene)
      : universe(scene.universe),
        parts{scene.part, scene.second_part, scene.part},
        shapes{scene.ball, scene.block, scene.ball} {
    for (abut_geometry_options& each : options) abut_geometry_options_init(&each, sizeof each);
  }
  abut_status create() {
    return abut_geometries_create(universe, parts.data(), shapes.data(), options.data(), 3, out.data());
  }

  abut_universe* universe;
  std::array<abut_part_id, 3> parts;
  std::array<const abut_shape*, 3> shapes;
  std::array<abut_geometry_options, 3> options{};
  OutArray<abut_geometry_id> out{3};
};

TEST(GeometriesCreate, AcceptsTheBatchThatTheOthersSpoil) {
  const Scene scene;
  Batch batch(scene);
  EXPECT_TRUE(succeeded(batch.create()));
  EXPECT_TRUE(succeeded(
      abut_geometries_create(scene.universe, batch.parts.data(), batch.shapes.data(), nullptr, 3, batch.out.data())));
  EXPECT_TRUE(succeeded(abut_geometries_create(scene.universe, nullptr, nullptr, nullptr, 0, nullptr)));
}

TEST(GeometriesCreate, RefusesNullPointers) {
  const Scene scene;
  Batch batch(scene);
  abut_geometry_id* const out = batch.out.data();
  EXPECT_TRUE(refused(abut_geometries_create(nullptr, batch.parts.data(), batch.shapes.data(), nullptr, 3, out),
                      ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometries_create(scene.universe, nullptr, batch.shapes.data(), nullptr, 3, out),
                      ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(refused(abut_geometries_create(scene.universe, batch.parts.data(), nullptr, nullptr, 3, out),
                      ABUT_NULL_ARGUMENT, {"shapes", "null"}));
  EXPECT_TRUE(
      refused(abut_geometries_create(scene.universe, batch.parts.data(), batch.shapes.data(), nullptr, 3, nullptr),
              ABUT_NULL_ARGUMENT, {"out", "null"}));
  batch.shapes[2] = nullptr;
  EXPECT_TRUE(refused(batch.create(), ABUT_NULL_ARGUMENT, {"shapes", "2", "null"}));
  EXPECT_TRUE(batch.out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesCreate, RefusesStaleIdsAndCreatesNone) {
  const Scene scene;
  Batch batch(scene);
  for (const abut_part_id stale : scene.stale_parts) {
    batch.parts[2] = stale;
    EXPECT_TRUE(refused(batch.create(), ABUT_STALE_ID, {"parts", "2", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(batch.out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesCreate, RefusesNonFiniteAndOtherBadPosesAndCreatesNone) {
  const Scene scene;
  Batch batch(scene);
  for (const BadPose& bad : bad_poses()) {
    batch.options[2].pose = bad.pose;
    EXPECT_TRUE(refused(batch.create(), bad.status, {"options", "2", "pose", bad.word}));
  }
  EXPECT_TRUE(batch.out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesCreate, RefusesBadTolerance) {
  const Scene scene;
  Batch batch(scene);
  expect_non_finite_refused("tolerance", [&](double bad) {
    batch.options[1].tolerance = bad;
    return batch.create();
  });
  batch.options[1].tolerance = -2.5;
  EXPECT_TRUE(refused(batch.create(), ABUT_OUT_OF_RANGE, {"options", "1", "tolerance", "-2.5"}));
  EXPECT_TRUE(batch.out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesCreate, RefusesUnknownValues) {
  const Scene scene;
  Batch batch(scene);
  expect_unknown_geometry_values_refused([&](const abut_geometry_options& options) {
    batch.options[1] = options;
    return batch.create();
  });
  EXPECT_TRUE(batch.out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometriesCreate, RefusesWrongStructSize) {
  const Scene scene;
  Batch batch(scene);
  expect_struct_size_checked(batch.options[0], [&](const abut_geometry_options* wrong) {
    return abut_geometries_create(scene.universe, batch.parts.data(), batch.shapes.data(), wrong, 1, batch.out.data());
  });
  batch.options[1].struct_size = 0;
  EXPECT_TRUE(refused(batch.create(), ABUT_WRONG_STRUCT_SIZE, {"struct_size", "0"}));
  EXPECT_TRUE(batch.out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

// An array of structs steps by what the caller's header calls their size.
TEST(GeometriesCreate, StepsByTheStructSizeOfTheCaller) {
  const Scene scene;
  Batch batch(scene);
  std::array<Grown<abut_geometry_options>, 3> later{};
  for (std::size_t i = 0; i < later.size(); ++i) {
    later.at(i).known = batch.options.at(i);
    later.at(i).known.struct_size = sizeof(later[0]);
    later.at(i).known.user_data = 100 + i;
  }
  ASSERT_TRUE(succeeded(abut_geometries_create(scene.universe, batch.parts.data(), batch.shapes.data(), &later[0].known,
                                               3, batch.out.data())));
  for (std::size_t i = 0; i < later.size(); ++i) {
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    ASSERT_TRUE(succeeded(abut_geometry_describe(scene.universe, batch.out[i], &info)));
    EXPECT_EQ(info.user_data, 100 + i);
  }
}

}  // namespace
