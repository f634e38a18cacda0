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

TEST(UniverseCastRay, RefusesNonFiniteAndZeroRays) { refuse_bad_rays(&QueryCall::cast_ray); }
TEST(UniverseCastRay, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_ray); }
TEST(UniverseCastRay, RefusesUnknownModes) {
  QueryCall call;
  EXPECT_TRUE(
      refused(abut_universe_cast_ray(call.universe, &call.ray, nullptr, 3, call.hit.address(), 1, call.count.address()),
              ABUT_UNKNOWN_VALUE, {"mode", "3"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseCastRays, RefusesNonFiniteAndZeroRays) { refuse_bad_rays(&QueryCall::cast_rays); }
TEST(UniverseCastRays, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_rays); }
TEST(UniverseAtPoint, RefusesBadFilters) { refuse_bad_filters(&QueryCall::at_point); }

TEST(UniverseAtPoints, RefusesBadFilters) { refuse_bad_filters(&QueryCall::at_points); }
}  // namespace
