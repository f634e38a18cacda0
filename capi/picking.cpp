// SPDX-License-Identifier: Apache-2.0
// picking.h: checks arguments, keeps exceptions in, and hands on to abut.picking.
#include <abut/picking.h>

#include "core/check.hpp"
#include "picking_arguments.hpp"
#include "picking_source.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "defaults.hpp"

import abut.picking;

struct abut_picker {
  abut::capi::Attachment attachment;
  abut::picking::Picker picker;
  std::unique_ptr<const abut_universe, abut::picking::Borrowed> universe;
};

namespace {

using abut::capi::check_camera;
using abut::capi::check_finite;
using abut::capi::check_fits;
using abut::capi::check_position;
using abut::capi::check_ray;
using abut::capi::check_rays;
using abut::capi::check_room;
using abut::capi::check_size;
using abut::capi::read_filter;
using abut::capi::refuse;
using abut::capi::refuse_null;

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

}  // namespace

void abut_camera_init(abut_camera* camera, uint32_t struct_size) {
  constexpr abut_camera usual{.struct_size = sizeof(abut_camera),
                              .width = 640,
                              .height = 480,
                              .reserved = 0,
                              .pose = {.position = {0, 0, 0}, .orientation = {1, 0, 0, 0}},
                              .vertical_fov = 1,
                              .near_distance = 0,
                              .far_distance = std::numeric_limits<double>::infinity()};
  abut::capi::fill_defaults(usual, struct_size, camera);
}

abut_status abut_camera_look_at(abut_camera* camera, const abut_vec3* eye, const abut_vec3* target,
                                const abut_vec3* up) {
  if (camera == nullptr) return refuse_null("camera");
  if (eye == nullptr) return refuse_null("eye");
  if (target == nullptr) return refuse_null("target");
  if (up == nullptr) return refuse_null("up");
  if (const abut_status status = check_size(*camera); status != ABUT_OK) return status;
  if (const abut_status status = check_position(*eye, "eye"); status != ABUT_OK) return status;
  if (const abut_status status = check_position(*target, "target"); status != ABUT_OK) return status;
  if (const abut_status status = check_finite(*up, "up"); status != ABUT_OK) return status;
  // Halves: the difference of two finite numbers may not be finite.
  const abut_vec3 forward{0.5 * target->x - 0.5 * eye->x, 0.5 * target->y - 0.5 * eye->y,
                          0.5 * target->z - 0.5 * eye->z};
  if (forward.x == 0 && forward.y == 0 && forward.z == 0) return refuse(ABUT_ZERO_VECTOR, "target coincides with eye");
  if (abut::picking::are_parallel(forward, *up))
    return refuse(ABUT_ZERO_VECTOR, "up is zero or parallel to the line of sight");
  camera->pose = {.position = *eye, .orientation = abut::picking::look_along(forward, *up)};
  return ABUT_OK;
}

abut_status abut_camera_ray(const abut_camera* camera, double x, double y, abut_ray* out) {
  if (camera == nullptr) return refuse_null("camera");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_camera(*camera); status != ABUT_OK) return status;
  if (!std::isfinite(x)) return refuse(ABUT_NOT_FINITE, "x", x, "it must be finite");
  if (!std::isfinite(y)) return refuse(ABUT_NOT_FINITE, "y", y, "it must be finite");
  *out = abut::picking::camera_ray(*camera, x, y);
  return ABUT_OK;
}

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
  if (coherence != ABUT_COHERENCE_NONE && coherence != ABUT_COHERENCE_NEIGHBOURS) {
    return refuse(ABUT_UNKNOWN_VALUE, "coherence", coherence, "it must be a value of abut_coherence");
  }
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
  using abut::picking::Coherence;
  const Coherence similar = coherence == ABUT_COHERENCE_NEIGHBOURS ? Coherence::neighbours : Coherence::none;
  return answer(picker->picker.cast_rays(all, similar, wanted, picks));
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
    // SAFETY: the caller answers for `capacity` elements.
    ABUT_UNSAFE_BEGIN
    const std::span<abut_pick> out(picks, capacity);
    ABUT_UNSAFE_END
    std::copy_n(all.begin(), std::min(capacity, all.size()), out.begin());
    *count = all.size();
    return ABUT_OK;
  });
}

abut_status abut_picker_pick_pixel(abut_picker* picker, const abut_camera* camera, double x, double y, double radius,
                                   const abut_query_filter* filter, abut_pick* out) {
  if (picker == nullptr) return refuse_null("picker");
  if (camera == nullptr) return refuse_null("camera");
  if (out == nullptr) return refuse_null("out");
  if (const abut_status status = check_camera(*camera); status != ABUT_OK) return status;
  if (!std::isfinite(x)) return refuse(ABUT_NOT_FINITE, "x", x, "it must be finite");
  if (!std::isfinite(y)) return refuse(ABUT_NOT_FINITE, "y", y, "it must be finite");
  if (!std::isfinite(radius)) return refuse(ABUT_NOT_FINITE, "radius", radius, "it must be finite");
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
