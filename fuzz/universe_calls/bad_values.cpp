// SPDX-License-Identifier: Apache-2.0
// Calls that have to be refused: structs of a wrong size, numbers that are
// none, values that do not exist, huge counts.
#include <array>
#include <limits>

#include "play.hpp"

namespace universe_calls {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A struct as a header of the future has it, with something in its tail.
template <class Struct>
struct Longer {
  Struct known;
  std::array<std::uint64_t, 2> tail{1, 0};
};

std::uint32_t wrong_size(const Call& call, std::size_t size) {
  return std::array<std::uint32_t, 4>{0, 4, static_cast<std::uint32_t>(size - 1), 0xffffffff}.at(call.pick(4, 4));
}

template <class Struct>
Longer<Struct> longer(Struct known) {
  known.struct_size = sizeof(Longer<Struct>);
  return {known};
}

struct Refused {
  abut_status expected;
  abut_geometry_options options;
};

// One value of the options of a geometry is wrong.
Refused spoiled(const Call& call) {
  Refused bad{ABUT_OUT_OF_RANGE, {}};
  abut_geometry_options_init(&bad.options, sizeof bad.options);
  switch (call.pick(4, 9)) {
    case 0:
      bad = {ABUT_NOT_FINITE, bad.options};
      bad.options.tolerance = nan;
      break;
    case 1: bad.options.tolerance = -0.5; break;
    case 2: bad.options.tag = 64; break;
    case 3:
      bad = {ABUT_UNKNOWN_VALUE, bad.options};
      bad.options.parking = 3;
      break;
    case 4:
      bad = {ABUT_UNKNOWN_VALUE, bad.options};
      bad.options.flags = 0x80;
      break;
    case 5:
      bad = {ABUT_NOT_FINITE, bad.options};
      bad.options.pose.position.y = infinity;
      break;
    case 6:
      bad = {ABUT_NOT_UNIT, bad.options};
      bad.options.pose.orientation.w = 2;
      break;
    case 7:
      bad = {ABUT_ZERO_VECTOR, bad.options};
      bad.options.pose.orientation = {};
      break;
    default: bad.options.pose.position.x = 1e300; break;
  }
  return bad;
}

}  // namespace

abut_status Play::bad_struct(const Call& call, abut_universe* its, abut_status& expected) {
  expected = ABUT_WRONG_STRUCT_SIZE;
  const std::size_t u = call.pick(1, universe_count);
  abut_part_id part{77, 77};
  abut_geometry_id geometry{77, 77};
  abut_part_options part_options;
  abut_part_options_init(&part_options, sizeof part_options);
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  abut_policy policy = default_policy();
  abut_step_stats stats{};
  abut_geometry_info info{};
  const auto living = world_.living_geometries();
  const auto lasting = living.empty() ? geometry : world_.geometries[living[0]].ids.at(u);
  switch (call.pick(3, 8)) {
    case 0:
      part_options.struct_size = wrong_size(call, sizeof part_options);
      return abut_part_create(its, &part_options, &part);
    case 1: {
      const Longer<abut_part_options> future = longer(part_options);
      return abut_part_create(its, &future.known, &part);
    }
    case 2: {
      const abut_part_options blank{};
      return abut_parts_create(its, &blank, 1, &part);
    }
    case 3: policy.struct_size = wrong_size(call, sizeof policy); return abut_policy_set(its, 0, 0, &policy);
    case 4: {
      const Longer<abut_policy> future = longer(policy);
      return abut_policy_set(its, 1, 2, &future.known);
    }
    case 5: stats.struct_size = wrong_size(call, sizeof stats); return abut_universe_stats(its, &stats);
    case 6:
      options.struct_size = wrong_size(call, sizeof options);
      return living.empty() ? abut_geometry_create(its, part, shapes().front().shape, &options, &geometry)
                            : abut_geometry_set_options(its, lasting, &options);
    default: return abut_geometry_describe(its, lasting, &info);
  }
}

abut_status Play::bad_number(const Call& call, abut_universe* its, abut_status& expected) {
  const std::size_t u = call.pick(1, universe_count);
  const auto living = world_.living_geometries();
  constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();
  abut_part_id part{77, 77};
  abut_geometry_id geometry{77, 77};
  abut_policy policy = default_policy();
  abut_collidable any{ABUT_COLLIDABLE_ANY, 0, 0}, odd{ABUT_COLLIDABLE_ANY, 1, 0};
  const abut_aabb upside_down{{1, 0, 0}, {0, 1, 1}}, not_a_region{{0, nan, 0}, {1, 1, 1}};
  const std::uint64_t value = 0;
  std::size_t contact_count = 0;
  const abut_contact* contacts = nullptr;
  abut_part_options options;
  abut_focus focus;
  abut_focus_init(&focus, sizeof focus);
  const abut_vec3 no_place{0, nan, 0};
  switch (call.pick(3, 20)) {
    case 0: expected = ABUT_NOT_FINITE; return abut_universe_step(its, call.has(4, 0) ? nan : infinity);
    case 1: expected = ABUT_OUT_OF_RANGE; return abut_universe_step(its, -0.25);
    case 2: expected = ABUT_NOT_FINITE; return abut_universe_detect_region(its, &not_a_region);
    case 3: expected = ABUT_INVALID_ARGUMENT; return abut_universe_detect_region(its, &upside_down);
    case 4: expected = ABUT_SIZE_OVERFLOW; return abut_parts_destroy(its, &part, huge);
    case 5: expected = ABUT_SIZE_OVERFLOW; return abut_geometries_park(its, &geometry, huge / 2, ABUT_PARKING_NONE);
    case 6: expected = ABUT_SIZE_OVERFLOW; return abut_universe_detect_pairs(its, &geometry, &geometry, huge - 1);
    case 7: expected = ABUT_UNKNOWN_VALUE; return abut_rule_set(its, &any, &any, 3);
    case 8: expected = ABUT_INVALID_ARGUMENT; return abut_rule_set(its, &any, &odd, ABUT_RULE_DISABLE);
    case 9:
      expected = ABUT_UNKNOWN_VALUE;
      any.kind = 4;
      return abut_rule_set(its, &any, &any, ABUT_RULE_DISABLE);
    case 10: expected = ABUT_OUT_OF_RANGE; return abut_policy_set(its, 64, 0, nullptr);
    case 11:
      expected = ABUT_OUT_OF_RANGE;
      policy.period = 0;
      return abut_policy_set(its, 0, 0, &policy);
    case 12:
      expected = ABUT_NOT_FINITE;
      policy.tolerance = nan;
      return abut_policy_set(its, 0, 0, &policy);
    case 13:
      expected = ABUT_UNKNOWN_VALUE;
      policy.detail = 5;
      return abut_policy_set(its, 0, 0, &policy);
    case 14:
      expected = ABUT_UNKNOWN_VALUE;
      abut_part_options_init(&options, sizeof options);
      options.motion = 3;
      return abut_part_create(its, &options, &part);
    case 15:
      expected = ABUT_INVALID_ARGUMENT;
      require(abut_universe_contacts(its, &contacts, &contact_count) == ABUT_OK, "abut_universe_contacts failed");
      return abut_contacts_set_user_data(its, &value, contact_count == 1 ? 0 : 1);
    case 16:
      expected = ABUT_INVALID_ARGUMENT;
      focus.near_tag = focus.far_tag;
      return abut_universe_set_focus(its, &focus, nullptr, 0);
    case 17:
      expected = ABUT_OUT_OF_RANGE;
      focus.near_distance = 1;
      return abut_universe_set_focus(its, &focus, nullptr, 0);
    case 18: expected = ABUT_NOT_FINITE; return abut_universe_set_focus(its, &focus, &no_place, 1);
    default: break;
  }
  const Refused bad = spoiled(call);
  expected = bad.expected;
  if (!living.empty()) {
    return abut_geometry_set_options(its, world_.geometries[living[0]].ids.at(u), &bad.options);
  }
  expected = ABUT_OUT_OF_RANGE;
  return abut_policy_set(its, 0, 65, nullptr);
}

}  // namespace universe_calls
