// SPDX-License-Identifier: Apache-2.0
// Which rule counts for a pair.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

import abut.scene.state.options;
import abut.scene.meetings.rules;

namespace {

using namespace abut;

RuleSide side(std::uint32_t geometry, std::uint32_t part, std::uint32_t label) {
  return {GeometryId{geometry, 7}, PartId{part, 9}, label};
}
Collidable geometry(std::uint32_t slot) { return {CollidableKind::geometry, slot, 7}; }
Collidable part(std::uint32_t slot) { return {CollidableKind::part, slot, 9}; }
Collidable label(std::uint32_t value) { return {CollidableKind::label, value, 0}; }
Collidable any() { return {}; }

TEST(Rules, PairsMeetWithoutAny) {
  const Rules rules;
  EXPECT_TRUE(rules.is_empty());
  EXPECT_TRUE(rules.allows(side(1, 1, 1), side(2, 2, 2)));
}

TEST(Rules, CountInBothOrders) {
  const std::array kinds{geometry(1), part(1), label(1), any()};
  const std::array others{geometry(2), part(2), label(2), any()};
  for (const Collidable& a : kinds) {
    for (const Collidable& b : others) {
      Rules rules;
      rules.set(b, a, Rule::disable);
      EXPECT_FALSE(rules.allows(side(1, 1, 1), side(2, 2, 2)));
      EXPECT_FALSE(rules.allows(side(2, 2, 2), side(1, 1, 1)));
      rules.set(a, b, Rule::none);
      EXPECT_TRUE(rules.is_empty());
      EXPECT_TRUE(rules.allows(side(1, 1, 1), side(2, 2, 2)));
    }
  }
}

TEST(Rules, LeaveOtherPairsAlone) {
  Rules rules;
  rules.set(geometry(1), part(2), Rule::disable);
  EXPECT_FALSE(rules.allows(side(1, 5, 0), side(8, 2, 0)));
  EXPECT_TRUE(rules.allows(side(3, 5, 0), side(8, 2, 0)));
  EXPECT_TRUE(rules.allows(side(1, 5, 0), side(8, 3, 0)));
  EXPECT_TRUE(rules.allows({GeometryId{1, 8}, PartId{5, 9}, 0}, side(8, 2, 0)))
      << "another generation is another geometry";
}

TEST(Rules, OfTwoAlikeTheOneThatDisablesWins) {
  Rules rules;
  rules.set(geometry(1), part(2), Rule::enable);
  rules.set(geometry(2), part(1), Rule::disable);
  EXPECT_FALSE(rules.allows(side(1, 1, 0), side(2, 2, 0)));
  EXPECT_FALSE(rules.allows(side(2, 2, 0), side(1, 1, 0)));
}

TEST(Rules, EndWithWhatTheySpeakOf) {
  Rules rules;
  rules.set(geometry(1), any(), Rule::disable);
  rules.set(part(1), geometry(2), Rule::disable);
  rules.set(label(1), label(1), Rule::disable);
  rules.forget(geometry(1));
  EXPECT_EQ(rules.size(), 2U);
  EXPECT_TRUE(rules.allows(side(1, 4, 0), side(5, 5, 0)));
  rules.forget(part(1));
  EXPECT_EQ(rules.size(), 1U);
  EXPECT_FALSE(rules.allows(side(1, 1, 1), side(2, 2, 1)));
  rules.clear();
  EXPECT_TRUE(rules.allows(side(1, 1, 1), side(2, 2, 1)));
}

// All rules of a list that fit, and the first of them by the order that the documentation gives.
bool allows_by_the_list(const std::vector<std::tuple<Collidable, Collidable, Rule>>& list, const RuleSide& a,
                        const RuleSide& b) {
  const auto fits = [](const Collidable& c, const RuleSide& its) {
    switch (c.kind) {
      case CollidableKind::geometry: return c.slot == its.geometry.slot && c.generation == its.geometry.generation;
      case CollidableKind::part: return c.slot == its.part.slot && c.generation == its.part.generation;
      case CollidableKind::label: return c.slot == its.label;
      case CollidableKind::any: return true;
    }
    return false;
  };
  std::optional<std::pair<std::pair<int, int>, Rule>> best;
  for (const auto& [first, second, rule] : list) {
    if ((fits(first, a) && fits(second, b)) || (fits(first, b) && fits(second, a))) {
      const int one = static_cast<int>(first.kind), other = static_cast<int>(second.kind);
      const std::pair<int, int> place(std::min(one, other), std::max(one, other));
      if (!best || place < best->first || (place == best->first && rule == Rule::disable)) {
        best = {place, rule};
      }
    }
  }
  return !best || best->second == Rule::enable;
}

TEST(Rules, TheMostSpecificOneCounts) {
  constexpr unsigned seed = 4;
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
  const auto some = [&] {
    switch (below(4)) {
      case 0: return geometry(1 + below(3));
      case 1: return part(1 + below(3));
      case 2: return label(below(3));
      default: return any();
    }
  };
  std::size_t disabled = 0, enabled = 0;
  for (int round = 0; round < 3000; ++round) {
    Rules rules;
    std::vector<std::tuple<Collidable, Collidable, Rule>> list;
    for (std::uint32_t i = 0; i < 1 + below(6); ++i) {
      const Collidable a = some(), b = some();
      const Rule rule = below(2) == 0 ? Rule::enable : Rule::disable;
      const auto is_same = [&](const auto& entry) {
        Rules probe;
        probe.set(std::get<0>(entry), std::get<1>(entry), Rule::disable);
        probe.set(a, b, Rule::none);
        return probe.is_empty();
      };
      std::erase_if(list, is_same);
      list.emplace_back(a, b, rule);
      rules.set(a, b, rule);
    }
    ASSERT_EQ(rules.size(), list.size());
    const RuleSide a = side(1 + below(3), 1 + below(3), below(3)), b = side(1 + below(3), 1 + below(3), below(3));
    const bool expected = allows_by_the_list(list, a, b);
    (expected ? enabled : disabled) += 1;
    ASSERT_EQ(rules.allows(a, b), expected) << "seed " << seed << ", round " << round;
    ASSERT_EQ(rules.allows(b, a), expected) << "seed " << seed << ", round " << round;
  }
  EXPECT_GT(enabled, 500U);
  EXPECT_GT(disabled, 500U);
}

}  // namespace
