// SPDX-License-Identifier: Apache-2.0
// Velocities and accelerations of parts.
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_velocity_source>(abut::VelocitySource::none) == ABUT_VELOCITY_NONE);
static_assert(static_cast<abut_velocity_source>(abut::VelocitySource::given) == ABUT_VELOCITY_GIVEN);
static_assert(static_cast<abut_velocity_source>(abut::VelocitySource::poses) == ABUT_VELOCITY_FROM_POSES);

namespace {

abut_velocity from_velocity(const abut::Velocity& velocity) {
  return {from_vec3(velocity.linear), from_vec3(velocity.angular)};
}

// Of velocities and accelerations.
template <class Rates>
abut_status check_rates(const Where& where, const Rates& rates) {
  const abut_status status = check_position(where, ".linear", rates.linear);
  return status != ABUT_OK ? status : check_position(where, ".angular", rates.angular);
}

// `given` is empty for none.
abut_status set_all(abut_universe& its, std::span<const abut_part_id> ids, std::span<const abut_velocity> given) {
  std::vector<std::optional<abut::Velocity>> velocities(ids.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    velocities[i] = abut::Velocity{to_vec3(given[i].linear), to_vec3(given[i].angular)};
  }
  const auto done = its.universe.set_velocities(to_parts(ids), velocities);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

abut_status accelerate_all(abut_universe& its, std::span<const abut_part_id> ids,
                           std::span<const abut_acceleration> given) {
  std::vector<abut::Acceleration> accelerations(ids.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    accelerations[i] = {to_vec3(given[i].linear), to_vec3(given[i].angular)};
  }
  const auto done = its.universe.set_accelerations(to_parts(ids), accelerations);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

template <class Rates>
abut_status check_all(std::string_view name, std::span<const Rates> rates) {
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (const abut_status status = check_rates({name, i}, rates[i]); status != ABUT_OK) {
      return status;
    }
  }
  return ABUT_OK;
}

abut_status measure_all(abut_universe& its, std::span<const abut_part_id> ids) {
  const auto done = its.universe.measure_velocities(to_parts(ids));
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
}

// One number of each part after the other, by `value_of`.
template <class Value, class ValueOf>
abut_status write_of_each(const abut_universe& its, std::span<const abut_part_id> ids, std::span<Value> out,
                          ValueOf&& value_of) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!exists(its.universe, ids[i])) {
      return refuse_stale({"parts", i}, ids[i]);
    }
  }
  std::transform(ids.begin(), ids.end(), out.begin(), [&](const abut_part_id& id) { return value_of(to_part(id)); });
  return ABUT_OK;
}

template <class Value, class ValueOf>
abut_status answer_of_each(const abut_universe* universe, const abut_part_id* parts, std::size_t count, Value* out,
                           ValueOf&& value_of) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<Value> values;
    abut_status status = read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("out", out, "count", count, values);
    return status != ABUT_OK ? status
                             : write_of_each(its, ids, values, [&](abut::PartId part) { return value_of(its, part); });
  });
}

}  // namespace

abut_status abut_part_set_velocity(abut_universe* universe, abut_part_id part, const abut_velocity* velocity) {
  return guard(universe, [&](abut_universe& its) {
    if (!exists(its.universe, part)) {
      return refuse_stale({"part"}, part);
    }
    if (velocity == nullptr) {
      return set_all(its, std::array{part}, {});
    }
    const abut_status status = check_rates({"velocity"}, *velocity);
    return status != ABUT_OK ? status : set_all(its, std::array{part}, std::array{*velocity});
  });
}

abut_status abut_parts_set_velocities(abut_universe* universe, const abut_part_id* parts,
                                      const abut_velocity* velocities, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<const abut_velocity> given;
    abut_status status = read_span("parts", parts, "count", count, ids);
    if (status == ABUT_OK && velocities != nullptr) {
      status = read_span("velocities", velocities, "count", count, given);
    }
    status = status != ABUT_OK ? status : check_all("velocities", given);
    return status != ABUT_OK ? status : set_all(its, ids, given);
  });
}

abut_status abut_part_measure_velocity(abut_universe* universe, abut_part_id part) {
  return guard(universe, [&](abut_universe& its) {
    return exists(its.universe, part) ? measure_all(its, std::array{part}) : refuse_stale({"part"}, part);
  });
}

abut_status abut_parts_measure_velocities(abut_universe* universe, const abut_part_id* parts, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    const abut_status status = read_span("parts", parts, "count", count, ids);
    return status != ABUT_OK ? status : measure_all(its, ids);
  });
}

abut_status abut_part_velocity(const abut_universe* universe, abut_part_id part, abut_velocity* out,
                               abut_velocity_source* source) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const auto found = its.universe.velocity(to_part(part));
    if (!found) {
      return refuse_stale({"part"}, part);
    }
    *out = from_velocity(found.value());
    if (source != nullptr) {
      *source = static_cast<abut_velocity_source>(its.universe.velocity_source(to_part(part)).value());
    }
    return abut_status{ABUT_OK};
  });
}

abut_status abut_parts_velocities(const abut_universe* universe, const abut_part_id* parts, size_t count,
                                  abut_velocity* out) {
  return answer_of_each(universe, parts, count, out, [](const abut_universe& its, abut::PartId part) {
    return from_velocity(its.universe.velocity(part).value());
  });
}

abut_status abut_part_set_acceleration(abut_universe* universe, abut_part_id part,
                                       const abut_acceleration* acceleration) {
  return guard(universe, [&](abut_universe& its) {
    if (!exists(its.universe, part)) {
      return refuse_stale({"part"}, part);
    }
    if (acceleration == nullptr) {
      return accelerate_all(its, std::array{part}, {});
    }
    const abut_status status = check_rates({"acceleration"}, *acceleration);
    return status != ABUT_OK ? status : accelerate_all(its, std::array{part}, std::array{*acceleration});
  });
}

abut_status abut_parts_set_accelerations(abut_universe* universe, const abut_part_id* parts,
                                         const abut_acceleration* accelerations, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<const abut_acceleration> given;
    abut_status status = read_span("parts", parts, "count", count, ids);
    if (status == ABUT_OK && accelerations != nullptr) {
      status = read_span("accelerations", accelerations, "count", count, given);
    }
    status = status != ABUT_OK ? status : check_all("accelerations", given);
    return status != ABUT_OK ? status : accelerate_all(its, ids, given);
  });
}

abut_status abut_parts_accelerations(const abut_universe* universe, const abut_part_id* parts, size_t count,
                                     abut_acceleration* out) {
  return answer_of_each(universe, parts, count, out, [](const abut_universe& its, abut::PartId part) {
    const abut::Acceleration its_acceleration = its.universe.acceleration(part).value();
    return abut_acceleration{from_vec3(its_acceleration.linear), from_vec3(its_acceleration.angular)};
  });
}
