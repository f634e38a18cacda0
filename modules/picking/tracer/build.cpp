// SPDX-License-Identifier: Apache-2.0
// Building what Embree traverses: surfaces as they lie, and those in the frames of their shapes.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/embree.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
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

// A surface is baked when the space reaches at most this many of its diagonals: the growth of its
// outlines, which is in proportion to the space, then stays below 2^-16 of the diagonal.
constexpr double farthest_baked = 16;

[[nodiscard]] Outlines outlines_of(bool is_steep) { return is_steep ? Outlines::both : Outlines::grown; }

}  // namespace

// Embree follows single rays faster with registers of 256 bits than of 512, by a twentieth, and packets the other
// way round: where there are both, each kind of query has a scene of its own.
abut_status Tracer::make_device() {
  if (device_ && (single_device_ || widest_ < 16)) return ABUT_OK;
  device_ = embree::Device(rtcNewDevice(nullptr));
  if (!device_) return ABUT_OUT_OF_MEMORY;
  const auto is_native = [&](RTCDeviceProperty property) { return rtcGetDeviceProperty(device_.get(), property) != 0; };
  widest_ = is_native(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)  ? 16
            : is_native(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8
                                                                   : 4;
  if (widest_ < 16) return ABUT_OK;
  single_device_ = embree::Device(rtcNewDevice("max_isa=avx2"));
  return single_device_ ? ABUT_OK : ABUT_OUT_OF_MEMORY;
}

abut_status Tracer::embree_status() const {
  RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_NONE && single_device_) error = rtcGetDeviceError(single_device_.get());
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
  if (const abut_status status = build_moving(); status != ABUT_OK) return status;
  settle_usual_rays();
  return embree_status();
}

void Tracer::settle_usual_rays() {
  const double reach = 2 * still_space_.extent;
  const bool has_usual = !baked_.empty() && !has_moving() && !skips_back_faces_ && clip_planes_.empty();
  usual_reach_ = has_usual ? Four{reach, reach, reach, infinity} : Four(-1);
}

// Decides which of the surfaces that arrived are baked; the others stay in arrivals_. Baking builds
// the whole still scene anew, so few arrivals do not get it when much is there already: the sum of
// all builds stays in proportion to the triangles.
void Tracer::settle_still_space() {
  if (arrivals_.empty() && !still_changed_) return;
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
    baked_.push_back({.id = entry.id, .entry = index, .first_face = nowhere, .has_quads = false, .first_plane = 0});
    still_changed_ = true;
  }
  std::erase_if(arrivals_, [&](std::uint32_t index) { return entries_[index].place != nowhere; });
}

abut_status Tracer::build_still() {
  still_changed_ = false;
  still_.reset();
  single_still_.reset();
  still_planes_.clear();
  still_faces_.clear();
  if (baked_.empty()) return ABUT_OK;
  const bool with_quads = prefers_quads();
  const bool is_robust = with_quads || std::ranges::any_of(baked_, [&](const Baked& baked) {
                           return shapes_[entries_[baked.entry].shape].is_steep;
                         });
  still_ = make_still(device_.get(), is_robust);
  single_still_ = single_device_ ? make_still(single_device_.get(), is_robust) : embree::Scene(still_.get());
  if (!still_ || !single_still_) return ABUT_OUT_OF_MEMORY;
  if (!single_device_) rtcRetainScene(still_.get());
  still_planes_.resize(planes_beside);
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
    baked.has_quads = with_quads && shapes_[entry.shape].is_paired && !shapes_[entry.shape].is_steep;
    baked.shift = shapes_[entry.shape].is_steep ? 1 : 0;
    baked.first_plane = still_planes_.size();
    const std::vector<std::uint32_t>& faces = shapes_[entry.shape].faces;
    baked.first_face = faces.empty() ? nowhere : static_cast<std::uint32_t>(still_faces_.size());
    still_faces_.insert(still_faces_.end(), faces.begin(), faces.end());
    add_planes(list, still_planes_);
    if (!attach(device_.get(), still_.get(), i, list)) return ABUT_OUT_OF_MEMORY;
    if (single_device_ && !attach(single_device_.get(), single_still_.get(), i, list)) return ABUT_OUT_OF_MEMORY;
  }
  still_planes_.resize(still_planes_.size() + planes_beside);
  rtcCommitScene(still_.get());
  if (single_device_) rtcCommitScene(single_still_.get());
  return embree_status();
}

embree::Scene Tracer::make_still(RTCDevice device, bool is_robust) {
  embree::Scene scene(rtcNewScene(device));
  if (scene)
    rtcSetSceneFlags(scene.get(), is_robust ? embree::filtered_scene | RTC_SCENE_FLAG_ROBUST : embree::filtered_scene);
  return scene;
}

bool Tracer::attach(RTCDevice device, RTCScene scene, std::size_t place, const TriangleList& list) {
  const Space around{{0, 0, 0}, still_space_.extent};
  const embree::Geometry geometry = baked_[place].has_quads
                                        ? make_quads(device, list, around)
                                        : make_triangles(device, list, around, outlines_of(baked_[place].shift != 0));
  if (geometry) rtcAttachGeometryByID(scene, geometry.get(), static_cast<unsigned>(place));
  return geometry != nullptr;
}

// Whether most triangles of the still scene come in pairs. All others pay for the robust mode.
bool Tracer::prefers_quads() const {
  std::size_t paired = 0;
  std::size_t all = 0;
  for (const Baked& baked : baked_) {
    const ShapeRecord& shape = shapes_[entries_[baked.entry].shape];
    paired += shape.is_paired && !shape.is_steep ? shape.triangle_count : 0;
    all += shape.triangle_count;
  }
  return 2 * paired > all;
}

// A geometry of `count` polygons with corners of their own, which `write` puts down.
template <class Write>
embree::Geometry Tracer::make_polygons(RTCDevice device, std::size_t count, std::size_t sides, const Write& write) {
  const bool is_triangle = sides == 3;
  embree::Geometry geometry(rtcNewGeometry(device, is_triangle ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_QUAD));
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

embree::Geometry Tracer::make_triangles(RTCDevice device, const TriangleList& list, const Space& space,
                                        Outlines outlines) {
  const std::size_t count = list.indices.size() / 3;
  return make_polygons(device, outlines == Outlines::both ? 2 * count : count, 3,
                       [&](std::span<float> out) { write_outlines(list, space, outlines, out); });
}

embree::Geometry Tracer::make_quads(RTCDevice device, const TriangleList& list, const Space& space) {
  return make_polygons(device, list.indices.size() / 6, 4,
                       [&](std::span<float> out) { write_quads(list, space, out); });
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
  rtcSetSceneFlags(made->scene.get(),
                   shape.is_steep ? embree::filtered_scene | RTC_SCENE_FLAG_ROBUST : embree::filtered_scene);
  const embree::Geometry geometry = make_triangles(device_.get(), list, made->space, outlines_of(shape.is_steep));
  if (!geometry) return ABUT_OUT_OF_MEMORY;
  rtcAttachGeometryByID(made->scene.get(), geometry.get(), 0);
  rtcCommitScene(made->scene.get());
  shape.instanced = std::move(made);
  return embree_status();
}

}  // namespace abut::picking
