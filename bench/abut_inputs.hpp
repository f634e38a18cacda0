// SPDX-License-Identifier: Apache-2.0
// Solids in the terms of abut: the name of a kind, its parameters, and its points.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
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
    case Kind::mesh: return {0};
    case Kind::height_field: return {s[0], s[0], s[1], s[1]};
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: return {};
  }
  return {};
}

// The numbers beside the parameters: the points of a hull or a mesh, the heights of a height field.
[[nodiscard]] inline std::vector<double> abut_reals(const Solid& solid) {
  if (solid.kind == Kind::height_field) {
    std::vector<double> heights;
    for (const Point& p : solid.points) {
      heights.push_back(p[2]);
    }
    return heights;
  }
  return is_hull(solid.kind) || solid.kind == Kind::mesh ? flattened(solid.points) : std::vector<double>{};
}

// The triangles of a mesh.
[[nodiscard]] inline std::vector<std::uint32_t> abut_indices(const Solid& solid) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; solid.kind == Kind::mesh && i < solid.triangles.size(); ++i) {
    for (const int corner : solid.triangles[i]) {
      indices.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  return indices;
}

}  // namespace bench
