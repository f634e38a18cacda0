// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstddef>

import abut.broadphase;

namespace {

using abut::BroadphaseKind;
using abut::choose_broadphase;

TEST(AutomaticBroadphase, FewBoxesAreTriedAgainstEachOther) {
  EXPECT_EQ(choose_broadphase({0, 0}, BroadphaseKind::automatic).kind, BroadphaseKind::brute);
  EXPECT_EQ(choose_broadphase({30, 30}, BroadphaseKind::tree).kind, BroadphaseKind::brute);
}

TEST(AutomaticBroadphase, ManyOrMostlyStillBoxesHaveATree) {
  EXPECT_EQ(choose_broadphase({100, 100}, BroadphaseKind::automatic).kind, BroadphaseKind::brute);
  EXPECT_EQ(choose_broadphase({100, 10}, BroadphaseKind::automatic).kind, BroadphaseKind::tree);
  EXPECT_EQ(choose_broadphase({1000, 1000}, BroadphaseKind::brute).kind, BroadphaseKind::tree);
  EXPECT_EQ(choose_broadphase({std::size_t{1} << 40, std::size_t{1} << 40}, BroadphaseKind::brute).kind,
            BroadphaseKind::tree);
}

// Wherever the border is, one box more or less does not move the choice to and fro.
TEST(AutomaticBroadphase, ABorderIsCrossedOnceEachWay) {
  for (const std::size_t still : {0u, 1u, 2u, 9u}) {
    for (const BroadphaseKind start : {BroadphaseKind::brute, BroadphaseKind::tree}) {
      BroadphaseKind kind = start;
      std::size_t changes = 0;
      const auto step = [&](std::size_t moving) {
        const abut::BroadphaseChoice choice = choose_broadphase({moving * (1 + still), moving}, kind);
        EXPECT_FALSE(abut::text_of(choice.reason).empty());
        changes += choice.kind != kind ? 1 : 0;
        kind = choice.kind;
      };
      for (std::size_t moving = 3; moving < 2000; ++moving) {
        step(moving);
        step(moving - 1);
        step(moving);
      }
      EXPECT_LE(changes, 2u);
      EXPECT_EQ(kind, BroadphaseKind::tree);
    }
  }
}

}  // namespace
