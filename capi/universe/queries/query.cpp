// SPDX-License-Identifier: Apache-2.0
// Queries on a universe. Batches write nothing before all of their arguments are checked.
#include "universe/queries/query_arguments.hpp"

#include "options.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape;
import abut.queries;
import abut.universe;

using namespace abut::capi;

namespace {

static_assert(static_cast<abut_hit_mode>(abut::HitMode::nearest) == ABUT_HIT_NEAREST);
static_assert(static_cast<abut_hit_mode>(abut::HitMode::any) == ABUT_HIT_ANY);
static_assert(static_cast<abut_hit_mode>(abut::HitMode::all) == ABUT_HIT_ALL);
static_assert(static_cast<abut_ray_start>(abut::RayStart::far_side) == ABUT_RAY_START_FAR_SIDE);
static_assert(static_cast<abut_ray_start>(abut::RayStart::solid) == ABUT_RAY_START_SOLID);
static_assert(static_cast<abut_ray_start>(abut::RayStart::skip) == ABUT_RAY_START_SKIP);

abut_query_hit from_ray(const abut::RayContact& hit) {
  return {from_geometry(hit.geometry), from_feature(hit.feature), hit.child, 0, hit.distance,
          from_vec3(hit.point),        from_vec3(hit.normal)};
}
abut_cast_hit from_contact_of_cast(const abut::CastContact& hit) {
  return from_cast(from_geometry(hit.geometry), hit.hit);
}

abut_status cast_ray(const abut_universe& its, const abut_ray& given, const abut_query_filter* given_filter,
                     abut_hit_mode given_mode, std::span<abut_query_hit> out, std::size_t* count) {
  std::optional<abut::Ray> ray;
  Filter filter;
  abut::HitMode mode{};
  abut_status status = read_ray({"ray"}, given, ray);
  status = status != ABUT_OK ? status : read_filter(its.universe, given_filter, filter);
  status = status != ABUT_OK ? status : read_mode(given_mode, mode);
  if (status == ABUT_OK) {
    const auto hits = abut::cast_ray(its.universe, *ray, filter.filter, mode, filter.ray_start);
    fill(std::span<const abut::RayContact>(hits), out, from_ray);
    *count = hits.size();
  }
  return status;
}

abut_status cast_rays(const abut_universe& its, std::span<const abut_ray> given, const abut_query_filter* given_filter,
                      std::span<abut_query_hit> out) {
  Filter filter;
  if (const abut_status status = read_filter(its.universe, given_filter, filter); status != ABUT_OK) {
    return status;
  }
  std::vector<abut::Ray> rays;
  rays.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    std::optional<abut::Ray> ray;
    if (const abut_status status = read_ray({"rays", i}, given[i], ray); status != ABUT_OK) {
      return status;
    }
    rays.push_back(*ray);
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto hit = abut::cast_ray(its.universe, rays[i], filter.filter, filter.ray_start);
    out[i] = hit ? from_ray(*hit) : abut_query_hit{};
  }
  return ABUT_OK;
}

abut_status cast_shape(const abut_universe& its, const abut_shape* shape, const abut_pose& pose,
                       const abut_vec3& displacement, const abut_query_filter* given_filter, abut_hit_mode given_mode,
                       std::span<abut_cast_hit> out, std::size_t* count) {
  Filter filter;
  abut::HitMode mode{};
  abut_status status = check_pose({"pose"}, pose);
  status = status != ABUT_OK ? status : check_position({"displacement"}, "", displacement);
  status = status != ABUT_OK ? status : read_filter(its.universe, given_filter, filter);
  status = status != ABUT_OK ? status : read_mode(given_mode, mode);
  if (status == ABUT_OK) {
    const auto hits =
        abut::cast_shape(its.universe, shape_of(shape), to_pose(pose), to_vec3(displacement), filter.filter, mode);
    fill(std::span<const abut::CastContact>(hits), out, from_contact_of_cast);
    *count = hits.size();
  }
  return status;
}

abut_status cast_shapes(const abut_universe& its, const PlacedShapes& placed, std::span<const abut_vec3> displacements,
                        const abut_query_filter* given_filter, std::span<abut_cast_hit> out) {
  Filter filter;
  abut_status status = read_filter(its.universe, given_filter, filter);
  for (std::size_t i = 0; status == ABUT_OK && i < displacements.size(); ++i) {
    status = check_position({"displacements", i}, "", displacements[i]);
  }
  for (std::size_t i = 0; status == ABUT_OK && i < displacements.size(); ++i) {
    const auto hits = abut::cast_shape(its.universe, *placed.shapes[i], placed.poses[i], to_vec3(displacements[i]),
                                       filter.filter, abut::HitMode::nearest);
    out[i] = hits.empty() ? abut_cast_hit{} : from_contact_of_cast(hits.front());
  }
  return status;
}

abut_status check_margin(double margin) {
  return is_coordinate(margin) ? static_cast<abut_status>(ABUT_OK) : to_status(abut::check_finite("margin", margin));
}

// Asks query by query: `find(i)` answers geometries.
template <class Find>
void write_each(std::span<std::uint64_t> offsets, std::span<abut_geometry_id> out, std::size_t* count, Find&& find) {
  std::size_t written = 0;
  offsets[0] = 0;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    const std::vector<abut::GeometryId> found = find(i);
    fill(std::span<const abut::GeometryId>(found), out.subspan(std::min(written, out.size())), from_geometry);
    written += found.size();
    offsets[i + 1] = written;
  }
  *count = written;
}

abut_status overlaps(const abut_universe& its, const abut_shape* shape, const abut_pose& pose,
                     const abut_query_filter* given_filter, double margin, std::span<abut_geometry_id> out,
                     std::size_t* count) {
  Filter filter;
  abut_status status = check_pose({"pose"}, pose);
  status = status != ABUT_OK ? status : read_filter(its.universe, given_filter, filter);
  status = status != ABUT_OK ? status : check_margin(margin);
  if (status == ABUT_OK) {
    const auto found = abut::find_overlaps(its.universe, shape_of(shape), to_pose(pose), margin, filter.filter);
    fill(std::span<const abut::GeometryId>(found), out, from_geometry);
    *count = found.size();
  }
  return status;
}

abut_status at_point(const abut_universe& its, const abut_vec3& position, const abut_query_filter* given_filter,
                     std::span<abut_geometry_id> out, std::size_t* count) {
  Filter filter;
  abut_status status = check_position({"position"}, "", position);
  status = status != ABUT_OK ? status : read_filter(its.universe, given_filter, filter);
  if (status == ABUT_OK) {
    const auto found = abut::find_at_point(its.universe, to_vec3(position), filter.filter);
    fill(std::span<const abut::GeometryId>(found), out, from_geometry);
    *count = found.size();
  }
  return status;
}

abut_status check_max_distance(double max_distance) {
  if (std::isnan(max_distance)) {
    return refuse(abut::error_about(abut::Errc::not_finite, "max_distance", max_distance, "a number or infinite"));
  }
  if (max_distance < 0) {
    return refuse(
        abut::error_about(abut::Errc::out_of_range, "max_distance", max_distance, "zero, positive or infinite"));
  }
  return ABUT_OK;
}

abut_closest from_near(const abut::NearGeometry& near) {
  return {from_geometry(near.geometry), from_distance(near.distance)};
}

abut_status closest(const abut_universe& its, const abut_shape* shape, const abut_pose& pose, double max_distance,
                    const abut_query_filter* given_filter, abut_closest* out, std::uint32_t* found) {
  Filter filter;
  abut_status status = check_pose({"pose"}, pose);
  status = status != ABUT_OK ? status : check_max_distance(max_distance);
  status = status != ABUT_OK ? status : read_filter(its.universe, given_filter, filter);
  if (status == ABUT_OK) {
    const auto near = abut::find_closest(its.universe, shape_of(shape), to_pose(pose), max_distance, filter.filter);
    if (near) {
      *out = from_near(*near);
    }
    *found = near ? 1 : 0;
  }
  return status;
}

}  // namespace

abut_status abut_universe_cast_ray(const abut_universe* universe, const abut_ray* ray, const abut_query_filter* filter,
                                   abut_hit_mode mode, abut_query_hit* hits, size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_query_hit> out;
    abut_status status = check_none_null<2>({{{"ray", ray}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("hits", hits, "capacity", capacity, out);
    return status != ABUT_OK ? status : cast_ray(its, *ray, filter, mode, out, count);
  });
}

abut_status abut_universe_cast_rays(const abut_universe* universe, const abut_ray* rays, size_t count,
                                    const abut_query_filter* filter, abut_query_hit* hits) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<const abut_ray> given;
    std::span<abut_query_hit> out;
    abut_status status = read_span("rays", rays, "count", count, given);
    status = status != ABUT_OK ? status : read_span("hits", hits, "count", count, out);
    return status != ABUT_OK ? status : cast_rays(its, given, filter, out);
  });
}

abut_status abut_universe_cast_shape(const abut_universe* universe, const abut_shape* shape, const abut_pose* pose,
                                     const abut_vec3* displacement, const abut_query_filter* filter, abut_hit_mode mode,
                                     abut_cast_hit* hits, size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_cast_hit> out;
    abut_status status =
        check_none_null<4>({{{"shape", shape}, {"pose", pose}, {"displacement", displacement}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("hits", hits, "capacity", capacity, out);
    return status != ABUT_OK ? status : cast_shape(its, shape, *pose, *displacement, filter, mode, out, count);
  });
}

abut_status abut_universe_cast_shapes(const abut_universe* universe, const abut_shape* const* shapes,
                                      const abut_pose* poses, const abut_vec3* displacements, size_t count,
                                      const abut_query_filter* filter, abut_cast_hit* hits) {
  return guard(universe, [&](const abut_universe& its) {
    PlacedShapes placed;
    std::span<const abut_vec3> ways;
    std::span<abut_cast_hit> out;
    abut_status status = read_span("displacements", displacements, "count", count, ways);
    status = status != ABUT_OK ? status : read_span("hits", hits, "count", count, out);
    status = status != ABUT_OK ? status : read_placed(shapes, poses, "count", count, placed);
    return status != ABUT_OK ? status : cast_shapes(its, placed, ways, filter, out);
  });
}

abut_status abut_universe_overlaps(const abut_universe* universe, const abut_shape* shape, const abut_pose* pose,
                                   const abut_query_filter* filter, double margin, abut_geometry_id* geometries,
                                   size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_geometry_id> out;
    abut_status status = check_none_null<3>({{{"shape", shape}, {"pose", pose}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    return status != ABUT_OK ? status : overlaps(its, shape, *pose, filter, margin, out, count);
  });
}

abut_status abut_universe_overlaps_of_each(const abut_universe* universe, const abut_shape* const* shapes,
                                           const abut_pose* poses, size_t query_count, const abut_query_filter* filter,
                                           double margin, uint64_t* offsets, abut_geometry_id* geometries,
                                           size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    PlacedShapes placed;
    std::span<std::uint64_t> places;
    std::span<abut_geometry_id> out;
    Filter ready;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_offsets(offsets, "query_count", query_count, places);
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    status = status != ABUT_OK ? status : read_placed(shapes, poses, "query_count", query_count, placed);
    status = status != ABUT_OK ? status : read_filter(its.universe, filter, ready);
    status = status != ABUT_OK ? status : check_margin(margin);
    if (status == ABUT_OK) {
      write_each(places, out, count, [&](std::size_t i) {
        return abut::find_overlaps(its.universe, *placed.shapes[i], placed.poses[i], margin, ready.filter);
      });
    }
    return status;
  });
}

abut_status abut_universe_at_point(const abut_universe* universe, const abut_vec3* position,
                                   const abut_query_filter* filter, abut_geometry_id* geometries, size_t capacity,
                                   size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_geometry_id> out;
    abut_status status = check_none_null<2>({{{"position", position}, {"count", count}}});
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    return status != ABUT_OK ? status : at_point(its, *position, filter, out, count);
  });
}

abut_status abut_universe_at_points(const abut_universe* universe, const abut_vec3* positions, size_t query_count,
                                    const abut_query_filter* filter, uint64_t* offsets, abut_geometry_id* geometries,
                                    size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<const abut_vec3> given;
    std::span<std::uint64_t> places;
    std::span<abut_geometry_id> out;
    Filter ready;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("positions", positions, "query_count", query_count, given);
    status = status != ABUT_OK ? status : read_offsets(offsets, "query_count", query_count, places);
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    for (std::size_t i = 0; status == ABUT_OK && i < given.size(); ++i) {
      status = check_position({"positions", i}, "", given[i]);
    }
    status = status != ABUT_OK ? status : read_filter(its.universe, filter, ready);
    if (status == ABUT_OK) {
      write_each(places, out, count,
                 [&](std::size_t i) { return abut::find_at_point(its.universe, to_vec3(given[i]), ready.filter); });
    }
    return status;
  });
}

abut_status abut_universe_closest(const abut_universe* universe, const abut_shape* shape, const abut_pose* pose,
                                  double max_distance, const abut_query_filter* filter, abut_closest* out,
                                  uint32_t* found) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<4>({{{"shape", shape}, {"pose", pose}, {"out", out}, {"found", found}}});
    return status != ABUT_OK ? status : closest(its, shape, *pose, max_distance, filter, out, found);
  });
}

abut_status abut_universe_closest_to_each(const abut_universe* universe, const abut_shape* const* shapes,
                                          const abut_pose* poses, size_t count, double max_distance,
                                          const abut_query_filter* filter, abut_closest* out) {
  return guard(universe, [&](const abut_universe& its) {
    PlacedShapes placed;
    std::span<abut_closest> answers;
    Filter ready;
    abut_status status = read_span("out", out, "count", count, answers);
    status = status != ABUT_OK ? status : read_placed(shapes, poses, "count", count, placed);
    status = status != ABUT_OK ? status : check_max_distance(max_distance);
    status = status != ABUT_OK ? status : read_filter(its.universe, filter, ready);
    for (std::size_t i = 0; status == ABUT_OK && i < answers.size(); ++i) {
      const auto near =
          abut::find_closest(its.universe, *placed.shapes[i], placed.poses[i], max_distance, ready.filter);
      answers[i] = near ? from_near(*near) : abut_closest{};
    }
    return status;
  });
}
