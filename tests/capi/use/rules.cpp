// SPDX-License-Identifier: Apache-2.0
// Who meets whom: rules at every level, layers and masks, exclusion bits. VX-04 and CM-04 of the specification.
#include "bad_values.hpp"

#include <map>
#include <random>
#include <set>

namespace {

using namespace abut_test;

constexpr std::uint32_t kind_count = 4;

// A ball and what rules may call it, by kind.
struct Ball {
  abut_geometry_id geometry{};
  abut_part_id part{};
  std::uint32_t label = 0;

  abut_collidable named(abut_collidable_kind kind) const {
    switch (kind) {
      case ABUT_COLLIDABLE_GEOMETRY: return {kind, geometry.slot, geometry.generation};
      case ABUT_COLLIDABLE_PART: return {kind, part.slot, part.generation};
      case ABUT_COLLIDABLE_LABEL: return {kind, label, 0};
      default: return anything;
    }
  }
};

bool is_equal(const abut_collidable& x, const abut_collidable& y) {
  return x.kind == y.kind && x.slot == y.slot && x.generation == y.generation;
}

// Balls that all overlap.
struct Crowd {
  Ball add(std::uint32_t label, const Ball* beside = nullptr) {
    abut_geometry_options options = default_geometry_options();
    options.label = label;
    const abut_part_id part = beside != nullptr ? beside->part : universe.add_part(identity);
    return {universe.add_geometry(part, ball, options), part, label};
  }
  void set(const abut_collidable& a, const abut_collidable& b, abut_rule rule) {
    EXPECT_TRUE(succeeded(abut_rule_set(universe, &a, &b, rule)));
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> step() {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const abut_contact& contact : universe.step())
      pairs.insert({contact.geometry_a.slot, contact.geometry_b.slot});
    return pairs;
  }

  Universe universe;
  Shape ball = make_sphere(1.0);
};

struct Level {
  abut_collidable_kind a, b;
};

// All combinations of kinds for the two sides.
std::vector<Level> levels() {
  std::vector<Level> all;
  for (abut_collidable_kind a = 0; a < kind_count; ++a) {
    for (abut_collidable_kind b = 0; b < kind_count; ++b) all.push_back({a, b});
  }
  return all;
}

TEST(Rules, DisableAndEnableAtEveryLevelInBothOrders) {
  for (const Level level : levels()) {
    for (const bool is_swapped : {false, true}) {
      Crowd crowd;
      const Ball first = crowd.add(1), second = crowd.add(2);
      const abut_collidable a = first.named(level.a), b = second.named(level.b);
      const auto set = [&](abut_rule rule) { is_swapped ? crowd.set(b, a, rule) : crowd.set(a, b, rule); };
      SCOPED_TRACE("kinds " + std::to_string(level.a) + " and " + std::to_string(level.b));
      EXPECT_EQ(crowd.step().size(), 1U) << "without a rule pairs meet";
      set(ABUT_RULE_DISABLE);
      EXPECT_EQ(crowd.step().size(), 0U);
      EXPECT_EQ(crowd.universe.stats().filtered_pairs, 1U);
      ASSERT_EQ(crowd.universe.events().size(), 1U) << "a rule at run time ends what it parts";
      EXPECT_EQ(crowd.universe.events().at(0).kind, abut_event_kind{ABUT_EVENT_END});
      set(ABUT_RULE_ENABLE);
      EXPECT_EQ(crowd.step().size(), 1U) << "the rule for the same two is replaced";
      EXPECT_EQ(crowd.universe.events().at(0).kind, abut_event_kind{ABUT_EVENT_BEGIN});
      set(ABUT_RULE_DISABLE);
      set(ABUT_RULE_NONE);
      EXPECT_EQ(crowd.step().size(), 1U);
      EXPECT_EQ(crowd.universe.events().at(0).kind, abut_event_kind{ABUT_EVENT_PERSIST});
    }
  }
}

// First the more specific side decides, then the other one.
std::pair<std::uint32_t, std::uint32_t> rank_of(const Level& level) { return std::minmax(level.a, level.b); }

TEST(Rules, TheMostSpecificOneCounts) {
  for (const Level one : levels()) {
    for (const Level other : levels()) {
      const bool is_same = one.a == other.a && one.b == other.b;
      if (is_same) continue;
      for (const bool disables : {false, true}) {
        Crowd crowd;
        const Ball first = crowd.add(1), second = crowd.add(2);
        crowd.set(first.named(one.a), second.named(one.b), disables ? ABUT_RULE_DISABLE : ABUT_RULE_ENABLE);
        crowd.set(second.named(other.b), first.named(other.a), disables ? ABUT_RULE_ENABLE : ABUT_RULE_DISABLE);
        const auto rank = rank_of(one), rank_of_other = rank_of(other);
        const bool is_parted = rank == rank_of_other || (rank < rank_of_other) == disables;
        EXPECT_EQ(crowd.step().size(), is_parted ? 0U : 1U)
            << "kinds " << one.a << ", " << one.b << " against " << other.a << ", " << other.b;
      }
    }
  }
}

struct Known {
  abut_collidable a, b;
  abut_rule rule;
};

// What the rules in a list say about two balls.
bool may_meet(const std::vector<Known>& rules, const Ball& x, const Ball& y) {
  std::pair best{kind_count, kind_count};
  bool meets = true;
  for (const Known& known : rules) {
    const bool fits = (is_equal(known.a, x.named(known.a.kind)) && is_equal(known.b, y.named(known.b.kind))) ||
                      (is_equal(known.a, y.named(known.a.kind)) && is_equal(known.b, x.named(known.b.kind)));
    const auto rank = rank_of({known.a.kind, known.b.kind});
    if (!fits || rank > best) continue;
    meets = known.rule == ABUT_RULE_ENABLE && (rank < best || meets);
    best = rank;
  }
  return meets;
}

// That the rule which the universe names is in the list, says what the list says of the two, and names each.
void expect_rule_of_list(const abut_universe* universe, const std::vector<Known>& rules, const Ball& x, const Ball& y) {
  Known found{};
  ASSERT_TRUE(succeeded(abut_rule_between(universe, x.geometry, y.geometry, &found.rule, &found.a, &found.b)));
  EXPECT_EQ(found.rule != ABUT_RULE_DISABLE, may_meet(rules, x, y));
  if (found.rule == ABUT_RULE_NONE) {
    EXPECT_TRUE(is_equal(found.a, anything) && is_equal(found.b, anything));
    return;
  }
  EXPECT_TRUE(is_equal(found.a, x.named(found.a.kind)) && is_equal(found.b, y.named(found.b.kind)));
  EXPECT_TRUE(std::any_of(rules.begin(), rules.end(), [&](const Known& known) {
    return known.rule == found.rule && ((is_equal(known.a, found.a) && is_equal(known.b, found.b)) ||
                                        (is_equal(known.a, found.b) && is_equal(known.b, found.a)));
  }));
}

TEST(Rules, ManyOfThemAreThoseOfAModel) {
  Crowd crowd;
  std::vector<Ball> balls;
  for (std::uint32_t i = 0; i < 4; ++i) {
    balls.push_back(crowd.add(i % 3));
    balls.push_back(crowd.add((i + 1) % 3, &balls.back()));
  }
  std::vector<Known> rules;
  std::mt19937 random(20250115);
  const auto pick = [&] {
    return balls.at(random() % balls.size()).named(static_cast<abut_collidable_kind>(random() % kind_count));
  };
  std::size_t parted = 0;
  for (int round = 0; round < 500; ++round) {
    const Known known{pick(), pick(), static_cast<abut_rule>(random() % 3)};
    crowd.set(known.a, known.b, known.rule);
    std::erase_if(rules, [&](const Known& old) {
      return (is_equal(old.a, known.a) && is_equal(old.b, known.b)) ||
             (is_equal(old.a, known.b) && is_equal(old.b, known.a));
    });
    if (known.rule != ABUT_RULE_NONE) rules.push_back(known);
    std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (const Ball& x : balls) {
      for (const Ball& y : balls) {
        expect_rule_of_list(crowd.universe, rules, x, y);
        if (x.geometry.slot >= y.geometry.slot || x.part == y.part) continue;
        if (may_meet(rules, x, y)) {
          expected.insert({x.geometry.slot, y.geometry.slot});
        } else {
          ++parted;
        }
      }
    }
    ASSERT_EQ(crowd.step(), expected) << "round " << round;
    if (round % 100 == 99) {
      ASSERT_TRUE(succeeded(abut_rules_clear(crowd.universe)));
      rules.clear();
    }
  }
  EXPECT_GT(parted, 1000U);
}

TEST(Rules, EndWithWhatTheyName) {
  Crowd crowd;
  const Ball first = crowd.add(1), second = crowd.add(2);
  crowd.set(first.named(ABUT_COLLIDABLE_GEOMETRY), second.named(ABUT_COLLIDABLE_PART), ABUT_RULE_DISABLE);
  EXPECT_EQ(crowd.step().size(), 0U);
  ASSERT_TRUE(succeeded(abut_geometry_destroy(crowd.universe, first.geometry)));
  const Ball third = crowd.add(1, &first);
  ASSERT_EQ(third.geometry.slot, first.geometry.slot) << "the slot is used again";
  EXPECT_EQ(crowd.step().size(), 1U);
  crowd.set(third.named(ABUT_COLLIDABLE_LABEL), second.named(ABUT_COLLIDABLE_PART), ABUT_RULE_DISABLE);
  EXPECT_EQ(crowd.step().size(), 0U);
  ASSERT_TRUE(succeeded(abut_part_destroy(crowd.universe, second.part)));
  const Ball fourth = crowd.add(2);
  ASSERT_EQ(fourth.part.slot, second.part.slot) << "the slot is used again";
  EXPECT_EQ(crowd.step().size(), 1U);
}

TEST(Rules, OfALabelFollowTheLabel) {
  Crowd crowd;
  const Ball first = crowd.add(1);
  crowd.add(2);
  crowd.set({ABUT_COLLIDABLE_LABEL, 1, 0}, {ABUT_COLLIDABLE_LABEL, 2, 0}, ABUT_RULE_DISABLE);
  EXPECT_EQ(crowd.step().size(), 0U);
  abut_geometry_options options = default_geometry_options();
  options.label = 7;
  ASSERT_TRUE(succeeded(abut_geometry_set_options(crowd.universe, first.geometry, &options)));
  EXPECT_EQ(crowd.step().size(), 1U);
}

// The bits of two geometries that overlap, and whether they meet.
bool meet(const abut_geometry_options& a, const abut_geometry_options& b, abut_broadphase broadphase) {
  abut_universe_options options = default_universe_options();
  options.broadphase = broadphase;
  Universe universe(&options);
  const Shape ball = make_sphere(1.0);
  universe.add_geometry(universe.add_part(identity), ball, a);
  universe.add_geometry(universe.add_part(at(0.5, 0, 0)), ball, b);
  return !universe.step().empty();
}

// Layers and masks of one bit and of the highest one, each present or not: both ways have to fit.
TEST(Filtering, LayersAndMasksHaveToFitBothWays) {
  for (const std::uint64_t bit : {std::uint64_t{1}, std::uint64_t{1} << 63U}) {
    for (std::uint32_t row = 0; row < 16; ++row) {
      abut_geometry_options a = default_geometry_options(), b = a;
      a.layers = (row & 1U) != 0 ? bit : 0;
      a.mask = (row & 2U) != 0 ? bit : 0;
      b.layers = (row & 4U) != 0 ? bit : 0;
      b.mask = (row & 8U) != 0 ? bit : 0;
      for (const abut_broadphase broadphase : broadphases)
        EXPECT_EQ(meet(a, b, broadphase), row == 15) << "row " << row;
    }
  }
}

// Two bits on either side: a common one keeps the two apart, whoever has it.
TEST(Filtering, ACommonExclusionBitKeepsApart) {
  for (std::uint32_t row = 0; row < 16; ++row) {
    abut_geometry_options a = default_geometry_options(), b = a;
    a.exclusion = (std::uint64_t{row & 3U}) << 62U;
    b.exclusion = (std::uint64_t{row >> 2U}) << 62U;
    const bool is_common = (row & 3U & (row >> 2U)) != 0;
    for (const abut_broadphase broadphase : broadphases) EXPECT_EQ(meet(a, b, broadphase), !is_common) << "row " << row;
  }
}

TEST(Filtering, MotionsCanChange) {
  Crowd crowd;
  const Ball first = crowd.add(0), second = crowd.add(0);
  EXPECT_EQ(crowd.step().size(), 1U);
  const std::array<abut_part_id, 2> parts{first.part, second.part};
  for (const auto& [motions, expected] : std::initializer_list<std::pair<std::array<abut_motion, 2>, std::size_t>>{
           {{ABUT_MOTION_STATIC, ABUT_MOTION_ANIMATED}, 0},
           {{ABUT_MOTION_STATIC, ABUT_MOTION_DYNAMIC}, 1},
           {{ABUT_MOTION_STATIC, ABUT_MOTION_STATIC}, 0},
           {{ABUT_MOTION_DYNAMIC, ABUT_MOTION_STATIC}, 1},
           {{ABUT_MOTION_ANIMATED, ABUT_MOTION_ANIMATED}, 0},
           {{ABUT_MOTION_DYNAMIC, ABUT_MOTION_DYNAMIC}, 1}}) {
    ASSERT_TRUE(succeeded(abut_parts_set_motions(crowd.universe, parts.data(), motions.data(), 2)));
    EXPECT_EQ(crowd.step().size(), expected);
    EXPECT_EQ(crowd.universe.events().at(0).kind,
              expected == 1 ? abut_event_kind{ABUT_EVENT_BEGIN} : abut_event_kind{ABUT_EVENT_END});
    abut_motion motion = 9;
    ASSERT_TRUE(succeeded(abut_part_motion(crowd.universe, second.part, &motion)));
    EXPECT_EQ(motion, motions.at(1));
  }
}

}  // namespace
