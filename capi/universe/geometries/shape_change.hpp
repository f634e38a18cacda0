// SPDX-License-Identifier: Apache-2.0
// Shapes of geometries that a universe changes, and the handles that lend them out.
#ifndef ABUT_CAPI_SHAPE_CHANGE_HPP
#define ABUT_CAPI_SHAPE_CHANGE_HPP

#include "prelude.hpp"

#include "shapes/shape_handle.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

namespace abut::capi {

// A universe changes a shape in place when nobody else holds it. For the time of a change, handles that only the
// universe holds let go of their shapes. Those that the caller holds as well keep theirs, and others take their place
// when all went well.
template <class Change>
abut_status change_shapes(abut_universe& its, std::span<const abut_geometry_id> ids, Change&& change) {
  std::vector<std::uint32_t> let_go;
  std::vector<std::pair<std::uint32_t, ShapeOwner>> others;
  let_go.reserve(ids.size());
  for (const abut_geometry_id& id : ids) {
    if (its.shapes[id.slot - 1]->references.load(std::memory_order_acquire) == 1) {
      let_go.push_back(id.slot - 1);
    } else {
      ShapeOwner other(std::make_unique<abut_shape>(its.universe.vacant_shape()).release());
      others.emplace_back(id.slot - 1, std::move(other));
    }
  }
  const auto take_back = [&] {
    for (const std::uint32_t place : let_go) {
      its.shapes[place]->handle = its.universe.handle_at(place);
    }
  };
  for (const std::uint32_t place : let_go) {
    its.shapes[place]->handle = its.universe.vacant_shape();
  }
  try {
    const Result<void> done = std::forward<Change>(change)();
    take_back();
    if (!done) {
      return refuse(done.error());
    }
  } catch (...) {
    take_back();
    // Copies may have been made for the change.
    for (const auto& [place, unused] : others) {
      its.universe.put_back(place, its.shapes[place]->handle);
    }
    throw;
  }
  for (auto& [place, handle] : others) {
    handle->handle = its.universe.handle_at(place);
    its.shapes[place] = std::move(handle);
  }
  return ABUT_OK;
}

}  // namespace abut::capi

#endif
