// SPDX-License-Identifier: Apache-2.0
// What is told of two shapes.
#ifndef ABUT_CAPI_PAIRS_ANSWERS_HPP
#define ABUT_CAPI_PAIRS_ANSWERS_HPP

#include "convert.hpp"

import abut.capability;
import abut.pairs.any_shape.casts.shape_cast;

namespace abut::capi {

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
