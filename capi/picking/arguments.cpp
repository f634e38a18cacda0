// SPDX-License-Identifier: Apache-2.0
#include "picking/arguments.hpp"

#include "core/check.hpp"

#include <abut/picking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>
#include <span>

namespace abut::capi {

namespace {

// Which ray a refusal is about: "ray", or one of "rays".
constexpr std::size_t the_only_one = std::numeric_limits<std::size_t>::max();

[[nodiscard]] abut_status refuse_ray(abut_status status, std::size_t index, const char* field, double value,
                                     const char* expectation) noexcept {
  std::array<char, 64> name{};
  if (index == the_only_one) {
    std::snprintf(name.data(), name.size(), "ray.%s", field);
  } else {
    std::snprintf(name.data(), name.size(), "rays[%zu].%s", index, field);
  }
  return refuse(status, name.data(), value, expectation);
}

// Coordinates beyond this are refused by all of abut: their squares and cubes would overflow.
constexpr double largest_coordinate = 1e70;

[[nodiscard]] bool is_zero(const abut_vec3& v) noexcept { return v.x == 0 && v.y == 0 && v.z == 0; }

// Whether four rays are good at a glance: the squares of their directions neither vanish nor overflow.
[[nodiscard]] bool are_plainly_good(std::span<const abut_ray, 4> rays) noexcept {
  using Four = double __attribute__((ext_vector_type(4)));
  Four sum = 0;  // of sizes: too large when one is, and NaN when one is no number
  for (const abut_ray& ray : rays) {
    sum += __builtin_elementwise_abs(Four{ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x});
  }
  const Four x{rays[0].direction.x, rays[1].direction.x, rays[2].direction.x, rays[3].direction.x};
  const Four y{rays[0].direction.y, rays[1].direction.y, rays[2].direction.y, rays[3].direction.y};
  const Four z{rays[0].direction.z, rays[1].direction.z, rays[2].direction.z, rays[3].direction.z};
  const Four limit{rays[0].max_distance, rays[1].max_distance, rays[2].max_distance, rays[3].max_distance};
  const Four square = x * x + y * y + z * z;
  return __builtin_reduce_and((sum <= largest_coordinate) & (square > 1e-200) & (square < 1e140) & (limit >= 0)) != 0;
}

[[nodiscard]] abut_status judge(const abut_ray& ray, std::size_t index) noexcept {
  const auto refusal = [index](abut_status status, const char* field, double value, const char* expectation) {
    return refuse_ray(status, index, field, value, expectation);
  };
  for (const double coordinate : {ray.origin.x, ray.origin.y, ray.origin.z}) {
    if (!std::isfinite(coordinate)) return refusal(ABUT_NOT_FINITE, "origin", coordinate, "it must be finite");
    if (std::fabs(coordinate) > largest_coordinate)
      return refusal(ABUT_OUT_OF_RANGE, "origin", coordinate, "its coordinates must be within 1e70");
  }
  for (const double coordinate : {ray.direction.x, ray.direction.y, ray.direction.z}) {
    if (!std::isfinite(coordinate)) return refusal(ABUT_NOT_FINITE, "direction", coordinate, "it must be finite");
  }
  if (is_zero(ray.direction)) return refusal(ABUT_ZERO_VECTOR, "direction", 0, "it must have a length");
  if (std::isnan(ray.max_distance))
    return refusal(ABUT_NOT_FINITE, "max_distance", ray.max_distance, "it must be a number");
  if (ray.max_distance < 0)
    return refusal(ABUT_OUT_OF_RANGE, "max_distance", ray.max_distance, "it must be at least 0");
  return ABUT_OK;
}

// Sizes and places in pixels.
[[nodiscard]] abut_status check_pixels_of(const abut_camera& camera) noexcept {
  if (!std::isfinite(camera.vertical_extent))
    return refuse(ABUT_NOT_FINITE, "camera.vertical_extent", camera.vertical_extent, "it must be finite");
  if (!(camera.vertical_extent > 0))
    return refuse(ABUT_OUT_OF_RANGE, "camera.vertical_extent", camera.vertical_extent, "it must be positive");
  if (!std::isfinite(camera.pixel_aspect))
    return refuse(ABUT_NOT_FINITE, "camera.pixel_aspect", camera.pixel_aspect, "it must be finite");
  if (!(camera.pixel_aspect > 0))
    return refuse(ABUT_OUT_OF_RANGE, "camera.pixel_aspect", camera.pixel_aspect, "it must be positive");
  if (!std::isfinite(camera.shift_x))
    return refuse(ABUT_NOT_FINITE, "camera.shift_x", camera.shift_x, "it must be finite");
  if (!std::isfinite(camera.shift_y))
    return refuse(ABUT_NOT_FINITE, "camera.shift_y", camera.shift_y, "it must be finite");
  return ABUT_OK;
}

// Null ids name nothing; any other has to be there.
[[nodiscard]] abut_status check_ignored(const abut_universe* universe, const abut_query_filter& filter) noexcept {
  const abut_part_id& part = filter.ignore_part;
  abut_pose pose;
  if ((part.slot != 0 || part.generation != 0) && abut_part_pose(universe, part, &pose) == ABUT_STALE_ID)
    return refuse(ABUT_STALE_ID, "filter.ignore_part.slot", part.slot, "the part is not in this universe");
  const abut_geometry_id& geometry = filter.ignore_geometry;
  if ((geometry.slot != 0 || geometry.generation != 0) &&
      abut_geometries_poses(universe, &geometry, 1, &pose) == ABUT_STALE_ID) {
    return refuse(ABUT_STALE_ID, "filter.ignore_geometry.slot", geometry.slot, "the geometry is not in this universe");
  }
  return ABUT_OK;
}

}  // namespace

abut_status check_finite(const abut_vec3& vector, const char* argument) noexcept {
  if (!std::isfinite(vector.x)) return refuse(ABUT_NOT_FINITE, argument, vector.x, "its x must be finite");
  if (!std::isfinite(vector.y)) return refuse(ABUT_NOT_FINITE, argument, vector.y, "its y must be finite");
  if (!std::isfinite(vector.z)) return refuse(ABUT_NOT_FINITE, argument, vector.z, "its z must be finite");
  return ABUT_OK;
}

abut_status check_position(const abut_vec3& vector, const char* argument) noexcept {
  if (const abut_status status = check_finite(vector, argument); status != ABUT_OK) return status;
  for (const double coordinate : {vector.x, vector.y, vector.z}) {
    if (std::fabs(coordinate) > largest_coordinate)
      return refuse(ABUT_OUT_OF_RANGE, argument, coordinate, "its coordinates must be within 1e70");
  }
  return ABUT_OK;
}

abut_status check_size(const abut_camera& camera) noexcept {
  if (has_known_size(camera)) return ABUT_OK;
  return refuse(ABUT_WRONG_STRUCT_SIZE, "camera.struct_size", camera.struct_size,
                "fill the camera with abut_camera_init");
}

abut_status check_camera(const abut_camera& camera) noexcept {
  if (const abut_status status = check_size(camera); status != ABUT_OK) return status;
  if (camera.reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "camera.reserved", camera.reserved, "it must be 0");
  if (camera.projection > ABUT_PROJECTION_ORTHOGRAPHIC) {
    return refuse(ABUT_UNKNOWN_VALUE, "camera.projection", camera.projection, "it must be a value of abut_projection");
  }
  if (camera.depth_axis > ABUT_DEPTH_ALONG_AXIS) {
    return refuse(ABUT_UNKNOWN_VALUE, "camera.depth_axis", camera.depth_axis, "it must be a value of abut_depth_axis");
  }
  if (camera.width == 0) return refuse(ABUT_OUT_OF_RANGE, "camera.width", 0, "it must be at least 1");
  if (camera.height == 0) return refuse(ABUT_OUT_OF_RANGE, "camera.height", 0, "it must be at least 1");
  if (const abut_status status = check_position(camera.pose.position, "camera.pose.position"); status != ABUT_OK)
    return status;
  const abut_quat& q = camera.pose.orientation;
  const double norm = std::hypot(std::hypot(q.w, q.x), std::hypot(q.y, q.z));
  if (!std::isfinite(norm))
    return refuse(ABUT_NOT_FINITE, "length of camera.pose.orientation", norm, "it must be finite");
  if (norm == 0) return refuse(ABUT_ZERO_VECTOR, "length of camera.pose.orientation", norm, "it must be 1");
  if (std::fabs(norm - 1) > 1e-3)
    return refuse(ABUT_NOT_UNIT, "length of camera.pose.orientation", norm, "it must be 1");
  if (!std::isfinite(camera.vertical_fov))
    return refuse(ABUT_NOT_FINITE, "camera.vertical_fov", camera.vertical_fov, "it must be finite");
  if (!(camera.vertical_fov > 0 && camera.vertical_fov < std::numbers::pi)) {
    return refuse(ABUT_OUT_OF_RANGE, "camera.vertical_fov", camera.vertical_fov, "it must lie between 0 and pi");
  }
  if (!std::isfinite(camera.near_distance)) {
    return refuse(ABUT_NOT_FINITE, "camera.near_distance", camera.near_distance, "it must be finite");
  }
  const bool may_be_behind = camera.projection == ABUT_PROJECTION_ORTHOGRAPHIC;
  if (camera.near_distance < 0 && !may_be_behind) {
    return refuse(ABUT_OUT_OF_RANGE, "camera.near_distance", camera.near_distance,
                  "it must be at least 0 in a perspective camera");
  }
  if (!(std::fabs(camera.near_distance) <= largest_coordinate))
    return refuse(ABUT_OUT_OF_RANGE, "camera.near_distance", camera.near_distance, "its size must be at most 1e70");
  if (std::isnan(camera.far_distance))
    return refuse(ABUT_NOT_FINITE, "camera.far_distance", camera.far_distance, "it must be a number");
  if (camera.far_distance < camera.near_distance) {
    return refuse(ABUT_OUT_OF_RANGE, "camera.far_distance", camera.far_distance, "it must be at least near_distance");
  }
  return check_pixels_of(camera);
}

abut_status check_pixel(double pixels, const char* argument) noexcept {
  return std::isfinite(pixels) ? ABUT_OK : refuse(ABUT_NOT_FINITE, argument, pixels, "it must be finite");
}

abut_status check_clip_planes(std::span<const abut_clip_plane> planes) noexcept {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    std::array<char, 32> name{};
    std::snprintf(name.data(), name.size(), "planes[%zu].normal", i);
    const abut_clip_plane& plane = planes[i];
    if (const abut_status status = check_finite(plane.normal, name.data()); status != ABUT_OK) return status;
    if (is_zero(plane.normal)) return refuse(ABUT_ZERO_VECTOR, name.data(), 0, "it must have a length");
    std::snprintf(name.data(), name.size(), "planes[%zu].offset", i);
    if (!std::isfinite(plane.offset)) return refuse(ABUT_NOT_FINITE, name.data(), plane.offset, "it must be finite");
    if (std::fabs(plane.offset) > largest_coordinate)
      return refuse(ABUT_OUT_OF_RANGE, name.data(), plane.offset, "its size must be at most 1e70");
  }
  return ABUT_OK;
}

abut_status read_filter(const abut_universe* universe, const abut_query_filter* filter,
                        const abut_query_filter*& out) noexcept {
  out = nullptr;
  if (filter == nullptr) return ABUT_OK;
  if (!has_known_size(*filter)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "filter.struct_size", filter->struct_size,
                  "fill the filter with abut_query_filter_init");
  }
  if (filter->reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "filter.reserved", filter->reserved, "it must be 0");
  if (filter->flags > ABUT_QUERY_FILTER_SKIP_SENSORS)
    return refuse(ABUT_UNKNOWN_VALUE, "filter.flags", filter->flags, "it must be bits of abut_query_filter_flags");
  if (filter->ray_start > ABUT_RAY_START_SKIP)
    return refuse(ABUT_UNKNOWN_VALUE, "filter.ray_start", filter->ray_start, "it must be a value of abut_ray_start");
  if (filter->ray_start != ABUT_RAY_START_FAR_SIDE) {
    return refuse(ABUT_UNSUPPORTED, "filter.ray_start", filter->ray_start,
                  "a picker knows ABUT_RAY_START_FAR_SIDE only");
  }
  if (const abut_status status = check_ignored(universe, *filter); status != ABUT_OK) return status;
  const bool keeps_all = filter->flags == 0 && filter->ignore_part.slot == 0 && filter->ignore_geometry.slot == 0 &&
                         filter->layers == ~std::uint64_t{0} && filter->mask == ~std::uint64_t{0};
  out = keeps_all ? nullptr : filter;
  return ABUT_OK;
}

abut_status check_ray(const abut_ray& ray) noexcept { return judge(ray, the_only_one); }

abut_status check_rays(std::span<const abut_ray> rays) noexcept {
  constexpr std::size_t step = 4;
  for (std::size_t i = 0; i < rays.size();) {
    if (rays.size() - i >= step && are_plainly_good(rays.subspan(i).first<step>())) [[likely]] {
      i += step;
      continue;
    }
    if (const abut_status status = judge(rays[i], i); status != ABUT_OK) return status;
    ++i;
  }
  return ABUT_OK;
}

}  // namespace abut::capi
