// SPDX-License-Identifier: Apache-2.0
// picking.h: checks arguments, keeps exceptions in, and hands on to abut.picking.
#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/arguments.hpp"
#include "picking/source.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

import abut.picking;

struct abut_picker {
  abut::capi::Attachment attachment;
  abut::picking::Picker picker;
  std::unique_ptr<const abut_universe, abut::picking::Borrowed> universe;
};

namespace {

using abut::capi::check_camera;
using abut::capi::check_clip_planes;
using abut::capi::check_fits;
using abut::capi::check_pixel;
using abut::capi::check_position;
using abut::capi::check_ray;
using abut::capi::check_rays;
using abut::capi::check_room;
using abut::capi::read_filter;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::capi::refuse_stale;

// By count-then-fill.
template <class T>
void hand_out(const std::vector<T>& all, T* to, std::size_t capacity, std::size_t& count) {
  // SAFETY: the caller answers for `capacity` elements.
  ABUT_UNSAFE_BEGIN
  const std::span<T> out(to, capacity);
  ABUT_UNSAFE_END
  std::copy_n(all.begin(), std::min(capacity, all.size()), out.begin());
  count = all.size();
}

// A failure inside: the universe has written a message of its own when it was the one that failed.
[[nodiscard]] abut_status answer(abut_status status) noexcept {
  if (status == ABUT_OK) return ABUT_OK;
  if (status == ABUT_OUT_OF_MEMORY) return refuse(status, "there is not enough memory for the scene of rays");
  if (status == ABUT_INTERNAL) return refuse(status, "the scene of rays could not be built or traced");
  return status;
}

template <class Action>
[[nodiscard]] abut_status guarded(const Action& action) noexcept {
  try {
    return answer(action());
  } catch (const std::bad_alloc&) {
    return answer(ABUT_OUT_OF_MEMORY);
  } catch (...) {
    return answer(ABUT_INTERNAL);
  }
}

[[nodiscard]] abut_status read_coherence(abut_coherence given, abut::picking::Coherence& out) noexcept {
  if (given != ABUT_COHERENCE_NONE && given != ABUT_COHERENCE_NEIGHBOURS)
    return refuse(ABUT_UNKNOWN_VALUE, "coherence", given, "it must be a value of abut_coherence");
  using abut::picking::Coherence;
  out = given == ABUT_COHERENCE_NEIGHBOURS ? Coherence::neighbours : Coherence::none;
  return ABUT_OK;
}

}  // namespace

abut_status abut_picker_create(abut_universe* universe, abut_picker** out) {
  if (universe == nullptr) return refuse_null("universe");
  if (out == nullptr) return refuse_null("out");
  return guarded([&]() -> abut_status {
    abut::picking::Counters counters;
    if (const abut_status status = abut::capi::borrow_counters(universe, counters); status != ABUT_OK) return status;
    abut::capi::Attachment attachment;
    if (const abut_status status = abut::capi::attach(universe, attachment); status != ABUT_OK) return status;
    auto source = std::make_unique<abut::capi::UniverseSource>(universe);
    auto picker = std::make_unique<abut_picker>(
        abut_picker{.attachment = std::move(attachment),
                    .picker = abut::picking::Picker(std::move(source), std::move(counters)),
                    .universe = std::unique_ptr<const abut_universe, abut::picking::Borrowed>(universe)});
    *out = picker.release();
    return ABUT_OK;
  });
}

void abut_picker_destroy(abut_picker* picker) { const std::unique_ptr<abut_picker> owned(picker); }

abut_status abut_picker_update(abut_picker* picker) {
  if (picker == nullptr) return refuse_null("picker");
  return guarded([&] { return picker->picker.update(); });
}

abut_status abut_picker_set_flags(abut_picker* picker, abut_picker_flags flags) {
  if (picker == nullptr) return refuse_null("picker");
  if (flags > (ABUT_PICKER_SENSORS | ABUT_PICKER_SKIP_BACK_FACES))
    return refuse(ABUT_UNKNOWN_VALUE, "flags", flags, "it must be bits of abut_picker_flags");
  picker->picker.set_flags((flags & ABUT_PICKER_SENSORS) != 0, (flags & ABUT_PICKER_SKIP_BACK_FACES) != 0);
  return ABUT_OK;
}

abut_status abut_picker_set_clip_planes(abut_picker* picker, const abut_clip_plane* planes, std::size_t count) {
  constexpr std::size_t most = 32;
  if (picker == nullptr) return refuse_null("picker");
  if (const abut_status status = check_fits("count", count, sizeof(abut_clip_plane)); status != ABUT_OK) return status;
  if (count > most)
    return refuse(ABUT_OUT_OF_RANGE, "count", static_cast<double>(count), "a picker has at most 32 clip planes");
  if (planes == nullptr && count != 0) return refuse_null("planes");
  // SAFETY: the caller answers for `count` elements.
  ABUT_UNSAFE_BEGIN
  const std::span<const abut_clip_plane> all(planes, count);
  ABUT_UNSAFE_END
  if (const abut_status status = check_clip_planes(all); status != ABUT_OK) return status;
  return answer(picker->picker.set_clip_planes(all));
}

abut_status abut_picker_cast_ray(abut_picker* picker, const abut_ray* ray, const abut_query_filter* filter,
                                 abut_pick* out) {
  if (picker == nullptr) return refuse_null("picker");
  if (ray == nullptr) return refuse_null("ray");
  if (out == nullptr) return refuse_null("out");
  // Before the checks: a ray that is refused is not usual.
  if (filter == nullptr && picker->picker.cast_usual_ray(*ray, *out)) [[likely]]
    return ABUT_OK;
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = check_ray(*ray); status != ABUT_OK) return status;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  return answer(picker->picker.cast_ray(*ray, wanted, *out));
}

abut_status abut_picker_cast_rays(abut_picker* picker, const abut_ray* rays, std::size_t count,
                                  abut_coherence coherence, const abut_query_filter* filter, abut_pick* out) {
  if (picker == nullptr) return refuse_null("picker");
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  abut::picking::Coherence similar{};
  if (const abut_status status = read_coherence(coherence, similar); status != ABUT_OK) return status;
  if (count == 0) return answer(picker->picker.update());
  if (rays == nullptr) return refuse_null("rays");
  if (out == nullptr) return refuse_null("out");
  constexpr std::size_t size = std::max(sizeof(abut_ray), sizeof(abut_pick));
  if (const abut_status status = check_fits("count", count, size); status != ABUT_OK) return status;
  // SAFETY: the caller answers for `count` elements in both arrays.
  ABUT_UNSAFE_BEGIN
  const std::span<const abut_ray> all(rays, count);
  const std::span<abut_pick> picks(out, count);
  ABUT_UNSAFE_END
  if (const abut_status status = check_rays(all); status != ABUT_OK) return status;
  return answer(picker->picker.cast_rays(all, similar, wanted, picks));
}

abut_status abut_picker_ray_hits(abut_picker* picker, const abut_ray* ray, const abut_query_filter* filter,
                                 uint32_t* out) {
  if (picker == nullptr) return refuse_null("picker");
  if (ray == nullptr) return refuse_null("ray");
  if (out == nullptr) return refuse_null("out");
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = check_ray(*ray); status != ABUT_OK) return status;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  return answer(picker->picker.meets(*ray, wanted, *out));
}

abut_status abut_picker_rays_hit(abut_picker* picker, const abut_ray* rays, std::size_t count, abut_coherence coherence,
                                 const abut_query_filter* filter, uint32_t* out) {
  if (picker == nullptr) return refuse_null("picker");
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  abut::picking::Coherence similar{};
  if (const abut_status status = read_coherence(coherence, similar); status != ABUT_OK) return status;
  if (count == 0) return answer(picker->picker.update());
  if (rays == nullptr) return refuse_null("rays");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_fits("count", count, sizeof(abut_ray)); status != ABUT_OK) return status;
  // SAFETY: the caller answers for `count` elements in both arrays.
  ABUT_UNSAFE_BEGIN
  const std::span<const abut_ray> all(rays, count);
  const std::span<std::uint32_t> answers(out, count);
  ABUT_UNSAFE_END
  if (const abut_status status = check_rays(all); status != ABUT_OK) return status;
  return answer(picker->picker.meet(all, similar, wanted, answers));
}

abut_status abut_picker_cast_ray_all(abut_picker* picker, const abut_ray* ray, const abut_query_filter* filter,
                                     abut_pick* picks, std::size_t capacity, std::size_t* count) {
  if (picker == nullptr) return refuse_null("picker");
  if (ray == nullptr) return refuse_null("ray");
  if (count == nullptr) return refuse_null("count");
  if (const abut_status status = check_room("picks", picks, capacity, sizeof *picks); status != ABUT_OK) return status;
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = check_ray(*ray); status != ABUT_OK) return status;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  return guarded([&]() -> abut_status {
    std::vector<abut_pick> all;
    if (const abut_status status = picker->picker.cast_ray_all(*ray, wanted, all); status != ABUT_OK) return status;
    hand_out(all, picks, capacity, *count);
    return ABUT_OK;
  });
}

abut_status abut_picker_pick_pixel(abut_picker* picker, const abut_camera* camera, double x, double y, double radius,
                                   const abut_query_filter* filter, abut_pick* out) {
  if (picker == nullptr) return refuse_null("picker");
  if (camera == nullptr) return refuse_null("camera");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_camera(*camera); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(x, "x"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(y, "y"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(radius, "radius"); status != ABUT_OK) return status;
  if (radius < 0) return refuse(ABUT_OUT_OF_RANGE, "radius", radius, "it must be at least 0");
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  return guarded([&] { return picker->picker.pick_pixel(*camera, x, y, radius, wanted, *out); });
}

abut_status abut_picker_render(abut_picker* picker, const abut_camera* camera, const abut_query_filter* filter,
                               abut_pick* out, std::size_t capacity) {
  if (picker == nullptr) return refuse_null("picker");
  if (camera == nullptr) return refuse_null("camera");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_camera(*camera); status != ABUT_OK) return status;
  const std::uint64_t pixels = std::uint64_t{camera->width} * camera->height;
  if (const abut_status status = check_fits("camera.width * camera.height", pixels, sizeof(abut_pick));
      status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = check_room("out", out, capacity, sizeof *out); status != ABUT_OK) return status;
  if (capacity < pixels) {
    return refuse(ABUT_OUT_OF_RANGE, "capacity", static_cast<double>(capacity),
                  "it must be at least camera.width * camera.height");
  }
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  // SAFETY: the caller answers for `capacity` elements, and the picture has no more.
  ABUT_UNSAFE_BEGIN
  const std::span<abut_pick> picture(out, pixels);
  ABUT_UNSAFE_END
  return guarded([&] { return picker->picker.render(*camera, wanted, picture); });
}

abut_status abut_picker_select_rectangle(abut_picker* picker, const abut_camera* camera, double x0, double y0,
                                         double x1, double y1, abut_selection selection,
                                         const abut_query_filter* filter, abut_geometry_id* geometries,
                                         std::size_t capacity, std::size_t* count) {
  if (picker == nullptr) return refuse_null("picker");
  if (camera == nullptr) return refuse_null("camera");
  if (count == nullptr) return refuse_null("count");
  if (const abut_status status = check_camera(*camera); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(x0, "x0"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(y0, "y0"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(x1, "x1"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(y1, "y1"); status != ABUT_OK) return status;
  if (selection > ABUT_SELECTION_INSIDE)
    return refuse(ABUT_UNKNOWN_VALUE, "selection", selection, "it must be a value of abut_selection");
  if (const abut_status status = check_room("geometries", geometries, capacity, sizeof *geometries); status != ABUT_OK)
    return status;
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  return guarded([&]() -> abut_status {
    std::vector<abut_geometry_id> all;
    const bool inside = selection == ABUT_SELECTION_INSIDE;
    if (const abut_status status = picker->picker.select(*camera, {x0, y0, x1, y1}, inside, wanted, all);
        status != ABUT_OK) {
      return status;
    }
    hand_out(all, geometries, capacity, *count);
    return ABUT_OK;
  });
}

abut_status abut_picker_snap(abut_picker* picker, const abut_camera* camera, double x, double y, double radius,
                             abut_snap_kinds kinds, const abut_query_filter* filter, abut_snap* out) {
  constexpr abut_snap_kinds all = ABUT_SNAP_VERTEX | ABUT_SNAP_MIDPOINT | ABUT_SNAP_EDGE;
  if (picker == nullptr) return refuse_null("picker");
  if (camera == nullptr) return refuse_null("camera");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_camera(*camera); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(x, "x"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(y, "y"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(radius, "radius"); status != ABUT_OK) return status;
  if (radius < 0) return refuse(ABUT_OUT_OF_RANGE, "radius", radius, "it must be at least 0");
  if (kinds > all) return refuse(ABUT_UNKNOWN_VALUE, "kinds", kinds, "it must be bits of abut_snap_kinds");
  const abut_query_filter* wanted = nullptr;
  if (const abut_status status = read_filter(picker->universe.get(), filter, wanted); status != ABUT_OK) return status;
  return answer(picker->picker.snap(*camera, x, y, radius, kinds == 0 ? all : kinds, wanted, *out));
}

abut_status abut_picker_barycentric(abut_picker* picker, abut_geometry_id geometry, uint32_t face,
                                    const abut_vec3* point, abut_barycentric* out) {
  if (picker == nullptr) return refuse_null("picker");
  if (point == nullptr) return refuse_null("point");
  if (out == nullptr) return refuse_null("out");
  abut_pose pose;
  if (abut_geometries_poses(picker->universe.get(), &geometry, 1, &pose) == ABUT_STALE_ID)
    return refuse_stale("geometry", geometry);
  if (const abut_status status = check_position(*point, "point"); status != ABUT_OK) return status;
  const abut_status status = picker->picker.weigh(geometry, face, *point, *out);
  switch (status) {
    case ABUT_STALE_ID:
      return refuse(ABUT_UNSUPPORTED, "geometry.slot", geometry.slot,
                    "rays do not meet this geometry: it is parked, a sensor, or without layers");
    case ABUT_UNSUPPORTED: return refuse(status, "geometry.slot", geometry.slot, "its shape has no triangles");
    case ABUT_INDEX_OUT_OF_RANGE: return refuse(status, "face", face, "the geometry has no such face");
    case ABUT_ZERO_VECTOR: return refuse(status, "face", face, "its triangles have no area");
    default: return answer(status);
  }
}
