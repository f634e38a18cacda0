// SPDX-License-Identifier: Apache-2.0
// Policies of pairs of tags.
#include <gtest/gtest.h>

#include <cstdint>

import abut.scene.state.options;
import abut.scene.meetings.policies;

namespace {

using namespace abut;

TEST(PolicyTable, HasTheDefaultEverywhereAtFirst) {
  const PolicyTable table;
  EXPECT_EQ(table.number_of(0, 63), 0U);
  EXPECT_EQ(table.of(5, 7), Policy{});
  EXPECT_EQ(table.size(), 1U);
  EXPECT_EQ(table.largest_tolerance(), 0);
}

TEST(PolicyTable, IsTheSameInBothOrders) {
  PolicyTable table;
  const Policy coarse{.detail = Detail::point, .period = 4, .tolerance = 0.5};
  table.set(3, 9, coarse);
  EXPECT_EQ(table.of(3, 9), coarse);
  EXPECT_EQ(table.of(9, 3), coarse);
  EXPECT_EQ(table.of(3, 3), Policy{});
  EXPECT_EQ(table.of(9, 9), Policy{});
  EXPECT_EQ(table.largest_tolerance(), 0.5);
}

TEST(PolicyTable, HoldsEachPolicyOnceAndDropsUnusedOnes) {
  PolicyTable table;
  const Policy box{.detail = Detail::box}, slow{.period = 10};
  table.set(1, 2, box);
  table.set(3, 4, box);
  table.set(5, 5, slow);
  EXPECT_EQ(table.size(), 3U);
  EXPECT_EQ(table.number_of(1, 2), table.number_of(4, 3));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    table.set(7, 8, {.period = 2 + i});
  }
  EXPECT_EQ(table.size(), 4U);
  table.set(7, 8, {});
  table.set(5, 5, {});
  EXPECT_EQ(table.size(), 2U);
  EXPECT_EQ(table.of(2, 1), box);
  EXPECT_EQ(table.of(5, 5), Policy{});
}

TEST(Policy, IsCheckedBeforeItIsTaken) {
  EXPECT_FALSE(check_policy({}).has_value());
  EXPECT_TRUE(check_policy({.period = 0}).has_value());
  EXPECT_TRUE(check_policy({.error_bound = -1}).has_value());
  EXPECT_TRUE(check_policy({.time_budget = -1}).has_value());
}

}  // namespace
