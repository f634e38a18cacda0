// SPDX-License-Identifier: Apache-2.0
// Calls that have to be refused: ids that name nothing, and pointers that are
// null. Nothing that can be seen may change.
#include <array>

#include "play.hpp"

namespace universe_calls {
namespace {

constexpr abut_pose unmoved{{0, 0, 0}, {1, 0, 0, 0}};

}  // namespace

void Play::bad(const Call& call) {
  const std::size_t u = call.pick(1, universe_count);
  abut_universe* universe = universes_.at(u);
  const Snapshot before = snapshot_of(universe);
  abut_status expected = ABUT_OK, status = ABUT_OK;
  switch (call.pick(2, 4)) {
    case 0: status = bad_id(call, universe, expected); break;
    case 1: status = bad_pointer(call, universe, expected); break;
    case 2: status = bad_struct(call, universe, expected); break;
    default: status = bad_number(call, universe, expected); break;
  }
  const std::string which = std::to_string(call.pick(2, 4)) + "/" + std::to_string(call.bytes[3]);
  require(status == expected, "bad call " + which + " answered " + abut_status_name(status) + ", expected " +
                                  abut_status_name(expected) + ": " + abut_last_error_message());
  require(is_same(snapshot_of(universe), before), "bad call " + which + " changed something");
  ++counts_.refusals;
}

// Ids that are null, made up, of another universe, or of what is gone.
abut_status Play::bad_id(const Call& call, abut_universe* its, abut_status& expected) {
  expected = ABUT_STALE_ID;
  const std::size_t u = call.pick(1, universe_count), other = (u + 1) % universe_count;
  abut_part_id part{static_cast<std::uint32_t>(call.bytes[5]), static_cast<std::uint32_t>(call.bytes[6])};
  abut_geometry_id geometry{part.slot, part.generation};
  const std::size_t kind = call.pick(4, 4);
  if (kind == 0) {
    part = {};
    geometry = {};
  } else if (kind == 1 && !world_.parts.empty()) {
    part = world_.parts[call.pick(5, world_.parts.size())].ids.at(other);
  } else if (kind == 2) {
    // What is gone, if the pick is; what lives is named by another generation.
    const auto spoiled = [&](const auto& all, auto& id) {
      if (!all.empty()) {
        const auto& its_entry = all[call.pick(5, all.size())];
        id = its_entry.ids.at(u);
        id.generation += its_entry.is_alive ? 1 : 0;
      }
    };
    spoiled(world_.parts, part);
    spoiled(world_.geometries, geometry);
  }
  if (kind == 1 && !world_.geometries.empty()) {
    geometry = world_.geometries[call.pick(5, world_.geometries.size())].ids.at(other);
  }
  abut_geometry_id made{77, 77};
  abut_geometry_options options;
  abut_geometry_options_init(&options, sizeof options);
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  abut_pose pose = unmoved;
  abut_motion motion = 77;
  std::uint32_t asleep = 77;
  std::uint64_t data = 77;
  std::size_t count = 77;
  const abut_shape* shape = shapes().front().shape;
  // A batch in which the others are good.
  std::vector<abut_part_id> parts;
  std::vector<abut_geometry_id> geometries;
  for (const std::size_t i : world_.living_parts()) {
    parts.push_back(world_.parts[i].ids.at(u));
  }
  for (const std::size_t i : world_.living_geometries()) {
    geometries.push_back(world_.geometries[i].ids.at(u));
  }
  parts.push_back(part);
  geometries.push_back(geometry);
  const std::vector<abut_pose> poses(parts.size(), pose);
  const std::vector<abut_motion> motions(parts.size(), ABUT_MOTION_STATIC);
  const std::vector<abut_geometry_options> all_options(geometries.size(), options);
  const std::vector<const abut_shape*> all_shapes(std::max(parts.size(), geometries.size()), shape);
  std::vector<abut_geometry_id> out(parts.size(), made);
  std::vector<abut_pose> out_poses(geometries.size(), pose);
  const abut_collidable bad_part{ABUT_COLLIDABLE_PART, part.slot, part.generation};
  const abut_collidable bad_geometry{ABUT_COLLIDABLE_GEOMETRY, geometry.slot, geometry.generation},
      any{ABUT_COLLIDABLE_ANY, 0, 0};
  abut_status status = ABUT_OK;
  switch (call.pick(3, 29)) {
    case 0: return abut_part_destroy(its, part);
    case 1: return abut_parts_destroy(its, parts.data(), parts.size());
    case 2: return abut_part_set_pose(its, part, &pose);
    case 3: return abut_parts_set_poses(its, parts.data(), poses.data(), parts.size());
    case 4: return abut_part_set_motion(its, part, ABUT_MOTION_STATIC);
    case 5: return abut_parts_set_motions(its, parts.data(), motions.data(), parts.size());
    case 6: status = abut_part_motion(its, part, &motion); break;
    case 7: status = abut_part_user_data(its, part, &data); break;
    case 8: status = abut_part_geometries(its, part, &made, 1, &count); break;
    case 9: status = abut_geometry_create(its, part, shape, &options, &made); break;
    case 10:
      status = abut_geometries_create(its, parts.data(), all_shapes.data(), nullptr, parts.size(), out.data());
      break;
    case 11: return abut_geometry_destroy(its, geometry);
    case 12: return abut_geometries_destroy(its, geometries.data(), geometries.size());
    case 13: return abut_geometry_set_options(its, geometry, &options);
    case 14: return abut_geometries_set_options(its, geometries.data(), all_options.data(), geometries.size());
    case 15: return abut_geometry_set_shape(its, geometry, shape);
    case 16: return abut_geometries_set_shapes(its, geometries.data(), all_shapes.data(), geometries.size());
    case 17: return abut_geometry_park(its, geometry, ABUT_PARKING_LONG_TERM);
    case 18: return abut_geometries_park(its, geometries.data(), geometries.size(), ABUT_PARKING_SHORT_TERM);
    case 19: return abut_geometry_describe(its, geometry, &info);
    case 20: return abut_geometries_poses(its, geometries.data(), geometries.size(), out_poses.data());
    case 21: return abut_rule_set(its, &bad_geometry, &any, ABUT_RULE_DISABLE);
    case 22: return abut_rule_set(its, &any, &bad_part, ABUT_RULE_DISABLE);
    case 23: return abut_part_set_sleep(its, part, nullptr);
    case 24: return abut_parts_set_sleep(its, parts.data(), nullptr, parts.size());
    case 25: return abut_part_wake(its, part);
    case 26: return abut_parts_wake(its, parts.data(), parts.size());
    case 27: status = abut_part_is_asleep(its, part, &asleep); break;
    default: return abut_universe_detect_pairs(its, geometries.data(), geometries.data(), geometries.size());
  }
  for (const abut_geometry_id id : out) {
    require(id.slot == 77, "a refused call wrote to its array");
  }
  require(made.slot == 77 && motion == 77 && asleep == 77 && data == 77 && count == 77,
          "a refused call wrote its out-parameter");
  return status;
}

abut_status Play::bad_pointer(const Call& call, abut_universe* its, abut_status& expected) {
  expected = ABUT_NULL_ARGUMENT;
  abut_part_id part{};
  abut_geometry_id geometry{};
  // Of a living one where there is any: the pointer is what is wrong.
  const std::size_t u = call.pick(1, universe_count);
  if (const auto living = world_.living_parts(); !living.empty()) {
    part = world_.parts[living.front()].ids.at(u);
  }
  const auto living = world_.living_geometries();
  if (living.empty()) {
    return abut_universe_detect_region(its, nullptr);
  }
  geometry = world_.geometries[living.front()].ids.at(u);
  const abut_shape* none = nullptr;
  const abut_contact* contacts = nullptr;
  std::size_t count = 0;
  const abut_pose pose = unmoved;
  switch (call.pick(3, 20)) {
    case 0: return abut_part_create(its, nullptr, nullptr);
    case 1: return abut_parts_create(its, nullptr, 2, &part);
    case 2: return abut_part_set_pose(its, part, nullptr);
    case 3: return abut_parts_set_poses(its, nullptr, &pose, 1);
    case 4: return abut_parts_set_poses(its, &part, nullptr, 1);
    case 5: return abut_geometry_create(its, part, nullptr, nullptr, &geometry);
    case 6: return abut_geometries_create(its, &part, &none, nullptr, 1, &geometry);
    case 7: return abut_geometry_set_options(its, geometry, nullptr);
    case 8: return abut_geometry_set_shape(its, geometry, nullptr);
    case 9: return abut_geometries_set_shapes(its, &geometry, &none, 1);
    case 10: return abut_geometries_park(its, nullptr, 1, ABUT_PARKING_LONG_TERM);
    case 11: return abut_geometry_describe(its, geometry, nullptr);
    case 12: return abut_rule_set(its, nullptr, nullptr, ABUT_RULE_DISABLE);
    case 13: return abut_universe_contacts(its, &contacts, nullptr);
    case 14: return abut_universe_events(its, nullptr, &count);
    case 15: return abut_universe_detect_pairs(its, &geometry, nullptr, 1);
    case 16: return abut_universe_stats(its, nullptr);
    case 17: return abut_universe_step(nullptr, 0);
    case 18: return abut_parts_destroy(its, nullptr, 3);
    default: return abut_geometries_destroy(its, nullptr, 3);
  }
}

}  // namespace universe_calls
