// SPDX-License-Identifier: Apache-2.0
// Parts that fall asleep. The model does not foretell when; it knows what holds of those that do.
#include <algorithm>
#include <iterator>
#include <map>

#include "play.hpp"

namespace universe_calls {
namespace {

bool is_same(const abut_pose& a, const abut_pose& b) {
  const auto numbers = [](const abut_pose& pose) {
    const auto& [position, turn] = pose;
    return std::array{position.x, position.y, position.z, turn.w, turn.x, turn.y, turn.z};
  };
  return numbers(a) == numbers(b);
}

}  // namespace

void Play::set_sleep(const Call& call) {
  const std::vector<std::size_t> parts = picked(world_.living_parts(), call, 1 + call.pick(2, 32));
  const std::size_t kind = call.pick(3, 6);
  abut_sleep sleep;
  abut_sleep_init(&sleep, sizeof sleep);
  sleep.steps = 1 + static_cast<std::uint32_t>(call.pick(4, 2));
  if (call.pick(5, 4) != 0) {
    // Parts of a sequence leap: with limits such as these that is calm.
    sleep.linear_speed = sleep.linear_acceleration = sleep.angular_speed = sleep.angular_acceleration = 1e6;
  }
  const std::vector<abut_sleep> sleeps(parts.size(), sleep);
  on_each("abut_parts_set_sleep or abut_parts_wake", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_part_id> ids;
    for (const std::size_t part : parts) {
      ids.push_back(world_.parts[part].ids.at(u));
    }
    if (kind == 0) {
      return ids.size() == 1 ? abut_part_wake(its, ids[0]) : abut_parts_wake(its, ids.data(), ids.size());
    }
    const abut_sleep* given = kind == 1 ? nullptr : sleeps.data();
    return ids.size() == 1 ? abut_part_set_sleep(its, ids[0], given)
                           : abut_parts_set_sleep(its, ids.data(), given, ids.size());
  });
  for (const std::size_t part : parts) {
    world_.parts[part].may_sleep = kind == 0 ? world_.parts[part].may_sleep : kind != 1;
  }
  // The third universe takes no steps with time, so nobody sleeps there.
  is_exactly_full_ = false;
}

void Play::judge_sleep() {
  for (std::size_t u = 0; u < universe_count; ++u) {
    judge_sleep_of(u);
  }
}

void Play::judge_sleep_of(std::size_t universe) {
  const abut_universe* its = universes_.at(universe);
  const abut_sleep_change* first = nullptr;
  std::size_t count = 0;
  require(abut_universe_sleep_changes(its, &first, &count) == ABUT_OK, "abut_universe_sleep_changes failed");
  std::vector<abut_sleep_change> changes;
  std::copy_n(first, count, std::back_inserter(changes));
  std::size_t next = 0;
  std::uint64_t asleep_count = 0;
  for (const std::size_t i : world_.living_parts()) {
    Part& part = world_.parts[i];
    std::uint32_t asleep = 77;
    require(abut_part_is_asleep(its, part.ids.at(universe), &asleep) == ABUT_OK && asleep <= 1,
            "abut_part_is_asleep failed");
    const bool is_asleep = asleep == 1, was_asleep = part.is_asleep.at(universe);
    asleep_count += asleep;
    require(!is_asleep || (part.may_sleep && part.motion == ABUT_MOTION_DYNAMIC), "a part sleeps that must not");
    if (is_asleep != was_asleep) {
      require(next < changes.size() && changes[next].part.slot == part.ids.at(universe).slot &&
                  changes[next].part.generation == part.ids.at(universe).generation &&
                  changes[next].is_asleep == asleep,
              "a part fell asleep or woke, and the next change is another one");
      ++next;
      (is_asleep ? counts_.sleeps : counts_.wakes) += 1;
    }
    const abut_pose& pose = part.placed.pose;
    if (is_asleep && !was_asleep) {
      part.rest.at(universe) = pose;
    }
    require(!is_asleep || is_same(part.rest.at(universe), pose), "a part moves in its sleep");
    part.is_asleep.at(universe) = is_asleep;
  }
  require(next == changes.size(), "there are more changes than parts that fell asleep or woke");
  const Found found = found_in(its);
  require(found.stats.asleep == asleep_count, "the statistics count other sleeping parts");
  std::map<std::uint32_t, std::size_t> living;
  for (const std::size_t i : world_.living_geometries()) {
    living[world_.geometries[i].ids.at(universe).slot] = i;
  }
  for (const abut_contact& contact : found.contacts) {
    const Geometry& a = world_.geometries.at(living.at(contact.geometry_a.slot));
    const Geometry& b = world_.geometries.at(living.at(contact.geometry_b.slot));
    const Part &one = world_.parts[a.part], &other = world_.parts[b.part];
    const bool is_sensor = ((a.options.flags | b.options.flags) & ABUT_GEOMETRY_SENSOR) != 0;
    const bool is_joined = one.motion == ABUT_MOTION_DYNAMIC && other.motion == ABUT_MOTION_DYNAMIC && !is_sensor;
    require(!is_joined || one.is_asleep.at(universe) == other.is_asleep.at(universe),
            "one of two parts that touch sleeps, the other does not");
  }
}

}  // namespace universe_calls
