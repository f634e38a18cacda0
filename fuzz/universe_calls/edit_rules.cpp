// SPDX-License-Identifier: Apache-2.0
// Who meets whom, and how.
#include <algorithm>

#include "play.hpp"

namespace universe_calls {

abut_collidable Play::collidable_of(const Call& call, std::size_t byte, std::size_t universe) const {
  const auto kind = static_cast<abut_collidable_kind>(call.pick(byte, 4));
  const std::vector<std::size_t> parts = world_.living_parts(), geometries = world_.living_geometries();
  if (kind == ABUT_COLLIDABLE_GEOMETRY && !geometries.empty()) {
    const abut_geometry_id id = world_.geometries[geometries[call.pick(byte + 1, geometries.size())]].ids.at(universe);
    return {kind, id.slot, id.generation};
  }
  if (kind == ABUT_COLLIDABLE_PART && !parts.empty()) {
    const abut_part_id id = world_.parts[parts[call.pick(byte + 1, parts.size())]].ids.at(universe);
    return {kind, id.slot, id.generation};
  }
  if (kind == ABUT_COLLIDABLE_LABEL) {
    return {kind, static_cast<std::uint32_t>(call.pick(byte + 1, 3)), 0};
  }
  return {ABUT_COLLIDABLE_ANY, 0, 0};
}

void Play::set_rule(const Call& call) {
  const auto rule = static_cast<abut_rule>(call.pick(1, 3));
  on_each("abut_rule_set", [&](std::size_t u, abut_universe* its) {
    const abut_collidable a = collidable_of(call, 2, u), b = collidable_of(call, 4, u);
    return abut_rule_set(its, &a, &b, rule);
  });
  world_.set_rule({collidable_of(call, 2, 0), collidable_of(call, 4, 0), rule});
}

void Play::set_filter(const Call& call) {
  // Half of them take the filter away.
  world_.filter = {};
  if (call.has(1, 7)) {
    world_.filter = {2 + static_cast<std::uint32_t>(call.pick(1, 4)), static_cast<std::uint32_t>(call.pick(2, 4) % 3)};
  }
  on_each("abut_universe_set_filter", [&](std::size_t u, abut_universe* its) {
    universes_.filter(u).rule = world_.filter;
    return world_.filter.modulus == 0 ? abut_universe_set_filter(its, nullptr, nullptr)
                                      : abut_universe_set_filter(its, filter_pair, &universes_.filter(u));
  });
}

void Play::set_policy(const Call& call) {
  const auto a = static_cast<std::uint32_t>(call.pick(1, 3)), b = static_cast<std::uint32_t>(call.pick(2, 3));
  const bool is_reset = call.pick(3, 4) == 0;
  abut_policy policy = default_policy();
  if (!is_reset) {
    policy.algorithm = std::array<abut_algorithm, 4>{ABUT_ALGORITHM_AUTO, ABUT_ALGORITHM_AUTO, ABUT_ALGORITHM_SAT,
                                                     ABUT_ALGORITHM_ANALYTIC}
                           .at(call.pick(4, 4));
    policy.detail = static_cast<abut_detail>(call.pick(5, 3));
    if (policy.detail == ABUT_DETAIL_BOX && (world_.events & ABUT_EVENTS_PAIRS) == 0) {
      policy.detail = ABUT_DETAIL_POINT;  // the touch of two boxes shows in its events alone
    }
    policy.period = 1 + static_cast<std::uint32_t>(call.pick(6, 4));
    policy.tolerance = call.has(7, 0) ? 0.25 * call.number(8, 0, 8) : -1;
  }
  on_each("abut_policy_set",
          [&](std::size_t, abut_universe* its) { return abut_policy_set(its, a, b, is_reset ? nullptr : &policy); });
  world_.policies[std::minmax(a, b)] = policy;
  is_exactly_full_ = is_exactly_full_ && policy.period == 1;
  for (auto& [slots, pair] : world_.pairs) {
    pair.is_stale = true;
    pair.waiting = 0;
  }
}

void Play::set_focus(const Call& call) {
  world_.focus.reset();
  if (call.pick(1, 4) == 0) {
    return on_each("abut_universe_set_focus",
                   [](std::size_t, abut_universe* its) { return abut_universe_set_focus(its, nullptr, nullptr, 0); });
  }
  Focus focus;
  abut_focus_init(&focus.focus, sizeof focus.focus);
  focus.focus.near_tag = static_cast<std::uint32_t>(call.pick(5, 3));
  focus.focus.far_tag = (focus.focus.near_tag + 1 + static_cast<std::uint32_t>(call.pick(6, 2))) % 3;
  // Extents and margins are eighths: no square of a distance is near to that of one that ends in .3.
  focus.focus.near_distance = 0.3 + call.number(3, 0, 5);
  focus.focus.far_distance = focus.focus.near_distance + call.number(4, 0, 4);
  std::vector<abut_vec3> centres;
  for (std::size_t i = 0; i < call.pick(2, 4); ++i) {
    const Triple centre{call.number(7 + 3 * i, -8, 8), call.number(8 + 3 * i, -8, 8), call.number(9 + 3 * i, -8, 8)};
    focus.centres.push_back(centre);
    centres.push_back({static_cast<double>(centre[0]), static_cast<double>(centre[1]), static_cast<double>(centre[2])});
  }
  on_each("abut_universe_set_focus", [&](std::size_t, abut_universe* its) {
    return abut_universe_set_focus(its, &focus.focus, centres.data(), centres.size());
  });
  world_.focus = focus;
}

}  // namespace universe_calls
