// SPDX-License-Identifier: Apache-2.0
// Arguments of queries on a universe.
#ifndef ABUT_CAPI_QUERY_ARGUMENTS_HPP
#define ABUT_CAPI_QUERY_ARGUMENTS_HPP

#include "pairs/answers.hpp"
#include "universe/universe_handle.hpp"

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

}  // namespace abut::capi

#endif
