// SPDX-License-Identifier: Apache-2.0
// What a list of scratch keeps from call to call, and what it gives back.
#include <gtest/gtest.h>

#include <cstddef>

import abut.broadphase.kept.reused_list;

namespace {

using abut::ReusedList;

constexpr std::size_t much = 100'000, little = 10, calls_of_spell = 64;

void call(ReusedList<int>& list, std::size_t needed) {
  list.all.resize(needed);
  list.end_call();
}

TEST(ReusedList, IsEmptyAfterACallAndKeepsItsMemory) {
  ReusedList<int> list;
  call(list, much);
  EXPECT_TRUE(list.all.empty());
  EXPECT_EQ(list.bytes(), much * sizeof(int));
}

TEST(ReusedList, WhatOneCallNeededIsGivenBackAfterManyThatNeedLess) {
  ReusedList<int> list;
  call(list, much);
  for (std::size_t i = 0; i < 2 * calls_of_spell; ++i) {
    call(list, little);
  }
  EXPECT_EQ(list.bytes(), 2 * little * sizeof(int));
}

// Boxes that were put in together leave their larger boxes together: every dozen steps needs much.
TEST(ReusedList, CallsThatNeedMuchNowAndThenKeepTheirMemory) {
  ReusedList<int> list;
  for (std::size_t i = 0; i < 20 * calls_of_spell; ++i) {
    call(list, i % 13 == 0 ? much : little);
    ASSERT_EQ(list.bytes(), much * sizeof(int));
  }
}

TEST(ReusedList, LittleIsNotWorthGivingBack) {
  ReusedList<int> list;
  call(list, 1000);
  for (std::size_t i = 0; i < 4 * calls_of_spell; ++i) {
    call(list, 0);
  }
  EXPECT_EQ(list.bytes(), 1000 * sizeof(int));
}

}  // namespace
