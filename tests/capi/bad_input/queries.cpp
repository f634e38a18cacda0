// SPDX-License-Identifier: Apache-2.0
// Rays and points against a universe under bad input.
#include "query_calls.hpp"

namespace {

using namespace abut_test;

TEST(QueryFilterInit, IgnoresNull) { abut_query_filter_init(nullptr, 0); }

TEST(QueryFilterInit, FillsInTheDefaults) {
  Out<abut_query_filter> filter;
  abut_query_filter_init(filter.address(), sizeof(abut_query_filter));
  EXPECT_EQ(filter.value().struct_size, sizeof(abut_query_filter));
  EXPECT_EQ(filter.value().flags, 0U);
  EXPECT_EQ(filter.value().layers, ~std::uint64_t{0});
  EXPECT_EQ(filter.value().mask, ~std::uint64_t{0});
  EXPECT_EQ(filter.value().ignore_part.slot, 0U);
  EXPECT_EQ(filter.value().ignore_geometry.slot, 0U);
  EXPECT_EQ(filter.value().ray_start, ABUT_RAY_START_FAR_SIDE);
}

TEST(UniverseCastRay, RefusesNull) {
  refuse_null_universe(&QueryCall::cast_ray);
  QueryCall call;
  EXPECT_TRUE(
      refused(abut_universe_cast_ray(call.universe, nullptr, nullptr, 0, call.hit.address(), 1, call.count.address()),
              ABUT_NULL_ARGUMENT, {"ray", "null"}));
  EXPECT_TRUE(refused(abut_universe_cast_ray(call.universe, &call.ray, nullptr, 0, nullptr, 1, call.count.address()),
                      ABUT_NULL_ARGUMENT, {"hits", "null"}));
  EXPECT_TRUE(refused(abut_universe_cast_ray(call.universe, &call.ray, nullptr, 0, call.hit.address(), 1, nullptr),
                      ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastRay, RefusesNonFiniteAndZeroRays) { refuse_bad_rays(&QueryCall::cast_ray); }
TEST(UniverseCastRay, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_ray); }
TEST(UniverseCastRay, RefusesUnknownModes) {
  QueryCall call;
  EXPECT_TRUE(
      refused(abut_universe_cast_ray(call.universe, &call.ray, nullptr, 3, call.hit.address(), 1, call.count.address()),
              ABUT_UNKNOWN_VALUE, {"mode", "3"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseCastRays, RefusesNull) {
  refuse_null_universe(&QueryCall::cast_rays);
  QueryCall call;
  EXPECT_TRUE(refused(abut_universe_cast_rays(call.universe, nullptr, 1, nullptr, call.hit.address()),
                      ABUT_NULL_ARGUMENT, {"rays", "null"}));
  EXPECT_TRUE(refused(abut_universe_cast_rays(call.universe, &call.ray, 1, nullptr, nullptr), ABUT_NULL_ARGUMENT,
                      {"hits", "null"}));
  EXPECT_TRUE(succeeded(abut_universe_cast_rays(call.universe, nullptr, 0, nullptr, nullptr)));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastRays, RefusesNonFiniteAndZeroRays) { refuse_bad_rays(&QueryCall::cast_rays); }
TEST(UniverseCastRays, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_rays); }
TEST(UniverseCastRays, RefusesOverflowingCounts) {
  QueryCall call;
  expect_overflow_refused(sizeof(abut_ray), "count", [&](std::size_t count) {
    return abut_universe_cast_rays(call.universe, &call.ray, count, nullptr, call.hit.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseAtPoint, RefusesNull) {
  refuse_null_universe(&QueryCall::at_point);
  QueryCall call;
  const auto ask = [&](const abut_vec3* point, abut_geometry_id* geometries, std::size_t* count) {
    return abut_universe_at_point(call.universe, point, nullptr, geometries, 4, count);
  };
  EXPECT_TRUE(
      refused(ask(nullptr, call.geometries.data(), call.count.address()), ABUT_NULL_ARGUMENT, {"position", "null"}));
  EXPECT_TRUE(refused(ask(&call.vector, nullptr, call.count.address()), ABUT_NULL_ARGUMENT, {"geometries", "null"}));
  EXPECT_TRUE(refused(ask(&call.vector, call.geometries.data(), nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseAtPoint, RefusesNonFinitePoints) { refuse_bad_vectors(&QueryCall::at_point, "position"); }
TEST(UniverseAtPoint, RefusesBadFilters) { refuse_bad_filters(&QueryCall::at_point); }

TEST(UniverseAtPoints, RefusesNull) {
  refuse_null_universe(&QueryCall::at_points);
  QueryCall call;
  const auto ask = [&](const abut_vec3* points, std::uint64_t* offsets, abut_geometry_id* geometries,
                       std::size_t* count) {
    return abut_universe_at_points(call.universe, points, 1, nullptr, offsets, geometries, 4, count);
  };
  std::uint64_t* offsets = call.offsets.data();
  abut_geometry_id* geometries = call.geometries.data();
  EXPECT_TRUE(
      refused(ask(nullptr, offsets, geometries, call.count.address()), ABUT_NULL_ARGUMENT, {"positions", "null"}));
  EXPECT_TRUE(
      refused(ask(&call.vector, nullptr, geometries, call.count.address()), ABUT_NULL_ARGUMENT, {"offsets", "null"}));
  EXPECT_TRUE(
      refused(ask(&call.vector, offsets, nullptr, call.count.address()), ABUT_NULL_ARGUMENT, {"geometries", "null"}));
  EXPECT_TRUE(refused(ask(&call.vector, offsets, geometries, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseAtPoints, RefusesNonFinitePoints) { refuse_bad_vectors(&QueryCall::at_points, "positions"); }
TEST(UniverseAtPoints, RefusesBadFilters) { refuse_bad_filters(&QueryCall::at_points); }
TEST(UniverseAtPoints, RefusesOverflowingCounts) {
  QueryCall call;
  expect_overflow_refused(sizeof(abut_vec3), "query_count", [&](std::size_t count) {
    return abut_universe_at_points(call.universe, &call.vector, count, nullptr, call.offsets.data(),
                                   call.geometries.data(), 4, call.count.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

}  // namespace
