// SPDX-License-Identifier: Apache-2.0
// Building the scene of what moves: one box for each geometry.
module;

#include <abut/picking.h>

#include "embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

module abut.picking;
import :entry;
import :source;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// Boxes of the moving scene are widened by this part of the extent: rays start within 3 * sqrt(3)
// extents, and the rounding of their points, 2^-24 each, and of the slab test stay below it.
constexpr double widening = 0x1p-20;

// Smaller scenes are traced in a space of this size, where their boxes are wider than they are, but no subnormals.
constexpr double least_extent = 1e-15;

[[nodiscard]] float rounded_down(double value) {
  const float nearest = static_cast<float>(value);
  return static_cast<double>(nearest) <= value ? nearest
                                               : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

[[nodiscard]] float rounded_up(double value) { return -rounded_down(-value); }

}  // namespace

abut_status Tracer::become_moving(std::uint32_t index) {
  Entry& entry = entries_[index];
  if (entry.role == Role::instance) {
    if (const abut_status status = make_instanced(shapes_[entry.shape]); status != ABUT_OK) return status;
  }
  entry.place = static_cast<std::uint32_t>(moving_.size());
  moving_.push_back({.lower = {}, .upper = {}, .entry = index});
  moved_.push_back(index);
  moving_changed_ = true;
  return ABUT_OK;
}

// Keeps the space of the moving scene while it fits; otherwise centres it anew, with room to move.
void Tracer::settle_moving_space() {
  abut_aabb box = empty_box;
  for (const MovingBox& moving : moving_) {
    extend(box, entries_[moving.entry].box.minimum);
    extend(box, entries_[moving.entry].box.maximum);
  }
  const double reach = reach_of(box, moving_space_.origin);
  Space tight = space_around(box);
  tight.extent = std::max(tight.extent, least_extent);
  if (reach <= moving_space_.extent && 8 * tight.extent >= moving_space_.extent) return;
  moving_space_ = {tight.origin, 2 * tight.extent};
  moved_.clear();
  for (const MovingBox& moving : moving_) moved_.push_back(moving.entry);
}

void Tracer::write_box(MovingBox& moving) const {
  const abut_aabb& box = entries_[moving.entry].box;
  const double margin = widening * moving_space_.extent;
  const abut_vec3 low = subtract(box.minimum, moving_space_.origin);
  const abut_vec3 high = subtract(box.maximum, moving_space_.origin);
  moving.lower = {rounded_down(low.x - margin), rounded_down(low.y - margin), rounded_down(low.z - margin)};
  moving.upper = {rounded_up(high.x + margin), rounded_up(high.y + margin), rounded_up(high.z + margin)};
}

abut_status Tracer::build_moving() {
  moving_changed_ = false;
  if (moving_.empty()) {
    moved_.clear();
    return ABUT_OK;
  }
  settle_moving_space();
  for (const std::uint32_t index : std::exchange(moved_, {})) {
    const std::uint32_t place = entries_[index].place;
    if (place < moving_.size() && moving_[place].entry == index) write_box(moving_[place]);
  }
  if (!moving_scene_) {
    moving_geometry_ = embree::Geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    moving_scene_ = embree::Scene(rtcNewScene(device_.get()));
    if (!moving_geometry_ || !moving_scene_) return ABUT_OUT_OF_MEMORY;
    rtcSetGeometryUserData(moving_geometry_.get(), this);
    rtcSetGeometryBoundsFunction(moving_geometry_.get(), report_bounds, this);
    rtcSetGeometryIntersectFunction(moving_geometry_.get(), report_hits);
    rtcAttachGeometryByID(moving_scene_.get(), moving_geometry_.get(), 0);
  }
  rtcSetGeometryUserPrimitiveCount(moving_geometry_.get(), static_cast<unsigned>(moving_.size()));
  rtcCommitGeometry(moving_geometry_.get());
  rtcCommitScene(moving_scene_.get());
  return embree_status();
}

void Tracer::report_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& self = *static_cast<const Tracer*>(arguments->geometryUserPtr);
  const MovingBox& box = self.moving_[arguments->primID];
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower[0];
  out.lower_y = box.lower[1];
  out.lower_z = box.lower[2];
  out.upper_x = box.upper[0];
  out.upper_y = box.upper[1];
  out.upper_z = box.upper[2];
}

}  // namespace abut::picking
