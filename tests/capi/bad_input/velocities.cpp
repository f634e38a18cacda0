// SPDX-License-Identifier: Apache-2.0
// Velocities of parts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

constexpr abut_velocity some{{1, 2, 3}, {4, 5, 6}};

// A refused call has left no velocity behind.
void expect_none(const Scene& scene) {
  EXPECT_TRUE(scene.is_unchanged());
  for (const abut_part_id part : {scene.part, scene.second_part}) {
    abut_velocity out{};
    abut_velocity_source source = 7;
    ASSERT_TRUE(succeeded(abut_part_velocity(scene.universe, part, &out, &source)));
    EXPECT_EQ(source, abut_velocity_source{ABUT_VELOCITY_NONE});
    EXPECT_EQ(out.linear.x, 0);
  }
}

constexpr std::array<std::pair<std::string_view, double abut_vec3::*>, 3> axes{
    {{".x", &abut_vec3::x}, {".y", &abut_vec3::y}, {".z", &abut_vec3::z}}};
constexpr std::array<std::pair<std::string_view, abut_vec3 abut_velocity::*>, 2> vectors{
    {{".linear", &abut_velocity::linear}, {".angular", &abut_velocity::angular}}};

TEST(PartSetVelocity, RefusesNullUniverse) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_part_set_velocity(nullptr, scene.part, &some), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(succeeded(abut_part_set_velocity(scene.universe, scene.part, nullptr))) << "none, as before";
  expect_none(scene);
}

TEST(PartSetVelocity, RefusesStaleIds) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_set_velocity(scene.universe, stale, &some), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
    EXPECT_TRUE(refused(abut_part_set_velocity(scene.universe, stale, nullptr), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  expect_none(scene);
}

TEST(PartSetVelocity, RefusesNonFiniteAndHugeNumbers) {
  const Scene scene;
  for (const auto& [vector, member] : vectors) {
    for (const auto& [axis, coordinate] : axes) {
      const std::string name = "velocity" + std::string(vector) + std::string(axis);
      abut_velocity velocity = some;
      expect_non_finite_refused(name, [&](double bad) {
        velocity.*member.*coordinate = bad;
        return abut_part_set_velocity(scene.universe, scene.part, &velocity);
      });
      velocity.*member.*coordinate = -1e71;
      EXPECT_TRUE(
          refused(abut_part_set_velocity(scene.universe, scene.part, &velocity), ABUT_OUT_OF_RANGE, {name, "1e+71"}));
    }
  }
  expect_none(scene);
}

TEST(PartsSetVelocities, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(
      refused(abut_parts_set_velocities(nullptr, &scene.part, &some, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_set_velocities(scene.universe, nullptr, &some, 1), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(succeeded(abut_parts_set_velocities(scene.universe, &scene.part, nullptr, 1))) << "none, as before";
  EXPECT_TRUE(succeeded(abut_parts_set_velocities(scene.universe, nullptr, nullptr, 0)));
  expect_none(scene);
}

TEST(PartsSetVelocities, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_velocity), "count", [&](std::size_t count) {
    return abut_parts_set_velocities(scene.universe, &scene.part, &some, count);
  });
  expect_none(scene);
}

TEST(PartsSetVelocities, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  const std::array<abut_velocity, 2> velocities{some, some};
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_set_velocities(scene.universe, parts.data(), velocities.data(), 2), ABUT_STALE_ID,
                        {"parts[1]", std::to_string(stale.slot)}));
  }
  expect_none(scene);
}

TEST(PartsSetVelocities, RefusesNonFiniteNumbersAndSetsNone) {
  const Scene scene;
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  expect_non_finite_refused("velocities[1].angular.y", [&](double bad) {
    const std::array<abut_velocity, 2> velocities{some, {{0, 0, 0}, {0, bad, 0}}};
    return abut_parts_set_velocities(scene.universe, parts.data(), velocities.data(), 2);
  });
  expect_none(scene);
}

TEST(PartMeasureVelocity, RefusesNullAndStaleIds) {
  const Scene scene;
  EXPECT_TRUE(refused(abut_part_measure_velocity(nullptr, scene.part), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_measure_velocity(scene.universe, stale), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  expect_none(scene);
}

TEST(PartsMeasureVelocities, RefusesNullPointers) {
  const Scene scene;
  EXPECT_TRUE(
      refused(abut_parts_measure_velocities(nullptr, &scene.part, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_measure_velocities(scene.universe, nullptr, 1), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(succeeded(abut_parts_measure_velocities(scene.universe, nullptr, 0)));
  expect_none(scene);
}

TEST(PartsMeasureVelocities, RefusesOverflowingCounts) {
  const Scene scene;
  expect_overflow_refused(sizeof(abut_part_id), "count", [&](std::size_t count) {
    return abut_parts_measure_velocities(scene.universe, &scene.part, count);
  });
  expect_none(scene);
}

TEST(PartsMeasureVelocities, RefusesStaleIdsAndMeasuresNone) {
  const Scene scene;
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_measure_velocities(scene.universe, parts.data(), 2), ABUT_STALE_ID,
                        {"parts[1]", std::to_string(stale.slot)}));
  }
  expect_none(scene);
}

TEST(PartVelocity, RefusesNullPointers) {
  const Scene scene;
  Out<abut_velocity> out;
  Out<abut_velocity_source> source;
  EXPECT_TRUE(refused(abut_part_velocity(nullptr, scene.part, out.address(), source.address()), ABUT_NULL_ARGUMENT,
                      {"universe"}));
  EXPECT_TRUE(
      refused(abut_part_velocity(scene.universe, scene.part, nullptr, source.address()), ABUT_NULL_ARGUMENT, {"out"}));
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(source.is_untouched());
  EXPECT_TRUE(succeeded(abut_part_velocity(scene.universe, scene.part, out.address(), nullptr)));
}

TEST(PartVelocity, RefusesStaleIds) {
  const Scene scene;
  Out<abut_velocity> out;
  Out<abut_velocity_source> source;
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_velocity(scene.universe, stale, out.address(), source.address()), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
  EXPECT_TRUE(source.is_untouched());
}

TEST(PartsVelocities, RefusesNullPointers) {
  const Scene scene;
  OutArray<abut_velocity> out(1);
  EXPECT_TRUE(
      refused(abut_parts_velocities(nullptr, &scene.part, 1, out.data()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_velocities(scene.universe, nullptr, 1, out.data()), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(
      refused(abut_parts_velocities(scene.universe, &scene.part, 1, nullptr), ABUT_NULL_ARGUMENT, {"out", "null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartsVelocities, RefusesOverflowingCounts) {
  const Scene scene;
  OutArray<abut_velocity> out(1);
  expect_overflow_refused(sizeof(abut_velocity), "count", [&](std::size_t count) {
    return abut_parts_velocities(scene.universe, &scene.part, count, out.data());
  });
  EXPECT_TRUE(out.is_untouched());
}

TEST(PartsVelocities, RefusesStaleIds) {
  const Scene scene;
  OutArray<abut_velocity> out(2);
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_velocities(scene.universe, parts.data(), 2, out.data()), ABUT_STALE_ID,
                        {"parts[1]", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

}  // namespace
