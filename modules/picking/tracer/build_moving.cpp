// SPDX-License-Identifier: Apache-2.0
// Building the scene of what moves: one box for each geometry.
module;

#include <abut/picking.h>

#include "picking/embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

module abut.picking;
import :box_scene;
import :entry;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// Smaller scenes are traced in a space of this size, where their boxes are wider than they are, but no subnormals.
constexpr double least_extent = 1e-15;

// How many boxes a level takes, beside so many in all: a change costs building the first level, and building each
// further one in proportion to its size, divided by the size of the one before.
[[nodiscard]] std::size_t capacity_of(std::uint8_t level, std::size_t all) {
  constexpr std::size_t few = 48;
  const double power = std::cbrt(static_cast<double>(all));
  return level == 0 ? few : few + static_cast<std::size_t>(power * power);
}

}  // namespace

abut_status Tracer::become_moving(std::uint32_t index) {
  Entry& entry = entries_[index];
  if (entry.role == Role::instance) {
    if (const abut_status status = make_instanced(shapes_[entry.shape]); status != ABUT_OK) return status;
  }
  MovingScene& first = moving_.front();
  entry.place = static_cast<std::uint32_t>(first.boxes.size());
  entry.level = 0;
  first.boxes.push_back({.box = {}, .entry = index});
  first.is_changed = true;
  return ABUT_OK;
}

// Empties a level into the next one, where what has left goes as well.
void Tracer::move_up(std::uint8_t level) {
  MovingScene& from = moving_[level];
  MovingScene& to = moving_[level + 1u];
  to.boxes.insert(to.boxes.end(), from.boxes.begin(), from.boxes.end());
  std::erase_if(to.boxes, [](const MovingBox& its) { return its.entry == nowhere; });
  from.boxes.clear();
  from.left = to.left = 0;
  for (std::size_t place = 0; place < to.boxes.size(); ++place) {
    Entry& entry = entries_[to.boxes[place].entry];
    entry.place = static_cast<std::uint32_t>(place);
    entry.level = static_cast<std::uint8_t>(level + 1);
  }
  to.is_changed = true;
}

abut_status Tracer::build_moving() {
  std::size_t all = 0;
  for (const MovingScene& moving : moving_) all += moving.boxes.size();
  for (std::uint8_t level = 0; level + 1 < level_count; ++level) {
    if (moving_[level].boxes.size() > capacity_of(level, all)) move_up(level);
  }
  // Rays that meet boxes of what has left look at them in vain.
  if (2 * moving_.back().left > moving_.back().boxes.size()) move_up(level_count - 2);
  for (MovingScene& moving : moving_) {
    if (const abut_status status = commit(moving); status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

abut_status Tracer::commit(MovingScene& moving) {
  if (!std::exchange(moving.is_changed, false) || moving.boxes.empty()) return ABUT_OK;
  abut_aabb box = empty_box;
  for (const MovingBox& its : moving.boxes) {
    extend(box, entries_[its.entry].box.minimum);
    extend(box, entries_[its.entry].box.maximum);
  }
  moving.space = space_around(box);
  moving.space.extent = std::max(moving.space.extent, least_extent);
  for (MovingBox& its : moving.boxes) its.box = widened_box(entries_[its.entry].box, moving.space);
  if (!moving.scene) {
    moving.geometry = embree::Geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    moving.scene = embree::Scene(rtcNewScene(device_.get()));
    if (!moving.geometry || !moving.scene) return ABUT_OUT_OF_MEMORY;
    rtcSetGeometryUserData(moving.geometry.get(), &moving);
    rtcSetGeometryBoundsFunction(moving.geometry.get(), report_bounds, nullptr);
    rtcSetGeometryIntersectFunction(moving.geometry.get(), report_hits);
    rtcSetGeometryOccludedFunction(moving.geometry.get(), report_any);
    rtcAttachGeometryByID(moving.scene.get(), moving.geometry.get(), 0);
  }
  rtcSetGeometryUserPrimitiveCount(moving.geometry.get(), static_cast<unsigned>(moving.boxes.size()));
  rtcCommitGeometry(moving.geometry.get());
  rtcCommitScene(moving.scene.get());
  return embree_status();
}

void Tracer::report_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& moving = *static_cast<const MovingScene*>(arguments->geometryUserPtr);
  write_bounds(moving.boxes[arguments->primID].box, *arguments->bounds_o);
}

}  // namespace abut::picking
