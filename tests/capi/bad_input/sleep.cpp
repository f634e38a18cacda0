// SPDX-License-Identifier: Apache-2.0
// Sleep of parts under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Falls asleep as soon as it can, so that a call that took effect all the same would show.
abut_sleep sleepy() {
  abut_sleep sleep = default_sleep();
  sleep.steps = 1;
  return sleep;
}

// A refused call has left no thresholds behind: nothing sleeps, however long it lies still.
void expect_nobody_sleeps(const Scene& scene) {
  EXPECT_TRUE(scene.is_unchanged());
  for (int step = 0; step < 5; ++step) {
    ASSERT_TRUE(succeeded(abut_universe_step(scene.universe, 0.01)));
  }
  EXPECT_EQ(scene.universe.stats().asleep, 0U);
}

TEST(SleepInit, IgnoresNull) { abut_sleep_init(nullptr, 0); }

TEST(SleepInit, FillsInTheDefaults) {
  Out<abut_sleep> sleep;
  abut_sleep_init(sleep.address(), sizeof(abut_sleep));
  EXPECT_EQ(sleep.value().struct_size, sizeof(abut_sleep));
  EXPECT_EQ(sleep.value().steps, 10U);
  EXPECT_EQ(sleep.value().linear_speed, 0.14);
  EXPECT_EQ(sleep.value().linear_acceleration, 0.045);
  EXPECT_EQ(sleep.value().angular_speed, 0.03);
  EXPECT_EQ(sleep.value().angular_acceleration, 0.045);
}

TEST(PartSetSleep, RefusesNullUniverse) {
  const abut_sleep sleep = sleepy();
  const Scene scene;
  EXPECT_TRUE(refused(abut_part_set_sleep(nullptr, scene.part, &sleep), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(succeeded(abut_part_set_sleep(scene.universe, scene.part, nullptr))) << "never, as before";
  expect_nobody_sleeps(scene);
}

TEST(PartSetSleep, RefusesStaleIds) {
  const Scene scene;
  const abut_sleep sleep = sleepy();
  for (const abut_part_id stale : scene.stale_parts) {
    EXPECT_TRUE(refused(abut_part_set_sleep(scene.universe, stale, &sleep), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
    EXPECT_TRUE(refused(abut_part_set_sleep(scene.universe, stale, nullptr), ABUT_STALE_ID,
                        {"part", std::to_string(stale.slot)}));
  }
  expect_nobody_sleeps(scene);
}

constexpr std::array<std::pair<std::string_view, double abut_sleep::*>, 4> numbers{
    {{"linear_speed", &abut_sleep::linear_speed},
     {"linear_acceleration", &abut_sleep::linear_acceleration},
     {"angular_speed", &abut_sleep::angular_speed},
     {"angular_acceleration", &abut_sleep::angular_acceleration}}};

TEST(PartSetSleep, RefusesNonFiniteAndNegativeNumbers) {
  const Scene scene;
  for (const auto& [name, number] : numbers) {
    abut_sleep sleep = sleepy();
    expect_non_finite_refused("sleep." + std::string(name), [&](double bad) {
      sleep.*number = bad;
      return abut_part_set_sleep(scene.universe, scene.part, &sleep);
    });
    sleep.*number = -2.5;
    EXPECT_TRUE(refused(abut_part_set_sleep(scene.universe, scene.part, &sleep), ABUT_OUT_OF_RANGE,
                        {"sleep." + std::string(name), "-2.5"}));
  }
  expect_nobody_sleeps(scene);
}

TEST(PartSetSleep, RefusesNoStepsAtAll) {
  const Scene scene;
  abut_sleep sleep = sleepy();
  sleep.steps = 0;
  EXPECT_TRUE(
      refused(abut_part_set_sleep(scene.universe, scene.part, &sleep), ABUT_OUT_OF_RANGE, {"sleep.steps", "0", "1"}));
  expect_nobody_sleeps(scene);
}

TEST(PartSetSleep, RefusesWrongStructSize) {
  const Scene scene;
  expect_struct_size_checked(
      sleepy(), [&](const abut_sleep* wrong) { return abut_part_set_sleep(scene.universe, scene.part, wrong); });
  expect_nobody_sleeps(scene);
  expect_zero_tail_accepted(
      sleepy(), [&](const abut_sleep* later) { return abut_part_set_sleep(scene.universe, scene.part, later); });
}

TEST(PartsSetSleep, RefusesNullPointers) {
  const Scene scene;
  const abut_sleep sleep = sleepy();
  EXPECT_TRUE(refused(abut_parts_set_sleep(nullptr, &scene.part, &sleep, 1), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_parts_set_sleep(scene.universe, nullptr, &sleep, 1), ABUT_NULL_ARGUMENT, {"parts", "null"}));
  EXPECT_TRUE(succeeded(abut_parts_set_sleep(scene.universe, &scene.part, nullptr, 1))) << "never, as before";
  EXPECT_TRUE(succeeded(abut_parts_set_sleep(scene.universe, nullptr, nullptr, 0)));
  expect_nobody_sleeps(scene);
}

TEST(PartsSetSleep, RefusesOverflowingCounts) {
  const Scene scene;
  const abut_sleep sleep = sleepy();
  expect_overflow_refused(sizeof(abut_part_id), "count", [&](std::size_t count) {
    return abut_parts_set_sleep(scene.universe, &scene.part, &sleep, count);
  });
  expect_nobody_sleeps(scene);
}

TEST(PartsSetSleep, RefusesStaleIdsAndSetsNone) {
  const Scene scene;
  const std::array<abut_sleep, 2> sleeps{sleepy(), sleepy()};
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_set_sleep(scene.universe, parts.data(), sleeps.data(), 2), ABUT_STALE_ID,
                        {"parts", "1", std::to_string(stale.slot)}));
  }
  expect_nobody_sleeps(scene);
}

TEST(PartsSetSleep, RefusesNonFiniteNumbersAndSetsNone) {
  const Scene scene;
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  for (const auto& [name, number] : numbers) {
    expect_non_finite_refused("sleeps[1]." + std::string(name), [&](double bad) {
      std::array<abut_sleep, 2> sleeps{sleepy(), sleepy()};
      sleeps[1].*number = bad;
      return abut_parts_set_sleep(scene.universe, parts.data(), sleeps.data(), 2);
    });
  }
  expect_nobody_sleeps(scene);
}

TEST(PartsSetSleep, RefusesWrongStructSize) {
  const Scene scene;
  expect_struct_size_checked(
      sleepy(), [&](const abut_sleep* wrong) { return abut_parts_set_sleep(scene.universe, &scene.part, wrong, 1); });
  const std::array<abut_part_id, 2> parts{scene.part, scene.second_part};
  std::array<abut_sleep, 2> sleeps{sleepy(), sleepy()};
  sleeps[1].struct_size = 0;
  EXPECT_TRUE(refused(abut_parts_set_sleep(scene.universe, parts.data(), sleeps.data(), 2), ABUT_WRONG_STRUCT_SIZE,
                      {"sleeps[1]", "0"}));
  expect_nobody_sleeps(scene);
}

TEST(PartsWake, RefusesStaleIdsAndWakesNone) {
  const Scene scene;
  const abut_sleep sleep = sleepy();
  const std::array<abut_part_id, 2> both{scene.part, scene.second_part};
  const std::array<abut_sleep, 2> sleeps{sleep, sleep};
  ASSERT_TRUE(succeeded(abut_parts_set_sleep(scene.universe, both.data(), sleeps.data(), 2)));
  for (int step = 0; step < 3; ++step) {
    ASSERT_TRUE(succeeded(abut_universe_step(scene.universe, 0.01)));
  }
  ASSERT_EQ(scene.universe.stats().asleep, 2U);
  for (const abut_part_id stale : scene.stale_parts) {
    const std::array<abut_part_id, 2> parts{scene.part, stale};
    EXPECT_TRUE(refused(abut_parts_wake(scene.universe, parts.data(), 2), ABUT_STALE_ID,
                        {"parts", "1", std::to_string(stale.slot)}));
  }
  ASSERT_TRUE(succeeded(abut_universe_step(scene.universe, 0.01)));
  EXPECT_EQ(scene.universe.stats().asleep, 2U);
}

}  // namespace
