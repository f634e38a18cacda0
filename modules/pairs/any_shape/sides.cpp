// SPDX-License-Identifier: Apache-2.0
module abut.pairs.any_shape.sides;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.pairs.any_shape;

namespace abut {
namespace {

std::optional<std::size_t> place_of_parameter(std::size_t kind, std::string_view name) {
  for (std::size_t i = 0; i < kind_parameter_count(kind); ++i) {
    if (kind_parameter_name(kind, i) == name) {
      return i;
    }
  }
  return std::nullopt;
}

}  // namespace

SurfaceSides sides_of(const AnyShape& shape) {
  const std::optional<std::size_t> sides = place_of_parameter(kind_in_pairs(shape), "sides");
  const std::optional<std::size_t> below = place_of_parameter(kind_in_pairs(shape), "solid_below");
  if (!sides && !below) {
    return SurfaceSides::none;
  }
  const Real value = parameters_of(shape)[sides ? *sides : *below];
  if (!sides) {
    return value == 0 ? SurfaceSides::front : SurfaceSides::ground;
  }
  return value == 0 ? SurfaceSides::both : value == 1 ? SurfaceSides::front : SurfaceSides::solid;
}

std::optional<ShapeHandle> make_sheet(const Triangles& triangles) {
  std::vector<Real> xyz;
  for (const Vec3& vertex : triangles.vertices) {
    xyz.insert(xyz.end(), {vertex.x, vertex.y, vertex.z});
  }
  constexpr std::array<Real, 1> both_sides{0};
  for (std::size_t kind = 0; kind < shape_kind_count; ++kind) {
    if (place_of_parameter(kind, "sides") == 0u) {
      if (Result<ShapeHandle> made = make_shape(kind, both_sides, xyz, triangles.indices)) {
        return std::move(made).value();
      }
    }
  }
  return std::nullopt;
}

}  // namespace abut
