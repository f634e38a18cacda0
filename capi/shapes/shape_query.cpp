// SPDX-License-Identifier: Apache-2.0
// Questions about one shape.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"
#include "shapes/shape_handle.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape.casts.ray_child;
import abut.pairs.any_shape;

using namespace abut::capi;

namespace {

abut_status write_parameters(const abut_shape* shape, double* parameters, std::size_t capacity, std::size_t* count) {
  std::span<double> out;
  if (const abut_status status = read_span("parameters", parameters, "capacity", capacity, out); status != ABUT_OK) {
    return status;
  }
  const std::vector<double> found = abut::parameters_of(shape_of(shape));
  std::copy_n(found.begin(), std::min(found.size(), out.size()), out.begin());
  *count = found.size();
  return ABUT_OK;
}

abut_status write_aabb(const abut_shape* shape, const abut_pose& pose, abut_aabb* out) {
  if (const abut_status status = check_pose({"pose"}, pose); status != ABUT_OK) {
    return status;
  }
  const abut::Aabb box = abut::aabb_of(shape_of(shape), to_pose(pose));
  *out = {from_vec3(box.low), from_vec3(box.high)};
  return ABUT_OK;
}

struct [[gsl::Pointer]] TriangleBuffers {
  double* xyz;
  std::size_t vertex_capacity;
  std::size_t* vertex_count;
  std::uint32_t* triangles;
  std::size_t triangle_capacity;
  std::size_t* triangle_count;
};

abut_status write_triangles(const abut_shape* shape, const TriangleBuffers& buffers) {
  std::span<double> xyz;
  if (const abut_status status = read_span<3>("xyz", buffers.xyz, "vertex_capacity", buffers.vertex_capacity, xyz);
      status != ABUT_OK) {
    return status;
  }
  std::span<std::uint32_t> triangles;
  if (const abut_status status =
          read_span<3>("triangles", buffers.triangles, "triangle_capacity", buffers.triangle_capacity, triangles);
      status != ABUT_OK) {
    return status;
  }
  const std::optional<abut::Triangles> found = abut::triangles_of(shape_of(shape));
  if (!found) {
    return refuse(ABUT_UNSUPPORTED, "a " + std::string(abut::kind_name(abut::kind_of(shape_of(shape)))) +
                                        " has no surface of triangles; abut_shape_cast_ray meets it exactly");
  }
  const std::size_t written = std::min(found->vertices.size(), buffers.vertex_capacity);
  for (std::size_t i = 0; i < written; ++i) {
    const abut::Vec3& vertex = found->vertices[i];
    xyz[3 * i] = vertex.x;
    xyz[3 * i + 1] = vertex.y;
    xyz[3 * i + 2] = vertex.z;
  }
  std::copy_n(found->indices.begin(), std::min(found->indices.size(), triangles.size()), triangles.begin());
  *buffers.vertex_count = found->vertices.size();
  *buffers.triangle_count = found->indices.size() / 3;
  return ABUT_OK;
}

abut_status write_report(const abut_shape* shape, abut_hull_report* out) {
  if (const abut_status status = check_struct_size({"out"}, *out); status != ABUT_OK) {
    return status;
  }
  const std::optional<abut::BuildReport> report = abut::build_report_of(shape_of(shape));
  if (!report) {
    return refuse(ABUT_UNSUPPORTED, "a " + std::string(abut::kind_name(abut::kind_of(shape_of(shape)))) +
                                        " keeps what it is given; only a hull reports what it left out");
  }
  write_struct({sizeof(abut_hull_report), report->dimension, report->point_count, report->vertex_count,
                report->edge_count, report->face_count, report->error},
               out);
  return ABUT_OK;
}

abut_status check_ray(const abut_ray& ray, std::optional<abut::UnitVec3>& direction) {
  if (const abut_status status = check_position({"ray"}, ".origin", ray.origin); status != ABUT_OK) {
    return status;
  }
  for (const auto& [name, value] :
       std::array<std::pair<std::string_view, double>, 3>{{{"ray.direction.x", ray.direction.x},
                                                           {"ray.direction.y", ray.direction.y},
                                                           {"ray.direction.z", ray.direction.z}}}) {
    if (!std::isfinite(value)) {
      return refuse(abut::error_about(abut::Errc::not_finite, name, value, "finite"));
    }
  }
  direction = abut::UnitVec3::make(to_vec3(ray.direction));
  if (!direction) {
    return refuse(ABUT_ZERO_VECTOR, "ray.direction is (0, 0, 0); it must have a direction");
  }
  if (std::isnan(ray.max_distance)) {
    return refuse(
        abut::error_about(abut::Errc::not_finite, "ray.max_distance", ray.max_distance, "a number or infinite"));
  }
  if (ray.max_distance < 0) {
    return refuse(abut::error_about(abut::Errc::out_of_range, "ray.max_distance", ray.max_distance,
                                    "zero, positive or infinite"));
  }
  return ABUT_OK;
}

abut_status cast_ray(const abut_shape* shape, const abut_pose& given_pose, const abut_ray& ray, abut_ray_hit* hit,
                     std::uint32_t* found) {
  if (const abut_status status = check_pose({"pose"}, given_pose); status != ABUT_OK) {
    return status;
  }
  std::optional<abut::UnitVec3> direction;
  if (const abut_status status = check_ray(ray, direction); status != ABUT_OK) {
    return status;
  }
  const abut::Pose pose = to_pose(given_pose);
  const abut::Vec3 origin = to_vec3(ray.origin);
  const auto local_direction = abut::UnitVec3::from_unit_unchecked(pose.rotation.undo(*direction));
  const std::optional<abut::RayHit> met =
      abut::cast_ray(shape_of(shape), pose.undo(origin), local_direction, ray.max_distance);
  if (met) {
    *hit = {met->distance,
            from_vec3(origin + met->distance * direction->vec()),
            from_vec3(pose.rotation * met->normal),
            from_feature(met->feature),
            abut::child_on_ray(shape_of(shape), pose.undo(origin), local_direction, met->distance),
            0};
  }
  *found = met ? 1 : 0;
  return ABUT_OK;
}

}  // namespace

abut_shape_kind abut_shape_kind_of(const abut_shape* shape) {
  return shape == nullptr ? abut_shape_kind{0} : abut::kind_number(abut::kind_of(shape_of(shape)));
}

abut_status abut_shape_parameters(const abut_shape* shape, double* parameters, size_t capacity, size_t* count) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"count", count}}});
    return status != ABUT_OK ? status : write_parameters(shape, parameters, capacity, count);
  });
}

abut_status abut_shape_aabb(const abut_shape* shape, const abut_pose* pose, abut_aabb* out) {
  return guard([&] {
    const abut_status status = check_none_null<3>({{{"shape", shape}, {"pose", pose}, {"out", out}}});
    return status != ABUT_OK ? status : write_aabb(shape, *pose, out);
  });
}

abut_status abut_shape_triangles(const abut_shape* shape, double* xyz, size_t vertex_capacity, size_t* vertex_count,
                                 uint32_t* triangles, size_t triangle_capacity, size_t* triangle_count) {
  return guard([&] {
    const abut_status status =
        check_none_null<3>({{{"shape", shape}, {"vertex_count", vertex_count}, {"triangle_count", triangle_count}}});
    return status != ABUT_OK ? status
                             : write_triangles(shape, {xyz, vertex_capacity, vertex_count, triangles, triangle_capacity,
                                                       triangle_count});
  });
}

abut_status abut_shape_prepare(const abut_shape* shape, uint32_t threads) {
  return guard([&] {
    abut_status status = check_not_null("shape", shape);
    status = status != ABUT_OK ? status : check_threads(threads, "threads");
    if (status == ABUT_OK) {
      abut::prepare(shape_of(shape), abut::Workers(threads));
    }
    return status;
  });
}

void abut_hull_report_init(abut_hull_report* report, uint32_t struct_size) {
  fill_defaults(abut_hull_report{}, struct_size, report);
}

abut_status abut_hull_describe(const abut_shape* shape, abut_hull_report* out) {
  return guard([&] {
    const abut_status status = check_none_null<2>({{{"shape", shape}, {"out", out}}});
    return status != ABUT_OK ? status : write_report(shape, out);
  });
}

abut_status abut_shape_cast_ray(const abut_shape* shape, const abut_pose* pose, const abut_ray* ray, abut_ray_hit* hit,
                                uint32_t* found) {
  return guard([&] {
    const abut_status status =
        check_none_null<5>({{{"shape", shape}, {"pose", pose}, {"ray", ray}, {"hit", hit}, {"found", found}}});
    return status != ABUT_OK ? status : cast_ray(shape, *pose, *ray, hit, found);
  });
}
