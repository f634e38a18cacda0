// SPDX-License-Identifier: Apache-2.0
// What the functions that make and change geometries are given.
#ifndef ABUT_CAPI_GEOMETRY_ARGUMENTS_HPP
#define ABUT_CAPI_GEOMETRY_ARGUMENTS_HPP

#include "prelude.hpp"

#include "border.hpp"
#include "shapes/shape_handle.hpp"

import abut.pairs.any_shape;
import abut.universe;

namespace abut::capi {

[[nodiscard]] abut_status check_options(const Where& where, const abut_geometry_options& options);
// For options that were checked.
[[nodiscard]] GeometryOptions to_options(const abut_geometry_options& options);
// Whether the shape of a single geometry can have the self pairs that its options ask for.
[[nodiscard]] abut_status check_self_pairs(const GeometryOptions& options, const ShapeHandle& shape);
// Checks and converts those of a batch.
[[nodiscard]] abut_status read_options(std::span<const abut_geometry_options> given, std::vector<GeometryOptions>& out);

[[nodiscard]] inline abut_geometry_flags flags_of(const GeometryOptions& options) {
  return (options.is_sensor ? std::uint32_t{ABUT_GEOMETRY_SENSOR} : 0) |
         (options.has_self_pairs ? std::uint32_t{ABUT_GEOMETRY_SELF_PAIRS} : 0) |
         (options.sweeping == Sweeping::impacts ? std::uint32_t{ABUT_GEOMETRY_FAST} : 0) |
         (options.sweeping == Sweeping::speculative ? std::uint32_t{ABUT_GEOMETRY_SPECULATIVE} : 0) |
         (options.keeps_side ? std::uint32_t{ABUT_GEOMETRY_KEEPS_SIDE} : 0);
}

[[nodiscard]] abut_status check_shapes(std::span<const abut_shape* const> shapes);

// One more owner of each shape, and what a universe wants of them.
struct SharedShapes {
  explicit SharedShapes(std::span<const abut_shape* const> shapes);

  std::vector<ShapeOwner> owners;
  std::vector<ShapeHandle> handles;
};

}  // namespace abut::capi

#endif
