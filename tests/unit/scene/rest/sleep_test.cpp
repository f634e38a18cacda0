// SPDX-License-Identifier: Apache-2.0
// The table of sleeping parts, without a universe around it.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

import abut.math;
import abut.detect.lists.islands;
import abut.scene.state.options;
import abut.scene.rest.sleep;

namespace {

using namespace abut;

// Parts by their slots, whose touches a test makes up.
class Bench {
 public:
  void add(std::uint32_t slot, const Sleep& sleep = {}) { table.set({slot, 1}, true, sleep); }
  void touch(std::uint32_t a, std::uint32_t b) {
    touches.emplace_back(SleepTable::Side{a, true}, SleepTable::Side{b, true});
  }
  void stand(std::uint32_t part, std::uint32_t ground) {
    touches.emplace_back(SleepTable::Side{part, true}, SleepTable::Side{ground, false});
  }
  // Slots that fell asleep with a plus, those that woke with a minus.
  std::string step(Real dt = 0.1) {
    if (dt > 0) {
      table.measure(dt, [&](PartId part) -> const Placement& { return placements[part.slot]; });
    }
    links.start(100);
    for (const auto& [a, b] : touches) {
      table.touch(a, b);
      if (a.is_dynamic && b.is_dynamic) {
        links.join(a.slot, b.slot);
      }
    }
    for (const std::uint32_t slot : std::exchange(unsettled, {})) {
      table.unsettle(slot);
    }
    table.settle(dt > 0, links.lowest_slots());
    std::string changes;
    for (const SleepChange& change : table.changes()) {
      EXPECT_EQ(table.is_asleep(change.part.slot), change.is_asleep);
      changes += (change.is_asleep ? '+' : '-') + std::to_string(change.part.slot);
    }
    return changes;
  }
  std::string steps(int count) {
    std::string changes;
    for (int i = 0; i < count; ++i) {
      changes += step() + ".";
    }
    return changes;
  }

  SleepTable table;
  IslandLinks links;
  std::map<std::uint32_t, Placement> placements;
  std::vector<std::pair<SleepTable::Side, SleepTable::Side>> touches;
  std::vector<std::uint32_t> unsettled;
};

TEST(SleepTable, IsUnusedUntilAPartIsSet) {
  Bench bench;
  EXPECT_FALSE(bench.table.is_used());
  EXPECT_EQ(bench.table.bytes(), 0U);
  bench.table.set({3, 1}, true, std::nullopt);
  bench.table.wake(3);
  bench.table.forget(3);
  EXPECT_FALSE(bench.table.is_used());
  bench.add(3);
  EXPECT_TRUE(bench.table.is_used());
  EXPECT_FALSE(bench.table.is_asleep(3));
  EXPECT_FALSE(bench.table.is_asleep(300));
  bench.table.set({3, 1}, true, std::nullopt);
  EXPECT_FALSE(bench.table.is_used());
}

TEST(SleepTable, CountsCalmStepsFromTheThirdOn) {
  Bench bench;
  bench.add(5, {.steps = 1});
  bench.add(2, {.steps = 4});
  bench.add(9, {.steps = 1});
  EXPECT_EQ(bench.steps(7), "..+5+9...+2..");
  EXPECT_EQ(bench.table.asleep_count(), 3U);
}

TEST(SleepTable, IslandsWaitForTheSlowest) {
  Bench bench;
  bench.add(1, {.steps = 1});
  bench.add(2, {.steps = 3});
  bench.add(3, {.steps = 2});
  bench.add(4, {.steps = 2});
  bench.touch(3, 2);
  bench.touch(2, 1);
  EXPECT_EQ(bench.steps(6), "...+4.+1+2+3..");
}

// Found in whatever order, with one member at an end that moves for a while.
TEST(SleepTable, LongChainsAreOneIslandInAnyOrder) {
  for (const std::uint32_t stride : {1U, 7U, 29U, 56U}) {
    Bench bench;
    for (std::uint32_t i = 0; i < 58; ++i) {
      bench.add(1 + i, {.steps = 1});
    }
    for (std::uint32_t i = 0; i < 57; ++i) {
      const std::uint32_t link = 1 + i * stride % 57;
      bench.touch(link, link + 1);
    }
    for (int i = 0; i < 6; ++i) {
      bench.placements[58].position.x += 1;
      EXPECT_EQ(bench.step(), "");
    }
    EXPECT_EQ(bench.step(), "") << "it brakes";
    bench.step();
    EXPECT_EQ(bench.table.changes().size(), 58U);
    EXPECT_EQ(bench.table.asleep_count(), 58U);
  }
}

TEST(SleepTable, WakesWholeIslandsAndNoOthers) {
  Bench bench;
  for (const std::uint32_t slot : {1U, 2U, 3U, 4U}) {
    bench.add(slot, {.steps = 2});
  }
  bench.touch(1, 2);
  bench.touch(3, 4);
  EXPECT_EQ(bench.steps(4), "...+1+2+3+4.");
  bench.table.wake(2);
  EXPECT_TRUE(bench.table.is_asleep(2));
  EXPECT_EQ(bench.steps(4), "-1-2..+1+2..");
  bench.unsettled = {3};
  EXPECT_EQ(bench.steps(4), "-3-4..+3+4..");
}

TEST(SleepTable, TheGroundJoinsNobodyUnlessItMoves) {
  Bench bench;
  bench.add(1, {.steps = 1});
  bench.add(2, {.steps = 1});
  bench.stand(1, 8);
  bench.stand(2, 8);
  bench.stand(2, 9);
  EXPECT_EQ(bench.steps(3), "..+1+2.");
  bench.table.wake(1);
  EXPECT_EQ(bench.step(), "-1");
  EXPECT_EQ(bench.step(), "+1");
  bench.table.disturb({9, false});
  EXPECT_EQ(bench.step(0), "-2") << "also without time";
  EXPECT_EQ(bench.step(0), "");
  EXPECT_EQ(bench.step(), "") << "it has moved since the last step that took time";
  EXPECT_EQ(bench.step(), "+2");
}

TEST(SleepTable, DynamicPartsWithoutThresholdsKeepAwake) {
  Bench bench;
  bench.add(1, {.steps = 1});
  bench.touch(7, 1);
  EXPECT_EQ(bench.steps(9), ".........");
  bench.touches.clear();
  EXPECT_EQ(bench.step(), "+1");
  bench.touch(1, 7);
  EXPECT_EQ(bench.step(), "-1");
}

TEST(SleepTable, ATouchThatChangesOnlyPutsOff) {
  Bench bench;
  bench.add(1, {.steps = 5});
  EXPECT_EQ(bench.steps(6), "......");
  bench.unsettled = {1};
  EXPECT_EQ(bench.step(), "");
  EXPECT_EQ(bench.step(0), "") << "not without time";
  EXPECT_EQ(bench.step(), "+1");
}

TEST(SleepTable, WhatADetectionWithoutTimeSawCountsInTheNextStep) {
  Bench bench;
  bench.add(1, {.steps = 5});
  EXPECT_EQ(bench.steps(6), "......");
  bench.unsettled = {1};
  EXPECT_EQ(bench.step(0), "");
  EXPECT_EQ(bench.step(), "");
  EXPECT_EQ(bench.step(), "+1");
}

TEST(SleepTable, FallingAsleepAtSpeedIsNoAcceleration) {
  Bench bench;
  bench.add(1, {.steps = 2});
  for (int i = 0; i < 4; ++i) {
    bench.placements[1].position.x += 0.01;
    EXPECT_EQ(bench.step(), i == 3 ? "+1" : "");
  }
  EXPECT_EQ(bench.steps(3), "...");
  bench.table.wake(1);
  EXPECT_EQ(bench.steps(4), "-1..+1..") << "it has not braked either";
  bench.placements[1].position.x += 0.01;
  bench.table.disturb({1, true});
  for (int i = 0; i < 4; ++i) {
    bench.placements[1].position.x += 0.01;
    bench.step();
  }
  ASSERT_TRUE(bench.table.is_asleep(1));
  bench.unsettled = {1};
  EXPECT_EQ(bench.step(0), "-1");
  EXPECT_EQ(bench.steps(2), ".+1.") << "the first of two calm steps is the one that finds it standing";
}

TEST(SleepTable, OtherThresholdsWakeAndCountAnew) {
  Bench bench;
  bench.add(1, {.steps = 3});
  bench.add(1, {.steps = 3});
  EXPECT_EQ(bench.steps(5), "....+1.");
  bench.add(1, {.steps = 3});
  EXPECT_EQ(bench.step(), "");
  bench.add(1, {.steps = 2});
  EXPECT_EQ(bench.steps(4), "-1..+1..");
  bench.table.set({1, 1}, true, std::nullopt);
  EXPECT_EQ(bench.step(), "-1") << "a change that is told before the table forgets it";
  EXPECT_TRUE(bench.table.is_used());
  EXPECT_EQ(bench.step(), "");
  EXPECT_FALSE(bench.table.is_used());
}

TEST(SleepTable, WhatIsNotDynamicIsNotAsleep) {
  Bench bench;
  bench.add(1, {.steps = 1});
  EXPECT_EQ(bench.steps(3), "..+1.");
  bench.table.set_dynamic(1, false);
  EXPECT_EQ(bench.steps(5), "-1.....");
  bench.table.set_dynamic(1, true);
  EXPECT_EQ(bench.steps(2), ".+1.");
}

TEST(SleepTable, ForgettingKeepsTheOthersInPlace) {
  Bench bench;
  for (const std::uint32_t slot : {1U, 2U, 3U}) {
    bench.add(slot, {.steps = 1});
  }
  EXPECT_EQ(bench.steps(3), "..+1+2+3.");
  bench.table.forget(1);
  EXPECT_EQ(bench.table.asleep_count(), 2U);
  EXPECT_FALSE(bench.table.is_asleep(1));
  EXPECT_TRUE(bench.table.is_asleep(3));
  bench.table.wake(3);
  EXPECT_EQ(bench.step(), "-3");
  bench.add(1, {.steps = 1});
  EXPECT_EQ(bench.steps(3), "+3..+1.");
  for (const std::uint32_t slot : {1U, 2U, 3U}) {
    bench.table.wake(slot);
  }
  EXPECT_EQ(bench.step(), "-1-2-3") << "by slot";
}

TEST(Sleep, IsCheckedBeforeItIsTaken) {
  EXPECT_FALSE(check_sleep({}).has_value());
  EXPECT_FALSE(check_sleep({1, 0, 0, 0, 0}).has_value());
  EXPECT_TRUE(check_sleep({.steps = 0}).has_value());
  EXPECT_TRUE(check_sleep({.linear_speed = -1}).has_value());
  EXPECT_TRUE(check_sleep({.linear_acceleration = infinity}).has_value());
  EXPECT_TRUE(check_sleep({.angular_speed = -1}).has_value());
  EXPECT_TRUE(check_sleep({.angular_acceleration = -1}).has_value());
}

}  // namespace
