// SPDX-License-Identifier: Apache-2.0
// Grids of cells under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr std::array<double, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
constexpr std::array<std::uint32_t, 3> triangle{0, 1, 2};

abut_uv_grid_options good_options() {
  abut_uv_grid_options options;
  abut_uv_grid_options_init(&options, sizeof options);
  return options;
}

abut_status create(const abut_uv_grid_options* options, abut_shape** out) {
  return abut_uv_grid_create(corners.data(), 3, triangle.data(), 1, options, out);
}

TEST(UvGridOptionsInit, IgnoresNull) { abut_uv_grid_options_init(nullptr, 0); }

TEST(UvGridOptionsInit, FillsInTheDefaults) {
  const abut_uv_grid_options options = good_options();
  EXPECT_EQ(options.struct_size, sizeof(abut_uv_grid_options));
  EXPECT_EQ(options.sides, ABUT_SIDES_BOTH);
  EXPECT_EQ(options.axis_u, ABUT_AXIS_X);
  EXPECT_EQ(options.axis_v, ABUT_AXIS_Y);
  EXPECT_EQ(options.cells_u, 0U);
  EXPECT_EQ(options.cells_v, 0U);
}

TEST(UvGridCreate, TakesNoOptionsToo) {
  abut_shape* shape = nullptr;
  ASSERT_TRUE(succeeded(create(nullptr, &shape)));
  EXPECT_EQ(abut_shape_kind_of(shape), abut_shape_kind_by_name("uv_grid"));
  abut_shape_release(shape);
}

TEST(UvGridCreate, RefusesBadOptions) {
  Out<abut_shape*> out;
  abut_uv_grid_options options = good_options();
  options.sides = 7;
  EXPECT_TRUE(refused(create(&options, out.address()), ABUT_UNKNOWN_VALUE, {"sides", "7"}));
  options = good_options();
  options.axis_u = 3;
  EXPECT_TRUE(refused(create(&options, out.address()), ABUT_UNKNOWN_VALUE, {"axis_u", "3"}));
  options = good_options();
  options.axis_v = ABUT_AXIS_X;
  EXPECT_TRUE(refused(create(&options, out.address()), ABUT_OUT_OF_RANGE, {"axis_v", "0"}));
  options = good_options();
  options.cells_u = 70000;
  EXPECT_TRUE(refused(create(&options, out.address()), ABUT_OUT_OF_RANGE, {"cells_u", "70000"}));
  options = good_options();
  options.cells_u = options.cells_v = 65535;
  EXPECT_TRUE(refused(create(&options, out.address()), ABUT_OUT_OF_RANGE, {"cells_u * cells_v"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(UvGridCreate, RefusesWhatIsNoMesh) {
  Out<abut_shape*> out;
  EXPECT_TRUE(refused(abut_uv_grid_create(corners.data(), 2, triangle.data(), 1, nullptr, out.address()),
                      ABUT_INDEX_OUT_OF_RANGE, {"triangles[2]", "2"}));
  EXPECT_TRUE(refused(abut_uv_grid_create(corners.data(), 0, triangle.data(), 1, nullptr, out.address()), ABUT_EMPTY,
                      {"vertex_count is 0"}));
  EXPECT_TRUE(refused(abut_uv_grid_create(corners.data(), 3, triangle.data(), 0, nullptr, out.address()), ABUT_EMPTY,
                      {"triangle_count is 0"}));
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
