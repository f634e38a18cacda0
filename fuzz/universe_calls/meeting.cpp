// SPDX-License-Identifier: Apache-2.0
// Who meets whom, and who touches, as docs/universe.md and abut.h say it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "model.hpp"

namespace universe_calls {
namespace {

bool same(const abut_collidable& a, const abut_collidable& b) {
  return std::tie(a.kind, a.slot, a.generation) == std::tie(b.kind, b.slot, b.generation);
}

bool speaks_of(const World& world, const abut_collidable& rule, const Geometry& geometry) {
  const abut_part_id part = world.parts.at(geometry.part).ids[0];
  switch (rule.kind) {
    case ABUT_COLLIDABLE_GEOMETRY:
      return rule.slot == geometry.ids[0].slot && rule.generation == geometry.ids[0].generation;
    case ABUT_COLLIDABLE_PART: return rule.slot == part.slot && rule.generation == part.generation;
    case ABUT_COLLIDABLE_LABEL: return rule.slot == geometry.options.label;
    default: return true;
  }
}

// The more specific side first, then the other; kinds are numbered from the
// most specific one.
std::pair<abut_collidable_kind, abut_collidable_kind> rank(const Rule& rule) {
  return std::minmax(rule.a.kind, rule.b.kind);
}

bool rules_allow(const World& world, const Geometry& a, const Geometry& b) {
  std::pair<abut_collidable_kind, abut_collidable_kind> best{4, 4};
  bool allows = true;
  for (const Rule& rule : world.rules) {
    const bool fits = (speaks_of(world, rule.a, a) && speaks_of(world, rule.b, b)) ||
                      (speaks_of(world, rule.a, b) && speaks_of(world, rule.b, a));
    if (!fits || rank(rule) > best) {
      continue;
    }
    const bool enables = rule.rule == ABUT_RULE_ENABLE;
    allows = rank(rule) < best ? enables : allows && enables;
    best = rank(rule);
  }
  return allows;
}

// By how much two boxes are apart along each axis; negative where they overlap.
std::optional<Triple> gaps(const World& world, const Geometry& a, const Geometry& b) {
  const std::optional<Box> one = box_of(world, a), other = box_of(world, b);
  if (!one || !other) {
    return std::nullopt;
  }
  Triple gap{};
  for (std::size_t i = 0; i < 3; ++i) {
    gap.at(i) = std::abs(one->centre.at(i) - other->centre.at(i)) - one->half.at(i) - other->half.at(i);
  }
  return gap;
}

// How far the box of a geometry may be inflated so that no pair is missed.
double reach(const World& world, const Geometry& geometry) {
  double reach = geometry.options.tolerance;
  for (const auto& [tags, policy] : world.policies) {
    reach = std::max(reach, 0.5 * policy.tolerance);
  }
  return reach;
}

Answer touches_in_dead_band(const Triple& gap, double tolerance) {
  const int widest = std::ranges::max(gap);
  // Without a tolerance touching counts, else the depth has to exceed it.
  return (tolerance == 0 ? widest <= 0 : -widest > tolerance) ? Answer::yes : Answer::no;
}

Answer touches_in_margin(const Triple& gap, double tolerance) {
  if (std::ranges::max(gap) <= 0) {
    return Answer::yes;
  }
  double square = 0;
  int axes = 0;
  for (const int g : gap) {
    square += g > 0 ? g * g : 0;
    axes += g > 0 ? 1 : 0;
  }
  if (square == tolerance * tolerance && axes > 1) {
    return Answer::maybe;  // the root of the square may be rounded to either
                           // side
  }
  return square < tolerance * tolerance ? Answer::yes : Answer::no;
}

}  // namespace

std::optional<abut_parking> FilterRule::parking_of(std::uint64_t data_a, std::uint64_t data_b) const {
  if (parks == 0 || (data_a * 5 + data_b) % 7 != 0) {
    return std::nullopt;
  }
  return parks;
}

void World::set_rule(const Rule& rule) {
  std::erase_if(rules, [&](const Rule& its) {
    return (same(its.a, rule.a) && same(its.b, rule.b)) || (same(its.a, rule.b) && same(its.b, rule.a));
  });
  if (rule.rule != ABUT_RULE_NONE) {
    rules.push_back(rule);
  }
}

const abut_policy& World::policy_of(const Geometry& a, const Geometry& b) const {
  static const abut_policy standard = default_policy();
  const auto found = policies.find(std::minmax(a.options.tag, b.options.tag));
  return found == policies.end() ? standard : found->second;
}

abut_apart_reasons World::reasons_apart(const Geometry& a, const Geometry& b) const {
  const bool none_moves =
      parts.at(a.part).motion != ABUT_MOTION_DYNAMIC && parts.at(b.part).motion != ABUT_MOTION_DYNAMIC;
  const bool is_one_parked = a.options.parking != ABUT_PARKING_NONE || b.options.parking != ABUT_PARKING_NONE;
  const bool are_excluded = (a.options.exclusion & b.options.exclusion) != 0;
  const bool are_strangers = (a.options.layers & b.options.mask) == 0 || (b.options.layers & a.options.mask) == 0;
  abut_apart_reasons reasons = 0;
  reasons |= a.part == b.part ? ABUT_APART_PART : 0;
  reasons |= none_moves ? ABUT_APART_MOTION : 0;
  reasons |= is_one_parked ? ABUT_APART_PARKING : 0;
  reasons |= are_excluded ? ABUT_APART_EXCLUSION : 0;
  reasons |= are_strangers ? ABUT_APART_LAYERS : 0;
  reasons |= rules_allow(*this, a, b) ? 0 : ABUT_APART_RULE;
  return reasons;
}

bool World::may_meet(const Geometry& a, const Geometry& b) const {
  return (reasons_apart(a, b) & (ABUT_APART_PART | ABUT_APART_MOTION | ABUT_APART_PARKING)) == 0;
}

bool World::is_admitted_before_filter(const Geometry& a, const Geometry& b) const { return reasons_apart(a, b) == 0; }

bool World::is_admitted(const Geometry& a, const Geometry& b) const {
  return is_admitted_before_filter(a, b) && filter.keeps(a.options.user_data, b.options.user_data);
}

Answer World::touches(const Geometry& a, const Geometry& b) const {
  const std::optional<Triple> gap = gaps(*this, a, b);
  if (!gap) {
    return Answer::maybe;
  }
  const abut_policy& policy = policy_of(a, b);
  const double tolerance = policy.tolerance < 0 ? a.options.tolerance + b.options.tolerance : policy.tolerance;
  return mode == ABUT_TOLERANCE_MARGIN ? touches_in_margin(*gap, tolerance) : touches_in_dead_band(*gap, tolerance);
}

Answer World::is_near(const Geometry& a, const Geometry& b) const {
  const std::optional<Triple> gap = gaps(*this, a, b);
  if (!gap) {
    return Answer::maybe;
  }
  const int widest = std::ranges::max(*gap);
  const bool is_box = policy_of(a, b).detail == ABUT_DETAIL_BOX;
  if (widest <= 0 || (!is_box && touches(a, b) == Answer::yes)) {
    return Answer::yes;
  }
  const double slack = mode == ABUT_TOLERANCE_MARGIN ? reach(*this, a) + reach(*this, b) : 0;
  return widest > slack ? Answer::no : Answer::maybe;
}

bool World::is_focused(const Geometry& geometry) const {
  const std::uint32_t tag = geometry.options.tag;
  return focus && geometry.options.parking == ABUT_PARKING_NONE &&
         (tag == focus->focus.near_tag || tag == focus->focus.far_tag);
}

std::optional<std::uint32_t> World::focused_tag(const Geometry& geometry) const {
  const std::optional<Box> box = box_of(*this, geometry);
  if (!box) {
    return std::nullopt;
  }
  const double slack = mode == ABUT_TOLERANCE_MARGIN ? reach(*this, geometry) : 0;
  bool is_near = false, is_far = true;
  for (const Triple& centre : focus->centres) {
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double outside = std::max(std::abs(centre.at(i) - box->centre.at(i)) - box->half.at(i) - slack, 0.0);
      square += outside * outside;
    }
    is_near = is_near || std::sqrt(square) < focus->focus.near_distance;
    is_far = is_far && std::sqrt(square) > focus->focus.far_distance;
  }
  return is_near ? focus->focus.near_tag : is_far ? focus->focus.far_tag : geometry.options.tag;
}

Answer World::is_covered(const Geometry& a, const Geometry& b, const Scope& scope) const {
  const Slots slots = std::minmax(a.ids[0].slot, b.ids[0].slot);
  if (scope.coverage == Coverage::pairs) {
    return std::ranges::find(scope.pairs, slots) != scope.pairs.end() ? Answer::yes : Answer::no;
  }
  if (scope.coverage != Coverage::region) {
    return Answer::yes;
  }
  Answer both = Answer::yes;
  for (const Geometry* geometry : {&a, &b}) {
    const std::optional<Box> box = box_of(*this, *geometry);
    if (!box) {
      both = both == Answer::no ? Answer::no : Answer::maybe;
      continue;
    }
    const double slack = mode == ABUT_TOLERANCE_MARGIN ? reach(*this, *geometry) : 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const int gap = std::max(scope.region[0].at(i) - box->centre.at(i) - box->half.at(i),
                               box->centre.at(i) - box->half.at(i) - scope.region[1].at(i));
      if (gap > slack) {
        both = Answer::no;
      } else if (gap > 0) {
        both = both == Answer::no ? Answer::no : Answer::maybe;
      }
    }
  }
  return both;
}

}  // namespace universe_calls
