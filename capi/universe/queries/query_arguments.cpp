// SPDX-License-Identifier: Apache-2.0
#include "universe/queries/query_arguments.hpp"

#include "options.hpp"

import abut.core;
import abut.math;

namespace abut::capi {
namespace {

constexpr abut_query_filter default_filter{sizeof(abut_query_filter), 0, ~std::uint64_t{0}, ~std::uint64_t{0}, {}, {},
                                           ABUT_RAY_START_FAR_SIDE,   0};

abut_status check_ignored(const Universe& universe, const abut_query_filter& filter) {
  const abut_part_id& part = filter.ignore_part;
  if ((part.slot != 0 || part.generation != 0) && !exists(universe, part)) {
    return refuse_stale({"filter", Where::no_index, ".ignore_part"}, part);
  }
  const abut_geometry_id& geometry = filter.ignore_geometry;
  if ((geometry.slot != 0 || geometry.generation != 0) && !exists(universe, geometry)) {
    return refuse_stale({"filter", Where::no_index, ".ignore_geometry"}, geometry);
  }
  return ABUT_OK;
}

}  // namespace

abut_status read_filter(const Universe& universe, const abut_query_filter* given, Filter& out) {
  if (given == nullptr) {
    return ABUT_OK;
  }
  abut_status status = check_struct_size({"filter"}, *given);
  status = status != ABUT_OK ? status : check_reserved({"filter"}, given->reserved);
  status = status != ABUT_OK ? status : check_value({"filter"}, ".flags", given->flags, ABUT_QUERY_FILTER_SKIP_SENSORS);
  status = status != ABUT_OK ? status : check_value({"filter"}, ".ray_start", given->ray_start, ABUT_RAY_START_SKIP);
  status = status != ABUT_OK ? status : check_ignored(universe, *given);
  if (status == ABUT_OK) {
    out = {{given->layers, given->mask, to_part(given->ignore_part), to_geometry(given->ignore_geometry),
            (given->flags & ABUT_QUERY_FILTER_SKIP_SENSORS) != 0},
           static_cast<RayStart>(given->ray_start)};
  }
  return status;
}

abut_status read_ray(const Where& where, const abut_ray& ray, std::optional<Ray>& out) {
  if (const abut_status status = check_position(where, ".origin", ray.origin); status != ABUT_OK) {
    return status;
  }
  for (const auto& [name, value] : std::array<std::pair<std::string_view, double>, 3>{
           {{".direction.x", ray.direction.x}, {".direction.y", ray.direction.y}, {".direction.z", ray.direction.z}}}) {
    if (!std::isfinite(value)) {
      return refuse(error_about(Errc::not_finite, where.with(name), value, "finite"));
    }
  }
  const auto direction = UnitVec3::make(to_vec3(ray.direction));
  if (!direction) {
    return refuse(ABUT_ZERO_VECTOR, where.with(".direction is (0, 0, 0); it must have a direction"));
  }
  if (std::isnan(ray.max_distance)) {
    return refuse(error_about(Errc::not_finite, where.with(".max_distance"), ray.max_distance, "a number or infinite"));
  }
  if (ray.max_distance < 0) {
    return refuse(
        error_about(Errc::out_of_range, where.with(".max_distance"), ray.max_distance, "zero, positive or infinite"));
  }
  out = Ray{to_vec3(ray.origin), *direction, ray.max_distance};
  return ABUT_OK;
}

abut_status read_mode(abut_hit_mode mode, HitMode& out) {
  const abut_status status = check_value({"mode"}, "", mode, ABUT_HIT_ALL);
  out = status == ABUT_OK ? static_cast<HitMode>(mode) : out;
  return status;
}

abut_status read_placed(const abut_shape* const* shapes, const abut_pose* poses, std::string_view count_name,
                        std::size_t count, PlacedShapes& out) {
  std::span<const abut_shape* const> given;
  std::span<const abut_pose> given_poses;
  abut_status status = read_span("shapes", shapes, count_name, count, given);
  status = status != ABUT_OK ? status : read_span("poses", poses, count_name, count, given_poses);
  for (std::size_t i = 0; status == ABUT_OK && i < count; ++i) {
    if (given[i] == nullptr) {
      return refuse(ABUT_NULL_ARGUMENT, Where{"shapes", i}.with(" is null"));
    }
    status = check_pose({"poses", i}, given_poses[i]);
    if (status != ABUT_OK) {
      return status;
    }
    out.shapes.push_back(given[i]->handle);
    out.poses.push_back(to_pose(given_poses[i]));
  }
  return status;
}

}  // namespace abut::capi

void abut_query_filter_init(abut_query_filter* filter, uint32_t struct_size) {
  abut::capi::fill_defaults(abut::capi::default_filter, struct_size, filter);
}
