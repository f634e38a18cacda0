// SPDX-License-Identifier: Apache-2.0
// Rules and filters under bad input.
#include "bad_values.hpp"

namespace {

using namespace abut_test;

// Feeds a collidable to either side of a rule.
void expect_refused_on_both_sides(const Scene& scene, const abut_collidable& bad, abut_status status,
                                  std::initializer_list<std::string_view> words) {
  EXPECT_TRUE(refused(abut_rule_set(scene.universe, &bad, &anything, ABUT_RULE_DISABLE), status, words));
  EXPECT_TRUE(refused(abut_rule_set(scene.universe, &anything, &bad, ABUT_RULE_DISABLE), status, words));
}

// That no rule came to be: a step has the contacts that it had.
void expect_no_rules(Scene& scene) {
  EXPECT_TRUE(scene.is_unchanged());
  EXPECT_FALSE(scene.universe.step().empty());
}

TEST(RuleSet, RefusesNullPointers) {
  Scene scene;
  EXPECT_TRUE(refused(abut_rule_set(nullptr, &anything, &anything, ABUT_RULE_DISABLE), ABUT_NULL_ARGUMENT,
                      {"universe", "null"}));
  EXPECT_TRUE(
      refused(abut_rule_set(scene.universe, nullptr, &anything, ABUT_RULE_DISABLE), ABUT_NULL_ARGUMENT, {"a is null"}));
  EXPECT_TRUE(
      refused(abut_rule_set(scene.universe, &anything, nullptr, ABUT_RULE_DISABLE), ABUT_NULL_ARGUMENT, {"b is null"}));
  expect_no_rules(scene);
}

TEST(RuleSet, RefusesStaleIds) {
  Scene scene;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    expect_refused_on_both_sides(scene, {ABUT_COLLIDABLE_GEOMETRY, stale.slot, stale.generation}, ABUT_STALE_ID,
                                 {std::to_string(stale.slot)});
  }
  for (const abut_part_id stale : scene.stale_parts) {
    expect_refused_on_both_sides(scene, {ABUT_COLLIDABLE_PART, stale.slot, stale.generation}, ABUT_STALE_ID,
                                 {std::to_string(stale.slot)});
  }
  expect_no_rules(scene);
}

TEST(RuleSet, RefusesFieldsThatTheKindDoesNotUse) {
  Scene scene;
  expect_refused_on_both_sides(scene, {ABUT_COLLIDABLE_LABEL, 3, 31}, ABUT_INVALID_ARGUMENT, {"generation", "31"});
  expect_refused_on_both_sides(scene, {ABUT_COLLIDABLE_ANY, 31, 0}, ABUT_INVALID_ARGUMENT, {"slot", "31"});
  expect_refused_on_both_sides(scene, {ABUT_COLLIDABLE_ANY, 0, 31}, ABUT_INVALID_ARGUMENT, {"generation", "31"});
  expect_no_rules(scene);
}

TEST(RuleSet, RefusesUnknownValues) {
  Scene scene;
  for (const std::uint32_t value : {4U, 77U, 0xFFFFFFFFU}) {
    expect_refused_on_both_sides(scene, {value, 0, 0}, ABUT_UNKNOWN_VALUE, {"kind", std::to_string(value)});
  }
  for (const std::uint32_t value : {3U, 77U, 0xFFFFFFFFU}) {
    EXPECT_TRUE(refused(abut_rule_set(scene.universe, &anything, &anything, value), ABUT_UNKNOWN_VALUE,
                        {"rule", std::to_string(value)}));
  }
  expect_no_rules(scene);
}

TEST(RuleBetween, RefusesNullPointers) {
  const Scene scene;
  Out<abut_rule> rule;
  Out<abut_collidable> a, b;
  const auto ask = [&](const abut_universe* universe, abut_rule* to, abut_collidable* to_a, abut_collidable* to_b) {
    return abut_rule_between(universe, scene.geometry, scene.second_geometry, to, to_a, to_b);
  };
  EXPECT_TRUE(
      refused(ask(nullptr, rule.address(), a.address(), b.address()), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(ask(scene.universe, nullptr, a.address(), b.address()), ABUT_NULL_ARGUMENT, {"rule is null"}));
  EXPECT_TRUE(refused(ask(scene.universe, rule.address(), nullptr, b.address()), ABUT_NULL_ARGUMENT, {"a is null"}));
  EXPECT_TRUE(refused(ask(scene.universe, rule.address(), a.address(), nullptr), ABUT_NULL_ARGUMENT, {"b is null"}));
  EXPECT_TRUE(rule.is_untouched() && a.is_untouched() && b.is_untouched());
}

TEST(RuleBetween, RefusesStaleIds) {
  const Scene scene;
  Out<abut_rule> rule;
  Out<abut_collidable> a, b;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    EXPECT_TRUE(
        refused(abut_rule_between(scene.universe, stale, scene.geometry, rule.address(), a.address(), b.address()),
                ABUT_STALE_ID, {"geometry_a", std::to_string(stale.slot)}));
    EXPECT_TRUE(
        refused(abut_rule_between(scene.universe, scene.geometry, stale, rule.address(), a.address(), b.address()),
                ABUT_STALE_ID, {"geometry_b", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(rule.is_untouched() && a.is_untouched() && b.is_untouched());
}

TEST(UniverseWhyApart, RefusesNullPointers) {
  const Scene scene;
  Out<abut_apart_reasons> out;
  EXPECT_TRUE(refused(abut_universe_why_apart(nullptr, scene.geometry, scene.second_geometry, out.address()),
                      ABUT_NULL_ARGUMENT, {"universe", "null"}));
  EXPECT_TRUE(refused(abut_universe_why_apart(scene.universe, scene.geometry, scene.second_geometry, nullptr),
                      ABUT_NULL_ARGUMENT, {"out is null"}));
  EXPECT_TRUE(out.is_untouched());
}

TEST(UniverseWhyApart, RefusesStaleIds) {
  const Scene scene;
  Out<abut_apart_reasons> out;
  for (const abut_geometry_id stale : scene.stale_geometries) {
    EXPECT_TRUE(refused(abut_universe_why_apart(scene.universe, stale, scene.geometry, out.address()), ABUT_STALE_ID,
                        {"geometry_a", std::to_string(stale.slot)}));
    EXPECT_TRUE(refused(abut_universe_why_apart(scene.universe, scene.geometry, stale, out.address()), ABUT_STALE_ID,
                        {"geometry_b", std::to_string(stale.slot)}));
  }
  EXPECT_TRUE(out.is_untouched());
}

TEST(RuleSet, TakesAwayRulesThatAreNotThere) {
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_rule_set(scene.universe, &anything, &anything, ABUT_RULE_NONE)));
  EXPECT_TRUE(scene.is_unchanged());
}

TEST(RulesClear, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_rules_clear(nullptr), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

std::uint32_t keep(void*, const abut_universe*, abut_geometry_id, abut_geometry_id) { return 1; }

TEST(UniverseSetFilter, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_universe_set_filter(nullptr, keep, nullptr), ABUT_NULL_ARGUMENT, {"universe", "null"}));
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_universe_set_filter(scene.universe, nullptr, nullptr))) << "no filter";
}

std::uint32_t keep_by_pointers(void*, const abut_universe*, const abut_geometry_id*, const abut_geometry_id*) {
  return 1;
}

TEST(UniverseSetPointerFilter, RefusesNullUniverse) {
  EXPECT_TRUE(
      refused(abut_universe_set_pointer_filter(nullptr, keep_by_pointers, nullptr), ABUT_NULL_ARGUMENT, {"universe"}));
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_universe_set_pointer_filter(scene.universe, nullptr, nullptr))) << "no filter";
}

TEST(UniverseRefilter, RefusesNullUniverse) {
  EXPECT_TRUE(refused(abut_universe_refilter(nullptr), ABUT_NULL_ARGUMENT, {"universe", "null"}));
}

}  // namespace
