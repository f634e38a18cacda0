// SPDX-License-Identifier: Apache-2.0
// Parts that fall asleep.
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;
import abut.scene.rest.sleep;

using namespace abut::capi;

static_assert(static_cast<abut_event_flags>(abut::event_asleep) == ABUT_EVENT_ASLEEP);

namespace {

constexpr abut_sleep default_sleep{sizeof(abut_sleep),          abut::Sleep{}.steps,
                                   abut::Sleep{}.linear_speed,  abut::Sleep{}.linear_acceleration,
                                   abut::Sleep{}.angular_speed, abut::Sleep{}.angular_acceleration};

abut::Sleep to_sleep(const abut_sleep& sleep) {
  return {sleep.steps, sleep.linear_speed, sleep.linear_acceleration, sleep.angular_speed, sleep.angular_acceleration};
}

abut_sleep_change from_change(const abut::SleepChange& change) {
  return {from_part(change.part), change.is_asleep ? 1u : 0u, 0};
}

abut_status set_one(abut_universe& its, const abut_part_id& part, const abut_sleep* sleep) {
  std::optional<abut::Sleep> thresholds;
  if (sleep != nullptr) {
    if (const abut_status status = check_struct_size({"sleep"}, *sleep); status != ABUT_OK) {
      return status;
    }
    thresholds = to_sleep(*sleep);
    if (const abut::Fault fault = abut::check_sleep(*thresholds)) {
      return refuse_field({"sleep"}, *fault);
    }
  }
  const auto done = its.universe.set_sleep(std::array{to_part(part)}, std::array{thresholds});
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_stale({"part"}, part);
}

abut_status set_all(abut_universe& its, std::span<const abut_part_id> ids, std::span<const abut_sleep> given) {
  std::vector<std::optional<abut::Sleep>> thresholds(ids.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    thresholds[i] = to_sleep(given[i]);
    if (const abut::Fault fault = abut::check_sleep(*thresholds[i])) {
      return refuse_field({"sleeps", i}, *fault);
    }
  }
  const auto done = its.universe.set_sleep(to_parts(ids), thresholds);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

abut_status wake_all(abut_universe& its, std::span<const abut_part_id> ids) {
  const auto done = its.universe.wake(to_parts(ids));
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

}  // namespace

void abut_sleep_init(abut_sleep* sleep, uint32_t struct_size) { fill_defaults(default_sleep, struct_size, sleep); }

abut_status abut_part_set_sleep(abut_universe* universe, abut_part_id part, const abut_sleep* sleep) {
  return guard(universe, [&](abut_universe& its) { return set_one(its, part, sleep); });
}

abut_status abut_parts_set_sleep(abut_universe* universe, const abut_part_id* parts, const abut_sleep* sleeps,
                                 size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    StructArray<abut_sleep> given;
    abut_status status = read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : StructArray<abut_sleep>::read("sleeps", sleeps, count, given);
    return status != ABUT_OK ? status : set_all(its, ids, given.span());
  });
}

abut_status abut_part_is_asleep(const abut_universe* universe, abut_part_id part, uint32_t* out) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const auto found = its.universe.is_asleep(to_part(part));
    if (!found) {
      return refuse_stale({"part"}, part);
    }
    *out = found.value() ? 1 : 0;
    return abut_status{ABUT_OK};
  });
}

abut_status abut_part_wake(abut_universe* universe, abut_part_id part) {
  return guard(universe, [&](abut_universe& its) {
    return exists(its.universe, part) ? wake_all(its, std::array{part}) : refuse_stale({"part"}, part);
  });
}

abut_status abut_parts_wake(abut_universe* universe, const abut_part_id* parts, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    const abut_status status = read_span("parts", parts, "count", count, ids);
    return status != ABUT_OK ? status : wake_all(its, ids);
  });
}

abut_status abut_universe_sleep_changes(const abut_universe* universe, const abut_sleep_change** changes,
                                        size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"changes", changes}, {"count", count}}});
    if (status == ABUT_OK) {
      const std::span<const abut_sleep_change> lent = its.sleep_changes.get(its.universe.sleep_changes(), from_change);
      *changes = lent.data();
      *count = lent.size();
    }
    return status;
  });
}
