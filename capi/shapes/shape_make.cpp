// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape_make.hpp"

#include "border.hpp"
#include "shapes/shape_handle.hpp"

import abut.core;
import abut.pairs.any_shape;
import abut.pairs.any_shape.sides;
import abut.triangles.volume;

namespace abut::capi {
namespace {

Error renamed(Error error) {
  for (const auto& [from, to] :
       std::array<std::pair<std::string_view, std::string_view>, 5>{{{"xyz[", "desc.reals["},
                                                                     {"heights[", "desc.reals["},
                                                                     {"values[", "desc.reals["},
                                                                     {"indices[", "desc.indices["},
                                                                     {"triangles[", "desc.indices["}}}) {
    if (error.message.starts_with(from)) {
      error.message.replace(0, from.size(), to);
      break;
    }
  }
  return error;
}

// A solid mesh has an inside.
abut_status check_winding(const AnyShape& shape) {
  const auto triangles = triangles_of(shape);
  if (!triangles || sides_of(shape) != SurfaceSides::solid) {
    return ABUT_OK;
  }
  const EnclosedVolume enclosed = enclosed_volume(*triangles);
  return !enclosed.is_inside_out()
             ? static_cast<abut_status>(ABUT_OK)
             : refuse(ABUT_INVALID_ARGUMENT,
                      "the triangles of a solid mesh enclose a volume of " + to_text(enclosed.volume) +
                          "; it must not be negative: they are counter-clockwise seen from outside, so turn them all");
}

}  // namespace

abut_status create(std::size_t place, const Numbers& numbers, abut_shape** out, Door door) {
  Result<ShapeHandle> made = make_shape(place, numbers.parameters, numbers.reals, numbers.indices);
  if (!made) {
    return refuse(door == Door::generic ? renamed(made.error()) : made.error());
  }
  if (const abut_status status = check_winding(*made.value()); status != ABUT_OK) {
    return status;
  }
  *out = std::make_unique<abut_shape>(std::move(made).value()).release();
  return ABUT_OK;
}

abut_status create_named(std::string_view name, const Numbers& numbers, abut_shape** out) {
  const std::optional<std::size_t> place = find_kind(name);
  if (!place) {
    return refuse(ABUT_UNSUPPORTED, "this build of abut has no shape named " + std::string(name));
  }
  return create(*place, numbers, out);
}

}  // namespace abut::capi
