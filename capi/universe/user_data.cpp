// SPDX-License-Identifier: Apache-2.0
// Values of the caller on parts and geometries.
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

namespace {

template <class OwnId, class CId>
abut_status set_one(abut_universe& its, std::string_view name, const OwnId& own, const CId& id,
                    std::uint64_t user_data) {
  const auto done = its.universe.set_user_data(std::array{own}, std::array{user_data});
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_stale({name}, id);
}

template <class CId, class ToOwn>
abut_status set_all(abut_universe* universe, std::string_view name, const CId* ids, const uint64_t* user_data,
                    size_t count, ToOwn&& to_own) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const CId> all;
    std::span<const std::uint64_t> values;
    abut_status status = read_span(name, ids, "count", count, all);
    status = status != ABUT_OK ? status : read_span("user_data", user_data, "count", count, values);
    if (status != ABUT_OK) {
      return status;
    }
    const auto done = its.universe.set_user_data(to_own(all), values);
    return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, name, all, done.error());
  });
}

}  // namespace

abut_status abut_part_set_user_data(abut_universe* universe, abut_part_id part, uint64_t user_data) {
  return guard(universe, [&](abut_universe& its) { return set_one(its, "part", to_part(part), part, user_data); });
}

abut_status abut_parts_set_user_data(abut_universe* universe, const abut_part_id* parts, const uint64_t* user_data,
                                     size_t count) {
  return set_all(universe, "parts", parts, user_data, count,
                 [](std::span<const abut_part_id> ids) { return to_parts(ids); });
}

abut_status abut_geometry_set_user_data(abut_universe* universe, abut_geometry_id geometry, uint64_t user_data) {
  return guard(universe, [&](abut_universe& its) {
    return set_one(its, "geometry", to_geometry(geometry), geometry, user_data);
  });
}

abut_status abut_geometries_set_user_data(abut_universe* universe, const abut_geometry_id* geometries,
                                          const uint64_t* user_data, size_t count) {
  return set_all(universe, "geometries", geometries, user_data, count,
                 [](std::span<const abut_geometry_id> ids) { return to_geometries(ids); });
}
