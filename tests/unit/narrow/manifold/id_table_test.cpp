// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>

import abut.narrow.manifold.by_depth;

namespace {

TEST(IdTable, WithoutIdsHasNone) {
  const abut::IdTable<int> table(0);
  EXPECT_FALSE(table.has(0));
  EXPECT_FALSE(table.has(7));
}

TEST(IdTable, KeepsTheFirstValueOfEachId) {
  abut::IdTable<int> table(2);
  EXPECT_FALSE(table.has(0));
  EXPECT_EQ(table.find_or_add(0, 5), 5);
  EXPECT_EQ(table.find_or_add(0, 6), 5);
  EXPECT_EQ(table.find_or_add(9, 7), 7);
  EXPECT_TRUE(table.has(0) && table.has(9));
  EXPECT_FALSE(table.has(1));
  table.find_or_add(0, 0) = 8;
  EXPECT_EQ(table.find_or_add(0, 0), 8);
}

// Ids that lead to the same places, and as many as there may be.
TEST(IdTable, IsLikeAMapHoweverFull) {
  std::mt19937_64 random(31);
  for (std::size_t most = 1; most < 600; most += 7) {
    abut::IdTable<std::size_t> table(most);
    std::map<std::uint64_t, std::size_t> expected;
    for (std::size_t i = 0; i < most; ++i) {
      const std::uint64_t id = most % 2 == 0 ? random() % most : (random() % most) << 60 | (i % 3);
      const std::size_t known = expected.emplace(id, i).first->second;
      ASSERT_EQ(table.find_or_add(id, i), known);
    }
    for (std::uint64_t id = 0; id < 2 * most; ++id) {
      ASSERT_EQ(table.has(id), expected.contains(id));
    }
  }
}

}  // namespace
