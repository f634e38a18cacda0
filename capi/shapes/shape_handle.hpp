// SPDX-License-Identifier: Apache-2.0
// abut_shape: a frozen shape and the number of its owners on the C side.
#ifndef ABUT_CAPI_SHAPE_HANDLE_HPP
#define ABUT_CAPI_SHAPE_HANDLE_HPP

#include "prelude.hpp"

import abut.core.standard;
import abut.pairs.shape_handle;

struct abut_shape {
  explicit abut_shape(abut::ShapeHandle shape) : handle(std::move(shape)) {}

  abut::ShapeHandle handle;
  std::atomic<std::size_t> references{1};
};

namespace abut::capi {

// An owner of one reference.
struct ReleaseShape {
  void operator()(abut_shape* shape) const noexcept { abut_shape_release(shape); }
};
using ShapeOwner = std::unique_ptr<abut_shape, ReleaseShape>;

// One more owner of a shape of the caller. Only the count changes, of which a shape that is const to the
// caller may have many.
[[nodiscard]] inline ShapeOwner share(const abut_shape* shape) {
  auto* counted = const_cast<abut_shape*>(shape);
  abut_shape_retain(counted);
  return ShapeOwner(counted);
}

// The shape of an argument that is known not to be null.
[[nodiscard]] inline const AnyShape& shape_of(const abut_shape* shape) { return *shape->handle; }

}  // namespace abut::capi

#endif
