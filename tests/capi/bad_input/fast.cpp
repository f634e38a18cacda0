// SPDX-License-Identifier: Apache-2.0
// Accelerations of parts, fast geometries and their impacts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr abut_acceleration some{{1, 2, 3}, {4, 5, 6}};
constexpr abut_acceleration none{{0, 0, 0}, {0, 0, 0}};

// A refused call has left no acceleration behind.
void expect_none(const Scene& scene) {
  EXPECT_TRUE(scene.is_unchanged());
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  std::array<abut_acceleration, 2> out{some, some};
  ASSERT_TRUE(succeeded(abut_parts_accelerations(scene.universe, parts.data(), 2, out.data())));
  for (const abut_acceleration& its : out) {
    EXPECT_EQ(its.linear.x, none.linear.x);
    EXPECT_EQ(its.angular.z, none.angular.z);
  }
}

TEST(PartSetAcceleration, RefusesNullUniverse) {
  const Scene scene;
  EXPECT_TRUE(
      refused(abut_part_set_acceleration(nullptr, scene.part, &some), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(succeeded(abut_part_set_acceleration(scene.universe, scene.part, nullptr))) << "none, as before";
  expect_none(scene);
}

TEST(PartSetAcceleration, RefusesStaleIds) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    for (const abut_acceleration* const given : {&some, static_cast<const abut_acceleration*>(nullptr)}) {
      EXPECT_TRUE(refused(abut_part_set_acceleration(scene.universe, stale, given), ABUT_STALE_ID,
                          {"part", std::to_string(stale.slot)}));
    }
  }
  expect_none(scene);
}

TEST(PartSetAcceleration, RefusesNonFiniteAndHugeNumbers) {
  const Scene scene;
  expect_non_finite_refused("acceleration.linear.y", [&](double bad) {
    const abut_acceleration given{{0, bad, 0}, {0, 0, 0}};
    return abut_part_set_acceleration(scene.universe, scene.part, &given);
  });
  const abut_acceleration huge{{0, 0, 0}, {0, 0, 1e71}};
  EXPECT_TRUE(refused(abut_part_set_acceleration(scene.universe, scene.part, &huge), ABUT_OUT_OF_RANGE,
                      {"acceleration.angular.z", "1e+71"}));
  expect_none(scene);
}

TEST(PartsSetAccelerations, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(
      refused(abut_parts_set_accelerations(nullptr, &scene.part, &some, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_set_accelerations(scene.universe, nullptr, &some, 1), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(succeeded(abut_parts_set_accelerations(scene.universe, &scene.part, nullptr, 1))) << "none, as before";
  expect_none(scene);
}

TEST(PartsSetAccelerations, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_acceleration), "count", [&](std::size_t count) {
    return abut_parts_set_accelerations(scene.universe, &scene.part, &some, count);
  });
  expect_none(scene);
}

TEST(PartsSetAccelerations, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  const std::array<abut_acceleration, 2> given{some, some};
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_set_accelerations(scene.universe, parts.data(), given.data(), 2), ABUT_STALE_ID,
                        {"parts[1]", std::to_string(stale.slot)}));
  }
  expect_none(scene);
}

TEST(PartsSetAccelerations, RefusesNonFiniteNumbersAndSetsNone) {
  const Scene scene;
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  expect_non_finite_refused("accelerations[1].angular.x", [&](double bad) {
    const std::array<abut_acceleration, 2> given{some, {{0, 0, 0}, {bad, 0, 0}}};
    return abut_parts_set_accelerations(scene.universe, parts.data(), given.data(), 2);
  });
  expect_none(scene);
}

TEST(PartsAccelerations, RefusesNullPointers) {
  const Scene scene;
  Out<abut_acceleration> out;
  EXPECT_TRUE(refused(abut_parts_accelerations(nullptr, &scene.part, 1, out.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_parts_accelerations(scene.universe, nullptr, 1, out.address()), ABUT_NULL_ARGUMENT,
                      {"parts", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_accelerations(scene.universe, &scene.part, 1, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartsAccelerations, RefusesOverflowingCounts) {
  const Scene scene;
  Out<abut_acceleration> out;
  expect_overflow_refused(sizeof(abut_acceleration), "count", [&](std::size_t count) {
    return abut_parts_accelerations(scene.universe, &scene.part, count, out.address());
  });
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartsAccelerations, RefusesStaleIds) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    OutArray<abut_acceleration> out(2);
    EXPECT_TRUE(refused(abut_parts_accelerations(scene.universe, parts.data(), 2, out.data()), ABUT_STALE_ID,
                        {"parts[1]", std::to_string(stale.slot)}));
    EXPECT_TRUE(out.is_untouched());
  }
}

// Lets both geometries of the scene move at this speed, of which one is fast.
void make_fast(Scene& scene, const abut_velocity& velocity) {
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_FAST;
  require(abut_geometry_set_options(scene.universe, scene.geometry, &options));
  require(abut_part_set_velocity(scene.universe, scene.second_part, &velocity));
  require(abut_universe_step(scene.universe, 0));
}

TEST(UniverseStep, RefusesMotionsThatNoWayHas) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "this build is without the feature motion";
  Scene scene;
  make_fast(scene, {{1e70, 0, 0}, {0, 0, 60}});
  const auto before = snapshot(scene.universe);
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, 2), ABUT_OUT_OF_RANGE,
                      {"dt is 2", "slot " + std::to_string(scene.second_part.slot), "velocity[0]", "2e+70"}));
  EXPECT_TRUE(refused(abut_universe_step(scene.universe, 1e300), ABUT_NOT_FINITE, {"dt is 1e+300", "velocity[0]"}));
  const abut_velocity spinning{{0, 0, 0}, {0, 0, 60}};
  require(abut_part_set_velocity(scene.universe, scene.second_part, &spinning));
  EXPECT_TRUE(
      refused(abut_universe_step(scene.universe, 2), ABUT_OUT_OF_RANGE, {"dt is 2", "revolutions", "19.09", "16"}));
  EXPECT_EQ(snapshot(scene.universe), before);
  EXPECT_TRUE(succeeded(abut_universe_step(scene.universe, 1)));
  const abut_geometry_options slow = default_geometry_options();
  require(abut_geometry_set_options(scene.universe, scene.geometry, &slow));
  EXPECT_TRUE(succeeded(abut_universe_step(scene.universe, 2))) << "nobody looks at ways";
}

TEST(UniverseImpacts, RefusesNullPointers) {
  const Scene scene;
  Out<const abut_step_impact*> impacts;
  Out<std::size_t> count;
  EXPECT_TRUE(refused(abut_universe_impacts(nullptr, impacts.address(), count.address()), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_impacts(scene.universe, nullptr, count.address()), ABUT_NULL_ARGUMENT,
                      {"impacts", "null"}));
  EXPECT_TRUE(refused(abut_universe_impacts(scene.universe, impacts.address(), nullptr), ABUT_NULL_ARGUMENT,
                      {"count", "null"}));
  EXPECT_TRUE(impacts.is_untouched() && count.is_untouched() && scene.is_unchanged());
}

TEST(UniverseAdvanceToFirstImpact, RefusesNullPointers) {
  const Scene scene;
  Out<abut_step_impact> out;
  EXPECT_TRUE(
      refused(abut_universe_advance_to_first_impact(nullptr, 1, out.address()), ABUT_NULL_ARGUMENT, {"universe"}));
  EXPECT_TRUE(
      refused(abut_universe_advance_to_first_impact(scene.universe, 1, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched() && scene.is_unchanged());
}

TEST(UniverseAdvanceToFirstImpact, RefusesNonFiniteAndNegativeTimes) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "this build is without the feature motion";
  const Scene scene;
  Out<abut_step_impact> out;
  expect_non_finite_refused(
      "dt", [&](double bad) { return abut_universe_advance_to_first_impact(scene.universe, bad, out.address()); });
  EXPECT_TRUE(refused(abut_universe_advance_to_first_impact(scene.universe, -0.5, out.address()), ABUT_OUT_OF_RANGE,
                      {"dt", "-0.5"}));
  EXPECT_TRUE(out.is_untouched() && scene.is_unchanged());
}

TEST(GeometrySetOptions, RefusesFlagsOfTwoWaysToLookAtMotion) {
  if (abut_has_feature("motion") == 0) GTEST_SKIP() << "this build is without the feature motion";
  const Scene scene;
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_FAST | ABUT_GEOMETRY_SPECULATIVE;
  EXPECT_TRUE(refused(abut_geometry_set_options(scene.universe, scene.geometry, &options), ABUT_INVALID_ARGUMENT,
                      {"options.flags", "12", "not both"}));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(UniverseStep, RefusesToBeFastWithoutTheFeature) {
  if (abut_has_feature("motion") != 0) GTEST_SKIP() << "this build has the feature motion";
  const Scene scene;
  abut_geometry_options options = default_geometry_options();
  options.flags = ABUT_GEOMETRY_FAST;
  EXPECT_TRUE(
      refused(abut_geometry_set_options(scene.universe, scene.geometry, &options), ABUT_UNSUPPORTED, {"motion"}));
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
