// SPDX-License-Identifier: Apache-2.0
// Stencils in the words of the C interface.
#ifndef ABUT_CAPI_STENCIL_HPP
#define ABUT_CAPI_STENCIL_HPP

#include "prelude.hpp"

#include "convert.hpp"

import abut.proximity.stencil;

namespace abut::capi {

[[nodiscard]] inline abut_stencil from_stencil(const Stencil& its) {
  abut_stencil out{static_cast<abut_stencil_kind>(its.kind),
                   its.of_a,
                   its.element_a,
                   its.element_b,
                   {},
                   {},
                   from_vec3(its.normal),
                   its.distance,
                   its.toi};
  std::copy(its.vertices.begin(), its.vertices.end(), out.vertices);
  std::copy(its.weights.begin(), its.weights.end(), out.weights);
  return out;
}

}  // namespace abut::capi

#endif
