// SPDX-License-Identifier: Apache-2.0
// Shapes against a universe under bad input.
#include "query_calls.hpp"

namespace {

using namespace abut_test;

TEST(UniverseCastShape, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_shape); }
TEST(UniverseCastShape, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_shape); }
TEST(UniverseCastShape, RefusesUnknownModes) {
  QueryCall call;
  EXPECT_TRUE(refused(abut_universe_cast_shape(call.universe, call.shape, &call.pose, &call.vector, nullptr, 77,
                                               call.cast.address(), 1, call.count.address()),
                      ABUT_UNKNOWN_VALUE, {"mode", "77"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseCastShapes, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_shapes); }
TEST(UniverseCastShapes, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_shapes); }
TEST(UniverseCastMovement, RefusesBadDurations) { refuse_bad_durations(&QueryCall::cast_movement); }
TEST(UniverseCastMovement, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_movement); }
TEST(UniverseCastMovement, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_movement); }
abut_impact_options default_impact_options() {
  abut_impact_options options;
  abut_impact_options_init(&options, sizeof options);
  return options;
}

TEST(UniverseCastMovement, RefusesBadOptionsAndModes) {
  QueryCall call;
  const abut_movement movement = call.movement();
  const auto ask = [&](const abut_impact_options* options, abut_hit_mode mode) {
    return abut_universe_cast_movement(call.universe, call.shape, &call.pose, &movement, 1, options, nullptr, mode,
                                       call.impact.address(), 1, call.count.address());
  };
  abut_impact_options options = default_impact_options();
  options.margin = -0.5;
  EXPECT_TRUE(refused(ask(&options, ABUT_HIT_ANY), ABUT_OUT_OF_RANGE, {"options.margin", "-0.5"}));
  EXPECT_TRUE(refused(ask(nullptr, 77), ABUT_UNKNOWN_VALUE, {"mode", "77"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastMovement, RefusesTooManyRevolutions) {
  QueryCall call;
  abut_movement movement = call.movement();
  movement.angular_velocity = {0, 0, 201};
  EXPECT_TRUE(refused(abut_universe_cast_movement(call.universe, call.shape, &call.pose, &movement, 1, nullptr, nullptr,
                                                  0, call.impact.address(), 1, call.count.address()),
                      ABUT_OUT_OF_RANGE, {"movement.revolutions is 31.9", "16"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseCastMovements, RefusesBadDurations) { refuse_bad_durations(&QueryCall::cast_movements); }
TEST(UniverseCastMovements, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_movements); }
TEST(UniverseCastMovements, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_movements); }
TEST(UniverseOverlaps, RefusesBadPoses) { refuse_bad_poses(&QueryCall::overlaps); }
TEST(UniverseOverlaps, RefusesBadFilters) { refuse_bad_filters(&QueryCall::overlaps); }

TEST(UniverseOverlapsOfEach, RefusesBadPoses) { refuse_bad_poses(&QueryCall::overlaps_of_each); }
TEST(UniverseOverlapsOfEach, RefusesBadFilters) { refuse_bad_filters(&QueryCall::overlaps_of_each); }
TEST(UniverseClosest, RefusesNonFiniteDistances) { refuse_bad_largest_distances(&QueryCall::closest); }
TEST(UniverseClosest, RefusesBadPoses) { refuse_bad_poses(&QueryCall::closest); }
TEST(UniverseClosest, RefusesBadFilters) { refuse_bad_filters(&QueryCall::closest); }

TEST(UniverseClosestToEach, RefusesNonFiniteDistances) { refuse_bad_largest_distances(&QueryCall::closest_to_each); }
TEST(UniverseClosestToEach, RefusesBadPoses) { refuse_bad_poses(&QueryCall::closest_to_each); }
TEST(UniverseClosestToEach, RefusesBadFilters) { refuse_bad_filters(&QueryCall::closest_to_each); }
}  // namespace
