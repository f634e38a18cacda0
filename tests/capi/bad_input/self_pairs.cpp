// SPDX-License-Identifier: Apache-2.0
// Self pairs of kinds that do not meet themselves.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

abut_geometry_options with_self_pairs() {
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_SELF_PAIRS;
  return options;
}

TEST(GeometrySelfPairs, RefusesKindsThatDoNotMeetThemselves) {
  const Scene scene;
  const abut_geometry_options options = with_self_pairs();
  const auto shapes = make_one_of_each_kind();
  std::size_t refused_kinds = 0;
  for (const Shape& shape : shapes) {
    Universe universe;
    const abut_part_id part = universe.add_part(identity);
    Out<abut_geometry_id> out;
    const std::string kind = abut_shape_kind_name(abut_shape_kind_of(shape));
    const abut_status status = abut_geometry_create(universe, part, shape, &options, out.address());
    if (kind == "mesh") {
      EXPECT_TRUE(succeeded(status));
      continue;
    }
    ++refused_kinds;
    EXPECT_TRUE(refused(status, ABUT_UNSUPPORTED, {"options.flags", "self pairs", kind}));
    EXPECT_TRUE(out.is_untouched());
  }
  EXPECT_EQ(refused_kinds, shapes.size() - 1);
}

TEST(GeometrySelfPairs, RefusedOptionsChangeNothing) {
  const Scene scene;
  const abut_geometry_options options = with_self_pairs();
  EXPECT_TRUE(refused(abut_geometry_set_options(scene.universe, scene.geometry, &options), ABUT_UNSUPPORTED,
                      {"options.flags", "self pairs"}));
  const std::array<abut_geometry_id, 2> ids{scene.geometry, scene.second_geometry};
  const std::array<abut_geometry_options, 2> both{default_geometry_options(), options};
  EXPECT_TRUE(refused(abut_geometries_set_options(scene.universe, ids.data(), both.data(), 2), ABUT_UNSUPPORTED,
                      {"options[1].flags", "self pairs"}));
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  const std::array<const abut_shape*, 2> shapes{scene.ball, scene.block};
  OutArray<abut_geometry_id> out(2);
  EXPECT_TRUE(refused(abut_geometries_create(scene.universe, parts.data(), shapes.data(), both.data(), 2, out.data()),
                      ABUT_UNSUPPORTED, {"options[1].flags", "self pairs", "box"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
