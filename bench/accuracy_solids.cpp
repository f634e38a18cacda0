// SPDX-License-Identifier: Apache-2.0
#include "accuracy_solids.hpp"

#include <algorithm>

namespace bench {

Solid made_thin(Solid solid, bool is_needle, double aspect) {
  switch (solid.kind) {
    case Kind::capsule: solid.sizes[0] = solid.sizes[1] / aspect; return solid;
    case Kind::cylinder:
    case Kind::cone:
      (is_needle ? solid.sizes[0] : solid.sizes[1]) = solid.sizes[is_needle ? 1 : 0] / aspect;
      return solid;
    case Kind::sphere:
    case Kind::box:
    case Kind::plane:
    case Kind::hull32:
    case Kind::hull200:
    case Kind::ellipsoid:
    case Kind::hull:
    case Kind::triangle:
    case Kind::mesh:
    case Kind::height_field:
    case Kind::solid_mesh:
    case Kind::distance_field:
    case Kind::particles:
    case Kind::point:
    case Kind::composite: break;
  }
  const auto flatten = [is_needle, aspect](Point& p) {
    p[2] /= is_needle ? 1 : aspect;
    p[0] /= is_needle ? aspect : 1;
    p[1] /= is_needle ? aspect : 1;
  };
  if (solid.kind == Kind::box || solid.kind == Kind::ellipsoid) {
    flatten(solid.sizes);
  }
  std::ranges::for_each(solid.points, flatten);
  return solid;
}

Solid scaled(Solid solid, double factor) {
  const auto scale = [factor](Point& p) { p = {factor * p[0], factor * p[1], factor * p[2]}; };
  scale(solid.sizes);
  std::ranges::for_each(solid.points, scale);
  return solid;
}

}  // namespace bench
