// SPDX-License-Identifier: Apache-2.0
// Following the world: which geometries came, went and moved.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

module abut.picking;
import :entry;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// Shapes with at most this many triangles are asked in double: that is faster than a scene of their
// own. A box has 12.
constexpr std::size_t few_triangles = 12;

// Surfaces of these sizes (diagonals) are traced in single precision, where a product of three lengths neither
// overflows nor vanishes; all others are asked in double.
constexpr double smallest_surface = 1e-9;
constexpr double largest_surface = 1e9;

// Boxes with larger coordinates have no place among those in single precision.
constexpr double farthest_traced = 1e12;

[[nodiscard]] bool is_traceable(const abut_aabb& box) {
  return is_bounded(box) && reach_of(box, {0, 0, 0}) <= farthest_traced;
}

template <class Value>
[[nodiscard]] std::uint32_t take_slot(std::vector<Value>& values, std::vector<std::uint32_t>& free) {
  if (free.empty()) {
    values.emplace_back();
    return static_cast<std::uint32_t>(values.size() - 1);
  }
  const std::uint32_t index = free.back();
  free.pop_back();
  values[index] = Value{};
  return index;
}

[[nodiscard]] bool equal(const abut_vec3& a, const abut_vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
[[nodiscard]] bool equal(const abut_quat& a, const abut_quat& b) {
  return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace

// What no filter lets rays meet is left out.
bool Tracer::is_met(const GeometryView& view) const {
  return !view.is_parked && view.traits.layers != 0 && view.traits.mask != 0 &&
         (sees_sensors_ || !view.traits.is_sensor);
}

void Tracer::note_box(const Entry& entry) {
  if (is_traceable(entry.box)) {
    boxes_.set(entry.id.slot, entry.box);
  } else {
    boxes_.erase(entry.id.slot);
  }
}

void Tracer::set_flags(bool sees_sensors, bool skips_back_faces) {
  skips_back_faces_ = skips_back_faces;
  if (std::exchange(sees_sensors_, sees_sensors) != sees_sensors) forget_everything();
  settle_usual_rays();
}

void Tracer::set_clip_planes(std::vector<HalfSpace> planes) {
  clip_planes_ = std::move(planes);
  settle_usual_rays();
}

abut_status Tracer::catch_up() {
  // The world does not change while queries run, so no ray is under way in a scene that is stale.
  const std::scoped_lock lock(mutex_);
  if (is_current()) return ABUT_OK;
  try {
    const abut_status status = synchronize();
    if (status != ABUT_OK) forget_everything();
    return status;
  } catch (...) {
    forget_everything();
    throw;
  }
}

abut_status Tracer::synchronize() {
  if (const abut_status status = make_device(); status != ABUT_OK) return status;
  bool is_known = false;
  if (const abut_status status = follow_changes(is_known); status != ABUT_OK) return status;
  if (!is_known && seen_geometries_.load(std::memory_order_relaxed) != *counters_.geometries) {
    if (const abut_status status = list_geometries(); status != ABUT_OK) return status;
  }
  if (!is_known && seen_poses_.load(std::memory_order_relaxed) != *counters_.poses) {
    if (const abut_status status = follow_poses(); status != ABUT_OK) return status;
  }
  if (const abut_status status = build(); status != ABUT_OK) return status;
  seen_geometries_.store(*counters_.geometries, std::memory_order_release);
  seen_poses_.store(*counters_.poses, std::memory_order_release);
  return ABUT_OK;
}

// Where the world still knows what has changed, nothing else is looked at.
abut_status Tracer::follow_changes(bool& is_known) {
  const std::uint64_t geometries = seen_geometries_.load(std::memory_order_relaxed);
  const std::uint64_t poses = seen_poses_.load(std::memory_order_relaxed);
  is_known = false;
  if (geometries == never || poses == never) return ABUT_OK;
  std::vector<abut_geometry_id> changed;
  if (const abut_status status = source_->changes(geometries, poses, changed, is_known); status != ABUT_OK)
    return status;
  ++epoch_;
  for (const abut_geometry_id id : changed) {
    if (const abut_status status = follow_one(id); status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

std::uint32_t Tracer::entry_in_slot(std::uint32_t slot) const {
  return slot < entry_of_slot_.size() ? entry_of_slot_[slot] : nowhere;
}

abut_status Tracer::follow_one(abut_geometry_id id) {
  const std::uint32_t index = entry_in_slot(id.slot);
  GeometryView view{};
  if (id.generation != 0) {
    if (const abut_status status = source_->describe(id, view); status != ABUT_OK) return status;
  }
  const bool is_there = id.generation != 0 && is_met(view);
  const bool is_same = is_there && index != nowhere && entries_[index].id.generation == id.generation &&
                       shapes_[entries_[index].shape].key == view.shape_key;
  if (is_same) {
    entries_[index].traits = view.traits;
    return move_entry(index, view.pose);
  }
  if (index != nowhere) remove_entry(index);
  return is_there ? add_entry(id, view) : static_cast<abut_status>(ABUT_OK);
}

abut_status Tracer::list_geometries() {
  std::vector<abut_geometry_id> ids;
  if (const abut_status status = source_->geometries(ids); status != ABUT_OK) return status;
  ++epoch_;
  struct Arrival {
    abut_geometry_id id;
    GeometryView view;
  };
  std::vector<Arrival> added;
  for (const abut_geometry_id id : ids) {
    GeometryView view{};
    if (const abut_status status = source_->describe(id, view); status != ABUT_OK) return status;
    if (!is_met(view)) continue;
    const std::uint32_t index = entry_in_slot(id.slot);
    if (index != nowhere && entries_[index].id.generation == id.generation &&
        shapes_[entries_[index].shape].key == view.shape_key) {
      entries_[index].epoch = epoch_;
      entries_[index].traits = view.traits;
    } else {
      added.push_back({id, view});
    }
  }
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].id.slot != 0 && entries_[i].epoch != epoch_) remove_entry(static_cast<std::uint32_t>(i));
  }
  for (const Arrival& arrival : added) {
    if (const abut_status status = add_entry(arrival.id, arrival.view); status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

abut_status Tracer::add_entry(abut_geometry_id id, const GeometryView& view) {
  std::uint32_t shape = nowhere;
  if (const abut_status status = find_shape(id, view.shape_key, shape); status != ABUT_OK) return status;
  const std::uint32_t index = take_slot(entries_, free_entries_);
  ++shapes_[shape].users;
  Entry& entry = entries_[index];
  entry.id = id;
  entry.shape = shape;
  entry.epoch = epoch_;
  entry.traits = view.traits;
  entry.pose = view.pose;
  entry.frame = frame_of(view.pose);
  if (id.slot >= entry_of_slot_.size()) entry_of_slot_.resize(std::size_t{id.slot} + 1, nowhere);
  entry_of_slot_[id.slot] = index;
  thin_count_ += shapes_[shape].is_thin() ? 1 : 0;
  if (const abut_status status = place_box(entry); status != ABUT_OK) return status;
  note_box(entry);
  if (shapes_[shape].is_surface && is_traceable(entry.box)) {
    arrivals_.push_back(index);
    return ABUT_OK;
  }
  return take_place(index);
}

// Gives an entry that has none a place among what moves, or apart.
abut_status Tracer::take_place(std::uint32_t index) {
  Entry& entry = entries_[index];
  if (is_traceable(entry.box)) {
    entry.role = shapes_[entry.shape].is_surface ? Role::instance : Role::exact;
    return become_moving(index);
  }
  entry.role = Role::apart;
  entry.place = static_cast<std::uint32_t>(apart_.size());
  apart_.push_back(index);
  return ABUT_OK;
}

abut_status Tracer::find_shape(abut_geometry_id id, std::uintptr_t key, std::uint32_t& out) {
  if (const auto found = shape_of_key_.find(key); found != shape_of_key_.end()) {
    out = found->second;
    return ABUT_OK;
  }
  ShapeRecord record;
  record.key = key;
  if (const abut_status status = source_->shape(id, record.access); status != ABUT_OK) return status;
  if (const abut_status status = record.access->triangle_count(record.triangle_count); status != ABUT_OK) return status;
  if (record.triangle_count > few_triangles) {
    if (const abut_status status = describe_surface(record); status != ABUT_OK) return status;
  }
  record.rounded = record.access->rounded();
  out = take_slot(shapes_, free_shapes_);
  shapes_[out] = std::move(record);
  shape_of_key_.emplace(key, out);
  return ABUT_OK;
}

abut_status Tracer::describe_surface(ShapeRecord& record) const {
  TriangleList list;
  if (const abut_status status = record.access->triangles(list); status != ABUT_OK) return status;
  record.local_box = box_of(list);
  const double size = diagonal_of(record.local_box);
  record.is_surface = size >= smallest_surface && size <= largest_surface;
  if (!record.is_surface) return ABUT_OK;
  record.is_paired = is_paired(list);
  record.is_steep = record.is_paired && is_steep(list);
  return record.access->faces(list, record.faces);
}

abut_status Tracer::place_box(Entry& entry) const {
  const ShapeRecord& shape = shapes_[entry.shape];
  if (!shape.is_surface) return shape.access->bounds(entry.pose, entry.box);
  // The surface is all that rays meet; its box is tight under any rotation of the box of its vertices.
  const abut_aabb& local = shape.local_box;
  entry.box = empty_box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    extend(entry.box, to_world(entry.frame, {(corner & 1u) != 0 ? local.maximum.x : local.minimum.x,
                                             (corner & 2u) != 0 ? local.maximum.y : local.minimum.y,
                                             (corner & 4u) != 0 ? local.maximum.z : local.minimum.z}));
  }
  return ABUT_OK;
}

abut_status Tracer::follow_poses() {
  std::vector<abut_geometry_id> ids;
  std::vector<std::uint32_t> indices;
  ids.reserve(entries_.size());
  indices.reserve(entries_.size());
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].id.slot == 0) continue;
    ids.push_back(entries_[i].id);
    indices.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<abut_pose> poses;
  if (const abut_status status = source_->poses(ids, poses); status != ABUT_OK) return status;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (const abut_status status = move_entry(indices[i], poses[i]); status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

abut_status Tracer::move_entry(std::uint32_t index, const abut_pose& pose) {
  Entry& entry = entries_[index];
  if (equal(entry.pose.position, pose.position) && equal(entry.pose.orientation, pose.orientation)) return ABUT_OK;
  entry.pose = pose;
  entry.frame = frame_of(pose);
  if (const abut_status status = place_box(entry); status != ABUT_OK) return status;
  note_box(entry);
  if (entry.place == nowhere) return ABUT_OK;
  const bool is_moving = entry.role == Role::instance || entry.role == Role::exact;
  if (entry.role == Role::apart && !is_traceable(entry.box)) return ABUT_OK;
  if (is_moving && entry.level == 0 && is_traceable(entry.box)) {
    moving_.front().is_changed = true;
    return ABUT_OK;
  }
  leave_place(entry);
  return take_place(index);
}

void Tracer::remove_entry(std::uint32_t index) {
  Entry& entry = entries_[index];
  leave_place(entry);
  std::erase(arrivals_, index);
  thin_count_ -= shapes_[entry.shape].is_thin() ? 1 : 0;
  if (entry_of_slot_[entry.id.slot] == index) {
    entry_of_slot_[entry.id.slot] = nowhere;
    boxes_.erase(entry.id.slot);
  }
  release_shape(entry.shape);
  free_entries_.push_back(index);
  entry = Entry{};
}

// Only the first level is built anew with each change.
void Tracer::leave_moving(MovingScene& moving, bool is_first, std::uint32_t place) {
  if (!is_first) {
    moving.boxes[place].entry = nowhere;
    ++moving.left;
    return;
  }
  if (place + 1 != moving.boxes.size()) {
    moving.boxes[place] = moving.boxes.back();
    entries_[moving.boxes[place].entry].place = place;
  }
  moving.boxes.pop_back();
  moving.is_changed = true;
}

void Tracer::leave_place(Entry& entry) {
  if (entry.place == nowhere) return;
  const std::uint32_t place = entry.place;
  entry.place = nowhere;
  switch (entry.role) {
    case Role::baked:
      // The last one takes its number; the still scene is built anew.
      if (place + 1 != baked_.size()) {
        baked_[place] = baked_.back();
        entries_[baked_[place].entry].place = place;
      }
      baked_.pop_back();
      still_changed_ = true;
      return;
    case Role::instance:
    case Role::exact: leave_moving(moving_[entry.level], entry.level == 0, place); return;
    case Role::apart:
      // Kept in order, so that equal distances are always decided alike.
      apart_.erase(apart_.begin() + static_cast<std::ptrdiff_t>(place));
      for (std::size_t i = place; i < apart_.size(); ++i) entries_[apart_[i]].place = static_cast<std::uint32_t>(i);
      return;
  }
}

void Tracer::release_shape(std::uint32_t index) {
  ShapeRecord& shape = shapes_[index];
  if (--shape.users != 0) return;
  shape_of_key_.erase(shape.key);
  shape = ShapeRecord{};
  free_shapes_.push_back(index);
}

void Tracer::forget_everything() {
  seen_geometries_.store(never, std::memory_order_release);
  seen_poses_.store(never, std::memory_order_release);
  still_.reset();
  single_still_.reset();
  baked_.clear();
  still_planes_.clear();
  for (MovingScene& moving : moving_) {
    moving.boxes.clear();
    moving.left = 0;
    moving.is_changed = false;
  }
  apart_.clear();
  thin_count_ = 0;
  still_faces_.clear();
  arrivals_.clear();
  entries_.clear();
  free_entries_.clear();
  entry_of_slot_.clear();
  boxes_.clear();
  shape_of_key_.clear();
  shapes_.clear();
  free_shapes_.clear();
  still_space_ = {};
  usual_reach_ = -1;
  still_changed_ = false;
}

}  // namespace abut::picking
