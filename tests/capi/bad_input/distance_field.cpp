// SPDX-License-Identifier: Apache-2.0
// Distance fields under bad input, as they are made and as they change.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 12> twelve_values{1, 1, 1, 1, -1, 1, 1, 1, 1, 1, 1, 1};

abut_distance_field_desc good_desc() {
  abut_distance_field_desc desc;
  abut_distance_field_desc_init(&desc, sizeof desc);
  desc.columns = 3;
  desc.rows = 2;
  desc.layers = 2;
  desc.values = twelve_values.data();
  return desc;
}

TEST(DistanceFieldDescInit, IgnoresNull) { abut_distance_field_desc_init(nullptr, 0); }

TEST(DistanceFieldDescInit, FillsInSizeAndDefaults) {
  Out<abut_distance_field_desc> desc;
  abut_distance_field_desc_init(desc.address(), sizeof(abut_distance_field_desc));
  EXPECT_EQ(desc.value().struct_size, sizeof(abut_distance_field_desc));
  EXPECT_EQ(desc.value().is_inside_out, 0U);
  EXPECT_EQ(desc.value().interpolation, static_cast<std::uint32_t>(ABUT_INTERPOLATION_LINEAR));
  EXPECT_EQ(desc.value().spacing.y, 1);
  EXPECT_EQ(desc.value().origin.z, 0);
  EXPECT_EQ(desc.value().values, nullptr);
}

TEST(DistanceFieldCreate, AcceptsTheDescriptionThatTheOthersSpoil) {
  const abut_distance_field_desc desc = good_desc();
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(abut_distance_field_create(&desc, &shape)));
  abut_shape_release(shape);
}

TEST(DistanceFieldCreate, RefusesCountsThatMakeNoCell) {
  Out<abut_shape*> out;
  abut_distance_field_desc desc = good_desc();
  desc.layers = 0;
  EXPECT_TRUE(refused(abut_distance_field_create(&desc, out.address()), ABUT_EMPTY, {"layers", "0"}));
  desc = good_desc();
  desc.columns = desc.rows = desc.layers = 1;
  EXPECT_TRUE(refused(abut_distance_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"columns", "1"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(DistanceFieldCreate, RefusesSpacingThatIsNotPositive) {
  Out<abut_shape*> out;
  abut_distance_field_desc desc = good_desc();
  desc.spacing.z = 0;
  EXPECT_TRUE(refused(abut_distance_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"spacing_z", "0"}));
  desc.spacing.z = -2.5;
  EXPECT_TRUE(refused(abut_distance_field_create(&desc, out.address()), ABUT_OUT_OF_RANGE, {"spacing_z", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(DistanceFieldCreate, RefusesFlagsThatAreNone) {
  Out<abut_shape*> out;
  abut_distance_field_desc desc = good_desc();
  desc.is_inside_out = 2;
  EXPECT_TRUE(refused(abut_distance_field_create(&desc, out.address()), ABUT_UNKNOWN_VALUE, {"is_inside_out", "2"}));
  desc = good_desc();
  desc.interpolation = 31;
  EXPECT_TRUE(refused(abut_distance_field_create(&desc, out.address()), ABUT_UNKNOWN_VALUE, {"interpolation", "31"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(DistanceFieldOptionsInit, FillsInSizeAndDefaults) {
  abut_distance_field_options_init(nullptr, 0);
  Out<abut_distance_field_options> options;
  abut_distance_field_options_init(options.address(), sizeof(abut_distance_field_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_distance_field_options));
  EXPECT_EQ(options.value().is_inside_out, 0U);
  EXPECT_EQ(options.value().spacing, 0);
  EXPECT_EQ(options.value().band, 3);
  EXPECT_EQ(options.value().interpolation, static_cast<std::uint32_t>(ABUT_INTERPOLATION_LINEAR));
}

constexpr std::array<double, 12> four_corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
constexpr std::array<std::uint32_t, 12> four_triangles{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
abut_distance_field_options good_options() {
  abut_distance_field_options options;
  abut_distance_field_options_init(&options, sizeof options);
  options.spacing = 0.1;
  return options;
}
abut_status from_mesh(const abut_distance_field_options* options, abut_shape** out) {
  return abut_distance_field_from_mesh(four_corners.data(), 4, four_triangles.data(), 4, options, out);
}

TEST(DistanceFieldFromMesh, AcceptsWhatTheOthersSpoil) {
  const abut_distance_field_options options = good_options();
  abut_shape* shape = nullptr;
  EXPECT_TRUE(succeeded(from_mesh(&options, &shape)));
  abut_shape_release(shape);
  EXPECT_TRUE(succeeded(from_mesh(nullptr, &shape)));
  abut_shape_release(shape);
}

TEST(DistanceFieldFromMesh, RefusesFlagsThatAreNone) {
  Out<abut_shape*> out;
  abut_distance_field_options options = good_options();
  options.interpolation = 2;
  EXPECT_TRUE(refused(from_mesh(&options, out.address()), ABUT_UNKNOWN_VALUE, {"options.interpolation", "2"}));
  options = good_options();
  options.reserved = 7;
  EXPECT_TRUE(refused(from_mesh(&options, out.address()), ABUT_INVALID_ARGUMENT, {"options.reserved", "7"}));
  EXPECT_TRUE(out.is_untouched());
}

// A field of 3 x 2 x 2 samples beside the geometries of a scene.
struct Edited : Scene {
  Edited() {
    const std::vector<double> parameters{3, 2, 2, 1, 1, 1, 0, 0, 0, 0};
    field = universe.add(make_of_kind("distance_field", parameters, {twelve_values.begin(), twelve_values.end()}),
                         at(20, 0, 0), ABUT_MOTION_STATIC);
    universe.step();
    before = snapshot(universe);
  }
  bool is_as_before() const { return snapshot(universe) == before; }

  abut_geometry_id field{};
  std::vector<unsigned char> before;
};

TEST(GeometrySetFieldValues, RefusesNullPointers) {
  const Edited scene;
  EXPECT_TRUE(refused(abut_geometry_set_field_values(nullptr, scene.field, 0, 0, 0, 1, 1, 1, twelve_values.data()),
                      ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_geometry_set_field_values(scene.universe, scene.field, 0, 0, 0, 1, 1, 1, nullptr),
                      ABUT_NULL_ARGUMENT, {"values", "null"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetFieldValues, RefusesSamplesBeyondTheField) {
  const Edited scene;
  const auto set = [&](std::uint32_t layer, std::uint32_t columns, std::uint32_t rows, std::uint32_t layers) {
    return abut_geometry_set_field_values(scene.universe, scene.field, 0, 0, layer, columns, rows, layers,
                                          twelve_values.data());
  };
  EXPECT_TRUE(refused(set(3, 0, 0, 0), ABUT_INDEX_OUT_OF_RANGE, {"layer is 3", "2"}));
  EXPECT_TRUE(refused(set(1, 1, 1, 2), ABUT_INDEX_OUT_OF_RANGE, {"layers is 2", "1"}));
  EXPECT_TRUE(refused(set(0, 4, 1, 1), ABUT_INDEX_OUT_OF_RANGE, {"columns is 4", "3"}));
  EXPECT_TRUE(refused(set(0, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF), ABUT_SIZE_OVERFLOW,
                      {"columns * rows * layers", "4294967295"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetFieldValues, RefusesOtherKinds) {
  const Edited scene;
  EXPECT_TRUE(refused(
      abut_geometry_set_field_values(scene.universe, scene.second_geometry, 0, 0, 0, 1, 1, 1, twelve_values.data()),
      ABUT_UNSUPPORTED, {"geometry", "box", "values"}));
  EXPECT_TRUE(scene.is_as_before());
}

// The corners of the grid, at rest.
constexpr std::array<double, 24> eight_points{0, 0, 0, 2, 0, 0, 0, 1, 0, 2, 1, 0, 0, 0, 1, 2, 0, 1, 0, 1, 1, 2, 1, 1};

TEST(GeometrySetFieldLattice, AcceptsWhatTheOthersSpoil) {
  Edited scene;
  std::array<double, 24> points = eight_points;
  points[23] = 1.25;
  EXPECT_TRUE(succeeded(abut_geometry_set_field_lattice(scene.universe, scene.field, 2, 2, 2, points.data())));
  scene.universe.step();
  EXPECT_TRUE(succeeded(abut_geometry_set_field_lattice(scene.universe, scene.field, 0, 0, 0, nullptr)));
}

TEST(GeometrySetFieldLattice, RefusesCountsAndPointsThatMakeNoSpace) {
  const Edited scene;
  const auto set = [&](std::uint32_t columns, std::uint32_t rows, std::uint32_t layers,
                       const std::array<double, 24>& points) {
    return abut_geometry_set_field_lattice(scene.universe, scene.field, columns, rows, layers, points.data());
  };
  EXPECT_TRUE(refused(set(2, 1, 2, eight_points), ABUT_OUT_OF_RANGE, {"rows is 1", "2 to 64"}));
  EXPECT_TRUE(refused(set(0, 2, 2, eight_points), ABUT_OUT_OF_RANGE, {"columns is 0", "2 to 64"}));
  EXPECT_TRUE(refused(set(0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, eight_points), ABUT_SIZE_OVERFLOW,
                      {"columns * rows * layers", "4294967295"}));
  std::array<double, 24> folded = eight_points;
  folded[3] = folded[9] = folded[15] = folded[21] = -2;
  EXPECT_TRUE(refused(set(2, 2, 2, folded), ABUT_OUT_OF_RANGE, {"xyz bends space too much"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(GeometrySetFieldLattice, RefusesOtherKinds) {
  const Edited scene;
  EXPECT_TRUE(
      refused(abut_geometry_set_field_lattice(scene.universe, scene.second_geometry, 2, 2, 2, eight_points.data()),
              ABUT_UNSUPPORTED, {"geometry", "box", "lattice"}));
  EXPECT_TRUE(scene.is_as_before());
}

TEST(DistanceFieldReportInit, FillsInSizeAndZeroes) {
  abut_distance_field_report_init(nullptr, 0);
  Out<abut_distance_field_report> report;
  abut_distance_field_report_init(report.address(), sizeof(abut_distance_field_report));
  EXPECT_EQ(report.value().struct_size, sizeof(abut_distance_field_report));
  EXPECT_EQ(report.value().held_block_count, 0U);
  EXPECT_EQ(report.value().error, 0);
}

abut_distance_field_report empty_field_report() {
  abut_distance_field_report report;
  abut_distance_field_report_init(&report, sizeof report);
  return report;
}
Shape small_field() {
  const std::vector<double> parameters{3, 2, 2, 1, 1, 1, 0, 0, 0, 0, 1};
  return make_of_kind("distance_field", parameters, {twelve_values.begin(), twelve_values.end()});
}

TEST(DistanceFieldDescribe, TellsWhatIsKnown) {
  const Shape field = small_field();
  abut_distance_field_report report = empty_field_report();
  ASSERT_TRUE(succeeded(abut_distance_field_describe(field, &report)));
  EXPECT_EQ(report.interpolation, static_cast<std::uint32_t>(ABUT_INTERPOLATION_QUADRATIC));
  EXPECT_EQ(report.block_count, 1U);
  EXPECT_EQ(report.held_block_count, 1U);
  EXPECT_NEAR(report.error, 0.8660254, 1e-6);
  EXPECT_EQ(report.far_error, 0);
  EXPECT_EQ(report.least_stretch, 1);
  EXPECT_EQ(report.most_stretch, 1);
}

TEST(DistanceFieldDescribe, RefusesOtherKindsByName) {
  for (const Shape& shape : make_one_of_each_kind()) {
    const std::string kind = abut_shape_kind_name(abut_shape_kind_of(shape));
    if (kind == "distance_field") continue;
    Out<abut_distance_field_report> out(empty_field_report());
    EXPECT_TRUE(refused(abut_distance_field_describe(shape, out.address()), ABUT_UNSUPPORTED, {kind}));
    EXPECT_TRUE(out.is_untouched());
  }
}

}  // namespace
