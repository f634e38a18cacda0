// SPDX-License-Identifier: Apache-2.0
#include "rule_book.hpp"

#include <algorithm>

namespace cli {

RuleBook::RuleBook(const World& world) : world_(&world) {
  for (const Rule& rule : world.scene().rules) {
    paths_[sides_of(world.collidable(rule.a), world.collidable(rule.b))] = rule.path;
  }
}

RuleBook::Sides RuleBook::sides_of(const abut_collidable& a, const abut_collidable& b) {
  return std::minmax(Side{a.kind, a.slot, a.generation}, Side{b.kind, b.slot, b.generation});
}

Verdict RuleBook::verdict(std::size_t a, std::size_t b) const {
  abut_rule rule = ABUT_RULE_NONE;
  abut_collidable of_a{}, of_b{};
  check(abut_rule_between(world_->universe(), world_->id_of(a), world_->id_of(b), &rule, &of_a, &of_b),
        "cannot ask for a rule");
  return {rule, rule == ABUT_RULE_NONE ? "" : paths_.at(sides_of(of_a, of_b))};
}

}  // namespace cli
