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

TEST(RuleSet, TakesAwayRulesThatAreNotThere) {
  const Scene scene;
  EXPECT_TRUE(succeeded(abut_rule_set(scene.universe, &anything, &anything, ABUT_RULE_NONE)));
  EXPECT_TRUE(scene.is_unchanged());
}

}  // namespace
