// SPDX-License-Identifier: Apache-2.0
// Shapes against a universe under bad input.
#include "query_calls.hpp"

namespace {

using namespace abut_test;

TEST(UniverseCastShape, RefusesNull) {
  refuse_null_universe(&QueryCall::cast_shape);
  refuse_null_shape(&QueryCall::cast_shape);
  QueryCall call;
  const auto ask = [&](const abut_pose* pose, const abut_vec3* displacement, abut_cast_hit* hits, std::size_t* count) {
    return abut_universe_cast_shape(call.universe, call.shape, pose, displacement, nullptr, 0, hits, 1, count);
  };
  EXPECT_TRUE(refused(ask(nullptr, &call.vector, call.cast.address(), call.count.address()), ABUT_NULL_ARGUMENT,
                      {"pose", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, nullptr, call.cast.address(), call.count.address()), ABUT_NULL_ARGUMENT,
                      {"displacement", "null"}));
  EXPECT_TRUE(
      refused(ask(&call.pose, &call.vector, nullptr, call.count.address()), ABUT_NULL_ARGUMENT, {"hits", "null"}));
  EXPECT_TRUE(
      refused(ask(&call.pose, &call.vector, call.cast.address(), nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastShape, RefusesNonFiniteDisplacements) { refuse_bad_vectors(&QueryCall::cast_shape, "displacement"); }
TEST(UniverseCastShape, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_shape); }
TEST(UniverseCastShape, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_shape); }
TEST(UniverseCastShape, RefusesUnknownModes) {
  QueryCall call;
  EXPECT_TRUE(refused(abut_universe_cast_shape(call.universe, call.shape, &call.pose, &call.vector, nullptr, 77,
                                               call.cast.address(), 1, call.count.address()),
                      ABUT_UNKNOWN_VALUE, {"mode", "77"}));
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseCastShapes, RefusesNull) {
  refuse_null_universe(&QueryCall::cast_shapes);
  refuse_null_shape(&QueryCall::cast_shapes);
  QueryCall call;
  const auto ask = [&](const abut_shape* const* shapes, const abut_pose* poses, const abut_vec3* displacements,
                       abut_cast_hit* hits) {
    return abut_universe_cast_shapes(call.universe, shapes, poses, displacements, 1, nullptr, hits);
  };
  EXPECT_TRUE(
      refused(ask(nullptr, &call.pose, &call.vector, call.cast.address()), ABUT_NULL_ARGUMENT, {"shapes", "null"}));
  EXPECT_TRUE(
      refused(ask(&call.shape, nullptr, &call.vector, call.cast.address()), ABUT_NULL_ARGUMENT, {"poses", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, nullptr, call.cast.address()), ABUT_NULL_ARGUMENT,
                      {"displacements", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, &call.vector, nullptr), ABUT_NULL_ARGUMENT, {"hits", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastShapes, RefusesNonFiniteDisplacements) { refuse_bad_vectors(&QueryCall::cast_shapes, "displacement"); }
TEST(UniverseCastShapes, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_shapes); }
TEST(UniverseCastShapes, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_shapes); }
TEST(UniverseCastShapes, RefusesOverflowingCounts) {
  QueryCall call;
  expect_overflow_refused(sizeof(abut_vec3), "count", [&](std::size_t count) {
    return abut_universe_cast_shapes(call.universe, &call.shape, &call.pose, &call.vector, count, nullptr,
                                     call.cast.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseCastMovement, RefusesNull) {
  refuse_null_universe(&QueryCall::cast_movement);
  refuse_null_shape(&QueryCall::cast_movement);
  QueryCall call;
  const abut_movement movement = call.movement();
  const auto ask = [&](const abut_pose* pose, const abut_movement* its, abut_impact_hit* hits, std::size_t* count) {
    return abut_universe_cast_movement(call.universe, call.shape, pose, its, 1, nullptr, nullptr, 0, hits, 1, count);
  };
  abut_impact_hit* hits = call.impact.address();
  std::size_t* count = call.count.address();
  EXPECT_TRUE(refused(ask(nullptr, &movement, hits, count), ABUT_NULL_ARGUMENT, {"pose", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, nullptr, hits, count), ABUT_NULL_ARGUMENT, {"movement", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, &movement, nullptr, count), ABUT_NULL_ARGUMENT, {"hits", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, &movement, hits, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastMovement, RefusesNonFiniteMovements) { refuse_bad_vectors(&QueryCall::cast_movement, "movement"); }
TEST(UniverseCastMovement, RefusesBadDurations) { refuse_bad_durations(&QueryCall::cast_movement); }
TEST(UniverseCastMovement, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_movement); }
TEST(UniverseCastMovement, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_movement); }
abut_impact_options default_impact_options() {
  abut_impact_options options;
  abut_impact_options_init(&options, sizeof options);
  return options;
}

TEST(UniverseCastMovement, RefusesWrongStructSize) {
  QueryCall call;
  const abut_movement movement = call.movement();
  expect_struct_size_checked(default_impact_options(), [&](const abut_impact_options* wrong) {
    return abut_universe_cast_movement(call.universe, call.shape, &call.pose, &movement, 1, wrong, nullptr, 0,
                                       call.impact.address(), 1, call.count.address());
  });
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastMovements, RefusesWrongStructSize) {
  QueryCall call;
  const abut_movement movement = call.movement();
  expect_struct_size_checked(default_impact_options(), [&](const abut_impact_options* wrong) {
    return abut_universe_cast_movements(call.universe, &call.shape, &call.pose, &movement, 1, 1, wrong, nullptr,
                                        call.impact.address());
  });
  EXPECT_TRUE(call.is_untouched());
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

TEST(UniverseCastMovements, RefusesNull) {
  refuse_null_universe(&QueryCall::cast_movements);
  refuse_null_shape(&QueryCall::cast_movements);
  QueryCall call;
  const abut_movement movement = call.movement();
  const auto ask = [&](const abut_shape* const* shapes, const abut_pose* poses, const abut_movement* movements,
                       abut_impact_hit* hits) {
    return abut_universe_cast_movements(call.universe, shapes, poses, movements, 1, 1, nullptr, nullptr, hits);
  };
  abut_impact_hit* hits = call.impact.address();
  EXPECT_TRUE(refused(ask(nullptr, &call.pose, &movement, hits), ABUT_NULL_ARGUMENT, {"shapes", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, nullptr, &movement, hits), ABUT_NULL_ARGUMENT, {"poses", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, nullptr, hits), ABUT_NULL_ARGUMENT, {"movements", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, &movement, nullptr), ABUT_NULL_ARGUMENT, {"hits", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseCastMovements, RefusesNonFiniteMovements) {
  refuse_bad_vectors(&QueryCall::cast_movements, "movements[0]");
}
TEST(UniverseCastMovements, RefusesBadDurations) { refuse_bad_durations(&QueryCall::cast_movements); }
TEST(UniverseCastMovements, RefusesBadPoses) { refuse_bad_poses(&QueryCall::cast_movements); }
TEST(UniverseCastMovements, RefusesBadFilters) { refuse_bad_filters(&QueryCall::cast_movements); }
TEST(UniverseCastMovements, RefusesOverflowingCounts) {
  QueryCall call;
  const abut_movement movement = call.movement();
  expect_overflow_refused(sizeof(abut_impact_hit), "count", [&](std::size_t count) {
    return abut_universe_cast_movements(call.universe, &call.shape, &call.pose, &movement, count, 1, nullptr, nullptr,
                                        call.impact.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseOverlaps, RefusesNull) {
  refuse_null_universe(&QueryCall::overlaps);
  refuse_null_shape(&QueryCall::overlaps);
  QueryCall call;
  const auto ask = [&](const abut_pose* pose, abut_geometry_id* geometries, std::size_t* count) {
    return abut_universe_overlaps(call.universe, call.shape, pose, nullptr, 0, geometries, 4, count);
  };
  EXPECT_TRUE(
      refused(ask(nullptr, call.geometries.data(), call.count.address()), ABUT_NULL_ARGUMENT, {"pose", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, nullptr, call.count.address()), ABUT_NULL_ARGUMENT, {"geometries", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, call.geometries.data(), nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseOverlaps, RefusesNonFiniteMargins) { refuse_bad_margins(&QueryCall::overlaps); }
TEST(UniverseOverlaps, RefusesBadPoses) { refuse_bad_poses(&QueryCall::overlaps); }
TEST(UniverseOverlaps, RefusesBadFilters) { refuse_bad_filters(&QueryCall::overlaps); }

TEST(UniverseOverlapsOfEach, RefusesNull) {
  refuse_null_universe(&QueryCall::overlaps_of_each);
  refuse_null_shape(&QueryCall::overlaps_of_each);
  QueryCall call;
  const auto ask = [&](const abut_shape* const* shapes, const abut_pose* poses, std::uint64_t* offsets,
                       abut_geometry_id* geometries, std::size_t* count) {
    return abut_universe_overlaps_of_each(call.universe, shapes, poses, 1, nullptr, 0, offsets, geometries, 4, count);
  };
  std::uint64_t* offsets = call.offsets.data();
  abut_geometry_id* geometries = call.geometries.data();
  EXPECT_TRUE(refused(ask(nullptr, &call.pose, offsets, geometries, call.count.address()), ABUT_NULL_ARGUMENT,
                      {"shapes", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, nullptr, offsets, geometries, call.count.address()), ABUT_NULL_ARGUMENT,
                      {"poses", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, nullptr, geometries, call.count.address()), ABUT_NULL_ARGUMENT,
                      {"offsets", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, offsets, nullptr, call.count.address()), ABUT_NULL_ARGUMENT,
                      {"geometries", "null"}));
  EXPECT_TRUE(
      refused(ask(&call.shape, &call.pose, offsets, geometries, nullptr), ABUT_NULL_ARGUMENT, {"count", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseOverlapsOfEach, RefusesNonFiniteMargins) { refuse_bad_margins(&QueryCall::overlaps_of_each); }
TEST(UniverseOverlapsOfEach, RefusesBadPoses) { refuse_bad_poses(&QueryCall::overlaps_of_each); }
TEST(UniverseOverlapsOfEach, RefusesBadFilters) { refuse_bad_filters(&QueryCall::overlaps_of_each); }
TEST(UniverseOverlapsOfEach, RefusesOverflowingCounts) {
  QueryCall call;
  expect_overflow_refused(sizeof(std::uint64_t), "query_count", [&](std::size_t count) {
    return abut_universe_overlaps_of_each(call.universe, &call.shape, &call.pose, count, nullptr, 0,
                                          call.offsets.data(), call.geometries.data(), 4, call.count.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

TEST(UniverseClosest, RefusesNull) {
  refuse_null_universe(&QueryCall::closest);
  refuse_null_shape(&QueryCall::closest);
  QueryCall call;
  const auto ask = [&](const abut_pose* pose, abut_closest* out, std::uint32_t* found) {
    return abut_universe_closest(call.universe, call.shape, pose, 1, nullptr, out, found);
  };
  EXPECT_TRUE(refused(ask(nullptr, call.near.address(), call.found.address()), ABUT_NULL_ARGUMENT, {"pose", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, nullptr, call.found.address()), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(refused(ask(&call.pose, call.near.address(), nullptr), ABUT_NULL_ARGUMENT, {"found", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseClosest, RefusesNonFiniteDistances) { refuse_bad_largest_distances(&QueryCall::closest); }
TEST(UniverseClosest, RefusesBadPoses) { refuse_bad_poses(&QueryCall::closest); }
TEST(UniverseClosest, RefusesBadFilters) { refuse_bad_filters(&QueryCall::closest); }

TEST(UniverseClosestToEach, RefusesNull) {
  refuse_null_universe(&QueryCall::closest_to_each);
  refuse_null_shape(&QueryCall::closest_to_each);
  QueryCall call;
  const auto ask = [&](const abut_shape* const* shapes, const abut_pose* poses, abut_closest* out) {
    return abut_universe_closest_to_each(call.universe, shapes, poses, 1, 1, nullptr, out);
  };
  EXPECT_TRUE(refused(ask(nullptr, &call.pose, call.near.address()), ABUT_NULL_ARGUMENT, {"shapes", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, nullptr, call.near.address()), ABUT_NULL_ARGUMENT, {"poses", "null"}));
  EXPECT_TRUE(refused(ask(&call.shape, &call.pose, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(call.is_untouched());
}
TEST(UniverseClosestToEach, RefusesNonFiniteDistances) { refuse_bad_largest_distances(&QueryCall::closest_to_each); }
TEST(UniverseClosestToEach, RefusesBadPoses) { refuse_bad_poses(&QueryCall::closest_to_each); }
TEST(UniverseClosestToEach, RefusesBadFilters) { refuse_bad_filters(&QueryCall::closest_to_each); }
TEST(UniverseClosestToEach, RefusesOverflowingCounts) {
  QueryCall call;
  expect_overflow_refused(sizeof(abut_closest), "count", [&](std::size_t count) {
    return abut_universe_closest_to_each(call.universe, &call.shape, &call.pose, count, 1, nullptr,
                                         call.near.address());
  });
  EXPECT_TRUE(call.is_untouched());
}

}  // namespace
