// SPDX-License-Identifier: Apache-2.0
// Cameras of picking.h: defaults, where they look, and what a projection matrix says of them.
#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>

#include "defaults.hpp"

import abut.picking;

namespace {

using abut::capi::check_camera;
using abut::capi::check_finite;
using abut::capi::check_pixel;
using abut::capi::check_position;
using abut::capi::check_size;
using abut::capi::refuse;
using abut::capi::refuse_null;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Column by column.
using Matrix = std::span<const double, 16>;

[[nodiscard]] abut_status refuse_element(abut_status status, Matrix matrix, std::size_t element,
                                         const char* expectation) noexcept {
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "matrix[%zu]", element);
  return refuse(status, name.data(), matrix[element], expectation);
}

// Which elements a projection has: scales and shifts across, two of the depth, and where w comes from.
[[nodiscard]] abut_status check_form(Matrix matrix) noexcept {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    if (!std::isfinite(matrix[i])) return refuse_element(ABUT_NOT_FINITE, matrix, i, "it must be finite");
  }
  const bool is_perspective = matrix[11] != 0;
  if (matrix[11] > 0) {
    return refuse_element(ABUT_UNSUPPORTED, matrix, 11,
                          "it must be negative in a perspective and 0 in an orthographic projection, since cameras "
                          "look along -Z");
  }
  if (is_perspective ? matrix[15] != 0 : !(matrix[15] > 0)) {
    return refuse_element(ABUT_UNSUPPORTED, matrix, 15,
                          "it must be 0 in a perspective and positive in an orthographic projection");
  }
  for (const std::size_t i : {1U, 2U, 3U, 4U, 6U, 7U, is_perspective ? 12U : 8U, is_perspective ? 13U : 9U}) {
    if (matrix[i] != 0) return refuse_element(ABUT_UNSUPPORTED, matrix, i, "it must be 0 in a projection");
  }
  if (!(matrix[0] > 0)) return refuse_element(ABUT_UNSUPPORTED, matrix, 0, "it must be positive");
  if (!(matrix[5] > 0))
    return refuse_element(ABUT_UNSUPPORTED, matrix, 5, "it must be positive: negate row 1 where +Y is down");
  const std::size_t depth = is_perspective ? 14 : 10;
  if (matrix[depth] == 0) return refuse_element(ABUT_UNSUPPORTED, matrix, depth, "depths must differ");
  return ABUT_OK;
}

// The depth before the eye that a perspective projection maps to `z`, from z = constant + slope / depth. Behind the eye
// there is none, and none is as far as that of a projection without an end.
[[nodiscard]] double depth_of(double z, double constant, double slope) noexcept {
  const double depth = slope / (z - constant);
  return depth > 0 ? depth : infinity;
}

void read_projection(Matrix matrix, abut_clip_depth clip, abut_camera& camera) noexcept {
  const bool is_perspective = matrix[11] != 0;
  const double w = is_perspective ? -matrix[11] : matrix[15];
  const double width = 0.5 * static_cast<double>(camera.width);
  const double height = 0.5 * static_cast<double>(camera.height);
  const double nearest_z = clip == ABUT_CLIP_DEPTH_SIGNED ? -1 : 0;
  const double z_scale = matrix[10] / w;
  const double z_shift = matrix[14] / w;
  double near = 0;
  double far = 0;
  if (is_perspective) {
    camera.vertical_fov = 2 * std::atan(w / matrix[5]);
    camera.shift_x = -matrix[8] / w * width;
    camera.shift_y = matrix[9] / w * height;
    near = depth_of(nearest_z, -z_scale, z_shift);
    far = depth_of(1, -z_scale, z_shift);
  } else {
    camera.vertical_extent = 2 * w / matrix[5];
    camera.shift_x = matrix[12] / w * width;
    camera.shift_y = -matrix[13] / w * height;
    near = (z_shift - nearest_z) / z_scale;
    far = (z_shift - 1) / z_scale;
  }
  camera.projection = is_perspective ? ABUT_PROJECTION_PERSPECTIVE : ABUT_PROJECTION_ORTHOGRAPHIC;
  camera.pixel_aspect = matrix[5] * height / (matrix[0] * width);
  // Reversed depth maps the far plane to the lower end.
  camera.near_distance = std::min(near, far);
  camera.far_distance = std::max(near, far);
  camera.depth_axis = ABUT_DEPTH_ALONG_AXIS;
}

}  // namespace

void abut_camera_init(abut_camera* camera, uint32_t struct_size) {
  constexpr abut_camera usual{.struct_size = sizeof(abut_camera),
                              .width = 640,
                              .height = 480,
                              .projection = ABUT_PROJECTION_PERSPECTIVE,
                              .pose = {.position = {0, 0, 0}, .orientation = {1, 0, 0, 0}},
                              .vertical_fov = 1,
                              .near_distance = 0,
                              .far_distance = std::numeric_limits<double>::infinity(),
                              .vertical_extent = 1,
                              .pixel_aspect = 1,
                              .shift_x = 0,
                              .shift_y = 0,
                              .depth_axis = ABUT_DEPTH_ALONG_RAY,
                              .reserved = 0};
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
  if (const abut_status status = check_pixel(x, "x"); status != ABUT_OK) return status;
  if (const abut_status status = check_pixel(y, "y"); status != ABUT_OK) return status;
  *out = abut::picking::camera_ray(*camera, x, y);
  return ABUT_OK;
}

abut_status abut_camera_set_projection(abut_camera* camera, const double* matrix, abut_clip_depth depth) {
  if (camera == nullptr) return refuse_null("camera");
  if (matrix == nullptr) return refuse_null("matrix");
  if (const abut_status status = check_size(*camera); status != ABUT_OK) return status;
  if (depth > ABUT_CLIP_DEPTH_UNSIGNED)
    return refuse(ABUT_UNKNOWN_VALUE, "depth", depth, "it must be a value of abut_clip_depth");
  // SAFETY: the caller answers for 16 elements.
  ABUT_UNSAFE_BEGIN
  const Matrix elements(matrix, 16);
  ABUT_UNSAFE_END
  if (const abut_status status = check_form(elements); status != ABUT_OK) return status;
  // A copy has no more than the fields of this version.
  abut_camera changed = *camera;
  changed.struct_size = sizeof changed;
  read_projection(elements, depth, changed);
  if (const abut_status status = check_camera(changed); status != ABUT_OK) return status;
  changed.struct_size = camera->struct_size;
  *camera = changed;
  return ABUT_OK;
}
