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
  return is_hull(solid.kind) ? "hull" : solid.kind == Kind::solid_mesh ? "mesh" : kind_name(solid.kind);
}

[[nodiscard]] inline std::vector<double> flattened(const std::vector<Point>& points) {
  std::vector<double> xyz;
  for (const Point& p : points) {
    xyz.insert(xyz.end(), p.begin(), p.end());
  }
  return xyz;
}

// Half of its layers are below the surface.
inline constexpr int field_layers = 9;
[[nodiscard]] inline double field_depth(const Solid& field) { return field_layers / 2 * field.sizes[1]; }

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
    case Kind::solid_mesh: return {2};
    case Kind::distance_field: {
      const double half = 0.5 * (s[0] - 1) * s[1];
      return {s[0], s[0], field_layers, s[1], s[1], s[1], -half, -half, -field_depth(solid), 0};
    }
    case Kind::particles: return {s[0]};
    case Kind::height_field: return {s[0], s[0], s[1], s[1]};
    case Kind::point:
    case Kind::composite:
    case Kind::hull32:
    case Kind::hull200:
    case Kind::hull: return {};
  }
  return {};
}

// The numbers beside the parameters: points, or the heights or the values of a field.
[[nodiscard]] inline std::vector<double> abut_reals(const Solid& solid) {
  if (solid.kind == Kind::height_field) {
    std::vector<double> heights;
    for (const Point& p : solid.points) {
      heights.push_back(p[2]);
    }
    return heights;
  }
  if (solid.kind == Kind::distance_field) {
    const auto in_layer = static_cast<std::size_t>(solid.sizes[0] * solid.sizes[0]);
    std::vector<double> values;
    for (int k = 0; k < field_layers; ++k) {
      values.insert(values.end(), in_layer, solid.sizes[1] * k - field_depth(solid));
    }
    return values;
  }
  const bool has_points = is_hull(solid.kind) || is_mesh(solid.kind) || solid.kind == Kind::particles;
  return has_points ? flattened(solid.points) : std::vector<double>{};
}

// The triangles of a mesh.
[[nodiscard]] inline std::vector<std::uint32_t> abut_indices(const Solid& solid) {
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; is_mesh(solid.kind) && i < solid.triangles.size(); ++i) {
    for (const int corner : solid.triangles[i]) {
      indices.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  return indices;
}

}  // namespace bench
