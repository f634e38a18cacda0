// SPDX-License-Identifier: Apache-2.0
#include "rule_book.hpp"

#include <algorithm>

namespace cli {

RuleBook::RuleBook(const Scene& scene) {
  for (const Rule& rule : scene.rules) {
    const Side a{rule.a.kind, rule.a.index}, b{rule.b.kind, rule.b.index};
    verdicts_[std::minmax(a, b)] = {rule.rule, rule.path};
  }
}

// The most specific one first: the kinds are numbered that way.
std::array<RuleBook::Side, 4> RuleBook::sides_of(const Scene& scene, std::size_t geometry) {
  static_assert(ABUT_COLLIDABLE_GEOMETRY < ABUT_COLLIDABLE_PART && ABUT_COLLIDABLE_PART < ABUT_COLLIDABLE_LABEL &&
                ABUT_COLLIDABLE_LABEL < ABUT_COLLIDABLE_ANY);
  const Geometry& its = scene.geometries[geometry];
  return {{{ABUT_COLLIDABLE_GEOMETRY, geometry},
           {ABUT_COLLIDABLE_PART, its.part},
           {ABUT_COLLIDABLE_LABEL, its.options.label},
           {ABUT_COLLIDABLE_ANY, 0}}};
}

std::optional<RuleBook::Verdict> RuleBook::verdict(const Scene& scene, std::size_t a, std::size_t b) const {
  std::optional<Verdict> found;
  std::pair<abut_collidable_kind, abut_collidable_kind> rank;  // the more specific side first
  for (const Side& one : sides_of(scene, a)) {
    for (const Side& other : sides_of(scene, b)) {
      const auto [lesser, greater] = std::minmax(one, other);
      const auto its = verdicts_.find({lesser, greater});
      if (its == verdicts_.end()) {
        continue;
      }
      const std::pair its_rank(lesser.first, greater.first);
      const bool wins = !found || its_rank < rank || (its_rank == rank && its->second.rule == ABUT_RULE_DISABLE);
      if (wins) {
        found = its->second;
        rank = its_rank;
      }
    }
  }
  return found;
}

}  // namespace cli
