// SPDX-License-Identifier: Apache-2.0
#include "universe/geometries/geometry_arguments.hpp"
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.pairs.any_shape;
import abut.scene.meetings.checks;
import abut.universe;

namespace abut::capi {

static_assert(static_cast<abut_parking>(Parking::none) == ABUT_PARKING_NONE);
static_assert(static_cast<abut_parking>(Parking::short_term) == ABUT_PARKING_SHORT_TERM);
static_assert(static_cast<abut_parking>(Parking::long_term) == ABUT_PARKING_LONG_TERM);

namespace {

constexpr abut_geometry_flags on_way = ABUT_GEOMETRY_FAST | ABUT_GEOMETRY_SPECULATIVE;

abut_status check_flags(const Where& where, abut_geometry_flags flags) {
  const abut_status status = check_bits(
      where, ".flags", flags, ABUT_GEOMETRY_SENSOR | ABUT_GEOMETRY_SELF_PAIRS | on_way | ABUT_GEOMETRY_KEEPS_SIDE);
  if (status != ABUT_OK || (flags & on_way) == 0) {
    return status;
  }
  if ((flags & on_way) == on_way) {
    return refuse(error_about(Errc::invalid_argument, where.with(".flags"), std::uint64_t{flags},
                              "fast or speculative, not both"));
  }
  return abut_has_feature("motion") != 0 ? static_cast<abut_status>(ABUT_OK) : refuse_motion();
}

Sweeping sweeping_of(abut_geometry_flags flags) {
  return (flags & ABUT_GEOMETRY_FAST) != 0          ? Sweeping::impacts
         : (flags & ABUT_GEOMETRY_SPECULATIVE) != 0 ? Sweeping::speculative
                                                    : Sweeping::none;
}

}  // namespace

abut_status check_options(const Where& where, const abut_geometry_options& options) {
  abut_status status = check_flags(where, options.flags);
  status = status != ABUT_OK ? status : check_pose({where.name, where.index, ".pose"}, options.pose);
  if (status == ABUT_OK && !(options.tolerance >= 0 && options.tolerance <= largest_coordinate)) {
    return to_status(check_not_negative(where.with(".tolerance"), options.tolerance));
  }
  status = status != ABUT_OK ? status : check_tag(where, ".tag", options.tag);
  return status != ABUT_OK ? status : check_value(where, ".parking", options.parking, ABUT_PARKING_LONG_TERM);
}

GeometryOptions to_options(const abut_geometry_options& options) {
  return {to_placement(options.pose),
          options.tolerance,
          options.user_data,
          (options.flags & ABUT_GEOMETRY_SENSOR) != 0,
          static_cast<Parking>(options.parking),
          options.layers,
          options.mask,
          options.exclusion,
          options.label,
          options.tag,
          options.material,
          (options.flags & ABUT_GEOMETRY_SELF_PAIRS) != 0,
          sweeping_of(options.flags),
          (options.flags & ABUT_GEOMETRY_KEEPS_SIDE) != 0};
}

abut_status check_self_pairs(const GeometryOptions& options, const ShapeHandle& shape) {
  const Fault fault = abut::check_self_pairs(options, abut::kind_in_pairs(*shape));
  return fault ? refuse_field({"options"}, *fault) : static_cast<abut_status>(ABUT_OK);
}

abut_status read_options(std::span<const abut_geometry_options> given, std::vector<GeometryOptions>& out) {
  out.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (const abut_status status = check_options({"options", i}, given[i]); status != ABUT_OK) {
      return status;
    }
    out.push_back(to_options(given[i]));
  }
  return ABUT_OK;
}

abut_status check_shapes(std::span<const abut_shape* const> shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i] == nullptr) {
      return refuse(ABUT_NULL_ARGUMENT, Where{"shapes", i}.with(" is null"));
    }
  }
  return ABUT_OK;
}

SharedShapes::SharedShapes(std::span<const abut_shape* const> shapes) {
  owners.reserve(shapes.size());
  handles.reserve(shapes.size());
  for (const abut_shape* shape : shapes) {
    owners.push_back(share(shape));
    handles.push_back(shape->handle);
  }
}

}  // namespace abut::capi
