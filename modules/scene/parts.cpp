// SPDX-License-Identifier: Apache-2.0
module;
#include "../core/check.hpp"
module abut.scene;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.scene.meetings.checks;
import abut.scene.room;

namespace abut {
namespace {

// The matrix of a quaternion is also that of its negative.
bool is_same(const Placement& one, const Placement& other) {
  const Pose a = one.pose(), b = other.pose();
  return a.position == b.position && a.rotation.x == b.rotation.x && a.rotation.y == b.rotation.y &&
         a.rotation.z == b.rotation.z;
}

}  // namespace

Result<std::vector<PartId>> Scene::create_parts(std::span<const PartOptions> options) {
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (Fault fault = check_placement(options[i].placement, "options", i)) {
      return *fault;
    }
  }
  std::vector<PartId> created;
  created.reserve(options.size());
  try {
    for (const PartOptions& part : options) {
      created.push_back(parts_.insert(
          {.placement = part.placement, .user_data = part.user_data, .motion = part.motion, .geometries = {}}));
    }
  } catch (...) {
    // The last one first: the next call gets the same slots.
    for (; !created.empty(); created.pop_back()) {
      parts_.erase(created.back());
    }
    throw;
  }
  return created;
}

Result<void> Scene::destroy_parts(std::span<const PartId> parts) {
  if (std::optional<Error> error = mark_all(parts_, parts, "parts")) {
    return *error;
  }
  for (const PartId part : parts) {
    for (const GeometryId geometry : parts_.at(part).geometries) {
      forget_geometry(geometry);
    }
    count_change(parts_.at(part).geometries, {parts_.at(part).geometries.size(), 0});
    if (!meetings_.rules.is_empty()) {
      meetings_.rules.forget({CollidableKind::part, part.slot, part.generation});
    }
    sleep_.forget(part.slot);
    velocities_.forget(part.slot);
    velocities_.accelerate(part.slot, {});
    list_bytes_ -= parts_.at(part).geometries.capacity() * sizeof(GeometryId);
    parts_.erase(part);
  }
  return {};
}

Result<void> Scene::set_poses(std::span<const PartId> parts, std::span<const Placement> poses) {
  ABUT_CHECK(parts.size() == poses.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts_.contains(parts[i])) {
      return stale(name_at("parts", i));
    }
    if (Fault fault = check_placement(poses[i], "poses", i)) {
      return *fault;
    }
  }
  make_room(changes_.moved_parts, parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts_.at(parts[i]);
    const Placement before = std::exchange(part.placement, poses[i]);
    if (sleep_.is_used() && (part.motion != MotionKind::dynamic || sleep_.is_asleep(parts[i].slot)) &&
        !is_same(before, part.placement)) {
      disturb(parts[i]);
    }
    if (!part.is_moved) {
      part.is_moved = true;
      changes_.moved_parts.push_back(parts[i]);
    }
  }
  count_moves(parts);
  return {};
}

// The broad phase keeps what moves and what does not apart, so geometries leave it and come back: with the next update,
// until which queries go on to find them.
Result<void> Scene::set_motions(std::span<const PartId> parts, std::span<const MotionKind> motions) {
  ABUT_CHECK(parts.size() == motions.size());
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  std::size_t count = 0;
  for (const PartId part : parts) {
    count += parts_.at(part).geometries.size();
  }
  make_room(changes_.rejoining, count);
  make_room(changes_.changed_geometries, count);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts_.at(parts[i]);
    if (part.motion == motions[i]) {
      continue;
    }
    part.motion = motions[i];
    if (sleep_.is_used()) {
      sleep_.set_dynamic(parts[i].slot, motions[i] == MotionKind::dynamic);
    }
    for (const GeometryId geometry : part.geometries) {
      places_.infos[geometry.slot - 1].is_dynamic = motions[i] == MotionKind::dynamic;
      changes_.rejoining.push_back(geometry.slot - 1);
      change(geometry);
    }
  }
  return {};
}

Result<Placement> Scene::pose(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).placement;
}

Result<MotionKind> Scene::motion(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).motion;
}

Result<std::uint64_t> Scene::user_data(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).user_data;
}

Result<void> Scene::set_user_data(std::span<const PartId> parts, std::span<const std::uint64_t> user_data) {
  ABUT_CHECK(parts.size() == user_data.size());
  if (std::optional<Error> error = check_ids(parts_, parts, "parts")) {
    return *error;
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts_.at(parts[i]).user_data = user_data[i];
  }
  return {};
}

Result<std::vector<GeometryId>> Scene::geometries_of(PartId part) const {
  if (!parts_.contains(part)) {
    return stale("part");
  }
  return parts_.at(part).geometries;
}

std::vector<PartId> Scene::parts() const {
  std::vector<PartId> all;
  all.reserve(parts_.size());
  parts_.for_each([&](PartId id, const Part&) { all.push_back(id); });
  return all;
}

}  // namespace abut
