// Building what Embree traverses.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

module abut.picking;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

namespace {

// A surface is baked when the space reaches at most this many of its diagonals: the growth of its
// outlines, which is in proportion to the space, then stays below 2^-16 of the diagonal.
constexpr double farthest_baked = 16;

// Boxes of the moving scene are widened by this part of the extent: rays start within 3 * sqrt(3)
// extents, and the rounding of their points, 2^-24 each, and of the slab test stay below it.
constexpr double widening = 0x1p-20;

[[nodiscard]] float rounded_down(double value) {
  const float nearest = static_cast<float>(value);
  return static_cast<double>(nearest) <= value ? nearest
                                               : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

[[nodiscard]] float rounded_up(double value) {
  return -rounded_down(-value);
}

}  // namespace

abut_status Tracer::make_device() {
  if (device_) return ABUT_OK;
  device_ = embree::Device(rtcNewDevice(nullptr));
  if (!device_) return ABUT_OUT_OF_MEMORY;
  const auto is_native = [&](RTCDeviceProperty property) { return rtcGetDeviceProperty(device_.get(), property) != 0; };
  widest_ = is_native(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)  ? 16
            : is_native(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8
                                                                   : 4;
  return ABUT_OK;
}

abut_status Tracer::embree_status() const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE) return ABUT_OK;
  return error == RTC_ERROR_OUT_OF_MEMORY ? ABUT_OUT_OF_MEMORY : ABUT_INTERNAL;
}

abut_status Tracer::build() {
  settle_still_space();
  if (still_changed_) {
    if (const abut_status status = build_still(); status != ABUT_OK) return status;
  }
  for (const std::uint32_t index : std::exchange(arrivals_, {})) {
    entries_[index].role = Role::instance;
    if (const abut_status status = become_moving(index); status != ABUT_OK) return status;
  }
  if (moving_changed_) {
    if (const abut_status status = build_moving(); status != ABUT_OK) return status;
  }
  return embree_status();
}

// Decides which of the surfaces that arrived are baked; the others stay in arrivals_. Baking builds
// the whole still scene anew, so few arrivals do not get it when much is there already: the sum of
// all builds stays in proportion to the triangles.
void Tracer::settle_still_space() {
  std::size_t arrived = 0;
  std::size_t present = 0;
  for (const Baked& baked : baked_) present += shapes_[entries_[baked.entry].shape].triangle_count;
  for (const std::uint32_t index : arrivals_) {
    const ShapeRecord& shape = shapes_[entries_[index].shape];
    if (shape.users == 1) arrived += shape.triangle_count;
  }
  const bool bakes = arrived != 0 && 2 * arrived >= present;
  if (!bakes && !still_changed_) return;
  std::vector<std::uint32_t> candidates;
  for (const Baked& baked : baked_) candidates.push_back(baked.entry);
  const auto is_candidate = [&](std::uint32_t index) { return bakes && shapes_[entries_[index].shape].users == 1; };
  std::ranges::copy_if(arrivals_, std::back_inserter(candidates), is_candidate);
  if (candidates.empty()) return;
  const auto diagonal = [&](std::uint32_t index) { return diagonal_of(entries_[index].box); };
  const std::uint32_t largest = *std::ranges::max_element(candidates, {}, diagonal);
  const Space around = space_around(entries_[largest].box);
  abut_aabb box = empty_box;
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t index : candidates) {
    const Entry& entry = entries_[index];
    if (entry.place == nowhere && reach_of(entry.box, around.origin) > farthest_baked * diagonal(index)) continue;
    kept.push_back(index);
    extend(box, entry.box.minimum);
    extend(box, entry.box.maximum);
  }
  still_space_ = space_around(box);
  for (const std::uint32_t index : kept) {
    Entry& entry = entries_[index];
    if (entry.place != nowhere) continue;
    entry.role = Role::baked;
    entry.place = static_cast<std::uint32_t>(baked_.size());
    baked_.push_back({.id = entry.id, .entry = index, .has_quads = false, .first_plane = 0});
    still_changed_ = true;
  }
  std::erase_if(arrivals_, [&](std::uint32_t index) { return entries_[index].place != nowhere; });
}

abut_status Tracer::build_still() {
  still_changed_ = false;
  still_.reset();
  still_planes_.clear();
  if (baked_.empty()) return ABUT_OK;
  still_ = embree::Scene(rtcNewScene(device_.get()));
  if (!still_) return ABUT_OUT_OF_MEMORY;
  const bool with_quads = prefers_quads();
  rtcSetSceneFlags(still_.get(), with_quads ? embree::filtered_scene | RTC_SCENE_FLAG_ROBUST : embree::filtered_scene);
  for (std::size_t i = 0; i < baked_.size(); ++i) {
    Baked& baked = baked_[i];
    const Entry& entry = entries_[baked.entry];
    TriangleList list;
    if (const abut_status status = shapes_[entry.shape].access->triangles(list); status != ABUT_OK) return status;
    // Relative to the space, so that what lies far from the origin of the world keeps its digits.
    Frame frame = entry.frame;
    frame.position = subtract(frame.position, still_space_.origin);
    for (std::size_t at = 0; at + 2 < list.xyz.size(); at += 3) {
      const abut_vec3 p = to_world(frame, {list.xyz[at], list.xyz[at + 1], list.xyz[at + 2]});
      list.xyz[at] = p.x;
      list.xyz[at + 1] = p.y;
      list.xyz[at + 2] = p.z;
    }
    baked.first_plane = still_planes_.size();
    add_planes(list, still_planes_);
    const Space around{{0, 0, 0}, still_space_.extent};
    baked.has_quads = with_quads && shapes_[entry.shape].is_paired;
    const embree::Geometry geometry = baked.has_quads ? make_quads(list, around) : make_triangles(list, around);
    if (!geometry) return ABUT_OUT_OF_MEMORY;
    rtcAttachGeometryByID(still_.get(), geometry.get(), static_cast<unsigned>(i));
  }
  rtcCommitScene(still_.get());
  return embree_status();
}

// Whether most triangles of the still scene come in pairs. All others pay for the robust mode.
bool Tracer::prefers_quads() const {
  std::size_t paired = 0;
  std::size_t all = 0;
  for (const Baked& baked : baked_) {
    const ShapeRecord& shape = shapes_[entries_[baked.entry].shape];
    paired += shape.is_paired ? shape.triangle_count : 0;
    all += shape.triangle_count;
  }
  return 2 * paired > all;
}

// A geometry of `count` polygons with corners of their own, which `write` puts down.
template <class Write>
embree::Geometry Tracer::make_polygons(std::size_t count, std::size_t sides, const Write& write) {
  const bool is_triangle = sides == 3;
  embree::Geometry geometry(
      rtcNewGeometry(device_.get(), is_triangle ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_QUAD));
  if (!geometry) return geometry;
  void* const vertices = rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 3 * sizeof(float), sides * count);
  void* const indices =
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0,
                              is_triangle ? RTC_FORMAT_UINT3 : RTC_FORMAT_UINT4, sides * sizeof(std::uint32_t), count);
  if (count != 0 && (vertices == nullptr || indices == nullptr)) return {};
  // SAFETY: Embree has just made these buffers with the sizes named in the two calls above.
  ABUT_UNSAFE_BEGIN
  const std::span<float> corners(static_cast<float*>(vertices), 3 * sides * count);
  const std::span<std::uint32_t> numbers(static_cast<std::uint32_t*>(indices), sides * count);
  ABUT_UNSAFE_END
  write(corners);
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<std::uint32_t>(i);
  rtcSetGeometryUserData(geometry.get(), this);
#if RTC_VERSION_MAJOR >= 4
  rtcSetGeometryEnableFilterFunctionFromArguments(geometry.get(), true);
#endif
  rtcCommitGeometry(geometry.get());
  return geometry;
}

embree::Geometry Tracer::make_triangles(const TriangleList& list, const Space& space) {
  return make_polygons(list.indices.size() / 3, 3, [&](std::span<float> out) { write_outlines(list, space, out); });
}

embree::Geometry Tracer::make_quads(const TriangleList& list, const Space& space) {
  return make_polygons(list.indices.size() / 6, 4, [&](std::span<float> out) { write_quads(list, space, out); });
}

abut_status Tracer::make_instanced(ShapeRecord& shape) {
  if (shape.instanced) return ABUT_OK;
  TriangleList list;
  if (const abut_status status = shape.access->triangles(list); status != ABUT_OK) return status;
  auto made = std::make_unique<Instanced>();
  made->space = space_around(shape.local_box);
  add_planes(list, made->surface);
  made->scene = embree::Scene(rtcNewScene(device_.get()));
  if (!made->scene) return ABUT_OUT_OF_MEMORY;
  rtcSetSceneFlags(made->scene.get(), embree::filtered_scene);
  const embree::Geometry geometry = make_triangles(list, made->space);
  if (!geometry) return ABUT_OUT_OF_MEMORY;
  rtcAttachGeometryByID(made->scene.get(), geometry.get(), 0);
  rtcCommitScene(made->scene.get());
  shape.instanced = std::move(made);
  return embree_status();
}

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
  const Space tight = space_around(box);
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
