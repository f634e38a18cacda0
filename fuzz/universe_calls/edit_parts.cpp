// SPDX-License-Identifier: Apache-2.0
// Parts are made, placed and destroyed.
#include "play.hpp"

namespace universe_calls {
namespace {

constexpr std::size_t most_parts = 16;

}  // namespace

// Within a small cube, so that most pairs are near each other. One pose in
// eight is beyond the model.
Placed placed_by(const Call& call, std::size_t byte, int reach) {
  const Triple position{call.number(byte, -reach, reach), call.number(byte + 1, -reach, reach),
                        call.number(byte + 2, -reach, reach)};
  if (call.pick(byte + 3, 8) == 7) {
    return loosely_placed(position, 0.01 * call.number(byte + 3, 0, 99), 0.02 * call.number(byte + 3, 0, 255));
  }
  return placed_at(position, call.pick(byte + 3, 12));
}

void Play::create_part(const Call& call) {
  if (world_.living_parts().size() >= most_parts) {
    return;
  }
  Part part;
  part.motion = std::array<abut_motion, 6>{0, 0, 0, 0, 1, 2}.at(call.pick(1, 6));
  part.placed = placed_by(call, 2, 4);
  part.user_data = call.bytes[6];
  const bool has_defaults = call.has(7, 0) && call.has(7, 1);
  if (has_defaults) {
    part = {};
  }
  abut_part_options options;
  abut_part_options_init(&options, sizeof options);
  options.motion = part.motion;
  options.pose = part.placed.pose;
  options.user_data = part.user_data;
  on_each("abut_part_create", [&](std::size_t u, abut_universe* its) {
    return call.has(7, 2) && !has_defaults ? abut_parts_create(its, &options, 1, &part.ids.at(u))
                                           : abut_part_create(its, has_defaults ? nullptr : &options, &part.ids.at(u));
  });
  require(part.ids[0].slot == part.ids[1].slot && part.ids[0].slot == part.ids[2].slot,
          "the same calls gave parts other slots");
  world_.parts.push_back(part);
  compare_part(world_.parts.size() - 1);
}

void Play::destroy_parts(const Call& call, std::size_t count) {
  const std::vector<std::size_t> gone = picked(world_.living_parts(), call, count);
  on_each("abut_parts_destroy", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_part_id> ids;
    for (const std::size_t part : gone) {
      ids.push_back(world_.parts[part].ids.at(u));
    }
    return ids.size() == 1 ? abut_part_destroy(its, ids[0]) : abut_parts_destroy(its, ids.data(), ids.size());
  });
  for (const std::size_t part : gone) {
    world_.forget_part(part);
  }
}

void Play::place(const Call& call, std::size_t count) {
  const std::vector<std::size_t> parts = picked(world_.living_parts(), call, count);
  std::vector<Placed> placed;
  std::vector<abut_pose> poses;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    placed.push_back(placed_by(call, 2 + 3 * i, 4));
    poses.push_back(placed.back().pose);
  }
  on_each("abut_parts_set_poses", [&](std::size_t u, abut_universe* its) {
    std::vector<abut_part_id> ids;
    for (const std::size_t part : parts) {
      ids.push_back(world_.parts[part].ids.at(u));
    }
    return ids.size() == 1 ? abut_part_set_pose(its, ids[0], poses.data())
                           : abut_parts_set_poses(its, ids.data(), poses.data(), ids.size());
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    world_.parts[parts[i]].placed = placed[i];
    for (const std::size_t geometry : world_.parts[parts[i]].geometries) {
      world_.geometries[geometry].is_moved = true;
    }
  }
}

void Play::set_motion(const Call& call) {
  for (const std::size_t place : picked(world_.living_parts(), call, 1)) {
    Part& part = world_.parts[place];
    part.motion = static_cast<abut_motion>(call.pick(2, 3));
    on_each("abut_part_set_motion", [&](std::size_t u, abut_universe* its) {
      return call.has(3, 0) ? abut_part_set_motion(its, part.ids.at(u), part.motion)
                            : abut_parts_set_motions(its, &part.ids.at(u), &part.motion, 1);
    });
    for (const std::size_t geometry : part.geometries) {
      world_.geometries[geometry].is_moved = true;
    }
  }
}

}  // namespace universe_calls
