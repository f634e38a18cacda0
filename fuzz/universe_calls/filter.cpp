// SPDX-License-Identifier: Apache-2.0
// The filter: decides by user data, makes the calls that it may make and those
// that it may not.
#include <array>

#include "universes.hpp"

namespace universe_calls {
namespace {

std::uint64_t data_of(FilterContext& its, const abut_universe* universe, abut_geometry_id geometry) {
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  if (abut_geometry_describe(universe, geometry, &info) != ABUT_OK) {
    its.complaint = "the filter was asked about a geometry that does not exist";
  }
  return info.user_data;
}

// One exclusive call, another one for each pair.
void try_what_is_forbidden(FilterContext& its, abut_geometry_id geometry, std::size_t which) {
  abut_universe* universe = its.universe;
  abut_part_id part{77, 77};
  abut_pose pose{{0, 0, 0}, {1, 0, 0, 0}};
  abut_status status = ABUT_BUSY;
  switch (which % 8) {
    case 0: status = abut_universe_step(universe, 0.5); break;
    case 1: status = abut_part_create(universe, nullptr, &part); break;
    case 2: status = abut_geometry_destroy(universe, geometry); break;
    case 3: status = abut_universe_detect_all(universe); break;
    case 4: status = abut_universe_set_filter(universe, nullptr, nullptr); break;
    case 5: status = abut_part_set_pose(universe, part, &pose); break;
    case 6: status = abut_rules_clear(universe); break;
    default: abut_universe_destroy(universe); break;
  }
  if (status != ABUT_BUSY || part.slot != 77) {
    its.complaint = "an exclusive call in a filter answered " + std::string(abut_status_name(status));
  }
}

}  // namespace

uint32_t filter_pair(void* context, const abut_universe* universe, abut_geometry_id a, abut_geometry_id b) {
  auto& its = *static_cast<FilterContext*>(context);
  if (a.slot >= b.slot || (!its.asked.empty() && its.asked.back() >= Slots{a.slot, b.slot})) {
    its.complaint = "the filter was not asked in order of slots";
  }
  its.asked.emplace_back(a.slot, b.slot);
  std::uint64_t hash = 0;
  if (universe != its.universe || abut_universe_hash(universe, &hash) != ABUT_OK || hash != its.hash_before) {
    its.complaint = "in a filter the contacts and events are not those of the step before";
  }
  const std::uint64_t data_a = data_of(its, universe, a), data_b = data_of(its, universe, b);
  try_what_is_forbidden(its, a, its.asked.size() + b.slot);
  if (const std::optional<abut_parking> parking = its.rule.parking_of(data_a, data_b)) {
    if (abut_geometry_park(its.universe, b, *parking) != ABUT_OK) {
      its.complaint = "a filter could not park";
    }
  }
  return its.rule.keeps(data_a, data_b) ? 1 : 0;
}

}  // namespace universe_calls
