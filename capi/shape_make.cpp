// SPDX-License-Identifier: Apache-2.0
#include "shape_make.hpp"

#include "border.hpp"
#include "shape_handle.hpp"

import abut.core;
import abut.pairs.any_shape;
import abut.pairs.registry;

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

}  // namespace

abut_status create(std::size_t place, const Numbers& numbers, abut_shape** out, Door door) {
  Result<AnyShape> made = make_shape(place, numbers.parameters, numbers.reals, numbers.indices);
  if (!made) {
    return refuse(door == Door::generic ? renamed(made.error()) : made.error());
  }
  *out = std::make_unique<abut_shape>(ShapeHandle(std::move(made).value())).release();
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
