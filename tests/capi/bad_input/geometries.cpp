// SPDX-License-Identifier: Apache-2.0
// Single geometries under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

TEST(GeometryOptionsInit, IgnoresNull) { abut_geometry_options_init(nullptr, 0); }

TEST(GeometryOptionsInit, FillsInTheDefaults) {
  Out<abut_geometry_options> options;
  abut_geometry_options_init(options.address(), sizeof(abut_geometry_options));
  EXPECT_EQ(options.value().struct_size, sizeof(abut_geometry_options));
  EXPECT_EQ(options.value().flags, 0U);
  EXPECT_EQ(options.value().pose.orientation.w, 1.0);
  EXPECT_EQ(options.value().pose.position.z, 0.0);
  EXPECT_EQ(options.value().tolerance, 0.0);
  EXPECT_EQ(options.value().user_data, 0U);
  EXPECT_EQ(options.value().layers, 1U);
  EXPECT_EQ(options.value().mask, ~std::uint64_t{0});
  EXPECT_EQ(options.value().exclusion, 0U);
  EXPECT_EQ(options.value().label, 0U);
  EXPECT_EQ(options.value().tag, 0U);
  EXPECT_EQ(options.value().material, 0U);
  EXPECT_EQ(options.value().parking, abut_parking{ABUT_PARKING_NONE});
}

TEST(GeometryCreate, RefusesBadTolerance) {
  const Scene scene;
  Out<abut_geometry_id> out;
  abut_geometry_options options = default_geometry_options();
  expect_non_finite_refused("tolerance", [&](double bad) {
    options.tolerance = bad;
    return abut_geometry_create(scene.universe, scene.part, scene.ball, &options, out.address());
  });
  options.tolerance = -2.5;
  EXPECT_TRUE(refused(abut_geometry_create(scene.universe, scene.part, scene.ball, &options, out.address()),
                      ABUT_OUT_OF_RANGE, {"tolerance", "-2.5"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometryCreate, RefusesUnknownValues) {
  const Scene scene;
  Out<abut_geometry_id> out;
  expect_unknown_geometry_values_refused([&](const abut_geometry_options& options) {
    return abut_geometry_create(scene.universe, scene.part, scene.ball, &options, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(GeometryCreate, AcceptsLaterOptionsWithZeroTail) {
  const Scene scene;
  abut_geometry_id geometry{};
  expect_zero_tail_accepted(default_geometry_options(), [&](const abut_geometry_options* later) {
    return abut_geometry_create(scene.universe, scene.part, scene.ball, later, &geometry);
  });
  EXPECT_NE(geometry.slot, 0U);
}

TEST(GeometryInfoInit, IgnoresNull) { abut_geometry_info_init(nullptr, 0); }

TEST(GeometryInfoInit, FillsInSize) {
  Out<abut_geometry_info> info;
  abut_geometry_info_init(info.address(), sizeof(abut_geometry_info));
  EXPECT_EQ(info.value().struct_size, sizeof(abut_geometry_info));
  EXPECT_EQ(info.value().kind, 0U);
  EXPECT_EQ(info.value().part.slot, 0U);
  EXPECT_EQ(info.value().shape, nullptr);
}

TEST(GeometryDescribe, AcceptsLaterStructWithZeroTail) {
  const Scene scene;
  Grown<abut_geometry_info> later{};
  abut_geometry_info_init(&later.known, sizeof later.known);
  later.known.struct_size = sizeof(later);
  EXPECT_TRUE(succeeded(abut_geometry_describe(scene.universe, scene.geometry, &later.known)));
  EXPECT_EQ(later.known.struct_size, sizeof(later));
  EXPECT_EQ(later.known.part, scene.part);
}

}  // namespace
