// SPDX-License-Identifier: Apache-2.0
#include "play.hpp"

#include <algorithm>
#include <utility>

namespace universe_calls {

Play::Play(const Sequence& sequence, Tamper tamper)
    : sequence_(sequence), tamper_(std::move(tamper)), universes_(sequence.setup) {
  world_.mode = universes_.options().tolerance_mode;
  world_.max_contacts = universes_.options().max_contacts;
  world_.events = universes_.options().events;
}

std::optional<std::string> Play::run() {
  std::size_t index = 0;
  std::string name = "step";
  try {
    for (; index < sequence_.calls.size(); ++index) {
      name = name_of(sequence_.calls[index].operation());
      call(sequence_.calls[index]);
      ++counts_.calls;
    }
    Call last;
    detect(last);
  } catch (const Finding& finding) {
    return "call " + std::to_string(index) + " (" + name + "): " + finding.what();
  }
  return std::nullopt;
}

void Play::call(const Call& call) {
  switch (call.operation()) {
    case Operation::create_part: return create_part(call);
    case Operation::destroy_part: return destroy_parts(call, 1);
    case Operation::destroy_parts: return destroy_parts(call, 2);
    case Operation::place: return place(call, 1);
    case Operation::place_all: return place(call, 4);
    case Operation::set_motion: return set_motion(call);
    case Operation::create_geometry: return create_geometries(call, 1);
    case Operation::create_geometries: return create_geometries(call, 3);
    case Operation::destroy_geometry: return destroy_geometries(call, 1);
    case Operation::destroy_geometries: return destroy_geometries(call, 3);
    case Operation::set_options: return set_options(call);
    case Operation::set_shape: return set_shape(call);
    case Operation::park: return park(call, 1);
    case Operation::park_all: return park(call, 4);
    case Operation::set_rule: return set_rule(call);
    case Operation::clear_rules:
      on_each("abut_rules_clear", [](std::size_t, abut_universe* its) { return abut_rules_clear(its); });
      return world_.rules.clear();
    case Operation::set_sleep: return set_sleep(call);
    case Operation::set_filter: return set_filter(call);
    case Operation::refilter:
      return on_each("abut_universe_refilter",
                     [](std::size_t, abut_universe* its) { return abut_universe_refilter(its); });
    case Operation::set_policy: return set_policy(call);
    case Operation::set_focus: return set_focus(call);
    case Operation::step:
    case Operation::detect_all:
    case Operation::detect_pairs:
    case Operation::detect_region: return detect(call);
    case Operation::refresh:
      return on_each("abut_universe_refresh",
                     [](std::size_t, abut_universe* its) { return abut_universe_refresh(its); });
    case Operation::mark_contacts: return mark_contacts(call);
    case Operation::set_parameters: return set_parameters(call);
    case Operation::set_samples: return set_samples(call);
    case Operation::set_velocity: return set_velocity(call);
    case Operation::follow_islands: return follow_islands(call);
    case Operation::bad: return bad(call);
  }
}

// Up to `count` different ones, from where the call says.
std::vector<std::size_t> Play::picked(const std::vector<std::size_t>& living, const Call& call,
                                      std::size_t count) const {
  std::vector<std::size_t> out;
  const std::size_t first = call.pick(1, living.size());
  for (std::size_t i = 0; i < std::min(count, living.size()); ++i) {
    out.push_back(living[(first + i) % living.size()]);
  }
  return out;
}

}  // namespace universe_calls
