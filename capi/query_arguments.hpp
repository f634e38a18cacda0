// SPDX-License-Identifier: Apache-2.0
// Arguments of queries on a universe.
#ifndef ABUT_CAPI_QUERY_ARGUMENTS_HPP
#define ABUT_CAPI_QUERY_ARGUMENTS_HPP

#include "universe_handle.hpp"

import abut.capability;
import abut.math;
import abut.pairs.any_shape;
import abut.queries;
import abut.universe;

namespace abut::capi {

struct Filter {
  QueryFilter filter;
  RayStart ray_start = RayStart::far_side;
};

// A filter that may be null.
[[nodiscard]] abut_status read_filter(const Universe& universe, const abut_query_filter* filter, Filter& out);
[[nodiscard]] abut_status read_ray(const Where& where, const abut_ray& ray, std::optional<Ray>& out);
[[nodiscard]] abut_status read_mode(abut_hit_mode mode, HitMode& out);

// Shapes with their poses, all checked.
struct PlacedShapes {
  std::vector<ShapeHandle> shapes;
  std::vector<Pose> poses;
};
[[nodiscard]] abut_status read_placed(const abut_shape* const* shapes, const abut_pose* poses,
                                      std::string_view count_name, std::size_t count, PlacedShapes& out);

[[nodiscard]] inline abut_distance from_distance(const Distance& found) {
  return {found.distance,
          found.lower,
          found.upper,
          from_vec3(found.point_a),
          from_vec3(found.point_b),
          from_vec3(found.normal),
          static_cast<abut_algorithm>(found.algorithm),
          found.iterations};
}
[[nodiscard]] inline abut_cast_hit from_cast(const abut_geometry_id& geometry, const ShapeCastHit& hit) {
  return {
      geometry,    hit.fraction, from_distance(hit.contact), from_feature(hit.feature_a), from_feature(hit.feature_b),
      hit.child_a, hit.child_b};
}

}  // namespace abut::capi

#endif
