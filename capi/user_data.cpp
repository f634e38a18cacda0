// SPDX-License-Identifier: Apache-2.0
// Values of the caller on parts and geometries.
#include "universe_handle.hpp"

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

}  // namespace

abut_status abut_part_set_user_data(abut_universe* universe, abut_part_id part, uint64_t user_data) {
  return guard(universe, [&](abut_universe& its) { return set_one(its, "part", to_part(part), part, user_data); });
}

abut_status abut_parts_set_user_data(abut_universe* universe, const abut_part_id* parts, const uint64_t* user_data,
                                     size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_part_id> ids;
    std::span<const std::uint64_t> values;
    abut_status status = read_span("parts", parts, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("user_data", user_data, "count", count, values);
    if (status != ABUT_OK) {
      return status;
    }
    const auto done = its.universe.set_user_data(to_parts(ids), values);
    return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "parts", ids, done.error());
  });
}

abut_status abut_geometry_set_user_data(abut_universe* universe, abut_geometry_id geometry, uint64_t user_data) {
  return guard(universe, [&](abut_universe& its) {
    return set_one(its, "geometry", to_geometry(geometry), geometry, user_data);
  });
}

abut_status abut_geometries_set_user_data(abut_universe* universe, const abut_geometry_id* geometries,
                                          const uint64_t* user_data, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> ids;
    std::span<const std::uint64_t> values;
    abut_status status = read_span("geometries", geometries, "count", count, ids);
    status = status != ABUT_OK ? status : read_span("user_data", user_data, "count", count, values);
    if (status != ABUT_OK) {
      return status;
    }
    const auto done = its.universe.set_user_data(to_geometries(ids), values);
    return done ? static_cast<abut_status>(ABUT_OK) : refuse_batch(its.universe, "geometries", ids, done.error());
  });
}
