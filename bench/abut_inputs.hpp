// Solids in the terms of abut: the name of a kind, its parameters, and its points.
#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "scene.hpp"

namespace bench {

[[nodiscard]] inline std::string_view abut_kind_name(const Solid& solid) {
  return is_hull(solid.kind) ? "hull" : kind_name(solid.kind);
}

[[nodiscard]] inline std::vector<double> flattened(const std::vector<Point>& points) {
  std::vector<double> xyz;
  for (const Point& p : points) {
    xyz.insert(xyz.end(), p.begin(), p.end());
  }
  return xyz;
}

[[nodiscard]] inline std::vector<double> abut_parameters(const Solid& solid) {
  const Point& s = solid.sizes;
  switch (solid.kind) {
    case Kind::sphere: return {s[0]};
    case Kind::capsule:
    case Kind::cylinder:
    case Kind::cone: return {s[0], s[1]};
    case Kind::box:
    case Kind::ellipsoid: return {s[0], s[1], s[2]};
    case Kind::plane: return {0, 0, 1, 0};
    case Kind::triangle: return flattened(solid.points);
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: return {};
  }
  return {};
}

// The numbers beside the parameters: the points of a hull.
[[nodiscard]] inline std::vector<double> abut_reals(const Solid& solid) {
  return is_hull(solid.kind) ? flattened(solid.points) : std::vector<double>{};
}

}  // namespace bench
