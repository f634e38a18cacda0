// SPDX-License-Identifier: Apache-2.0
// The masses that holes take out of the solids of a composite, seen through abut.h.
#ifndef ABUT_CAPI_RESPONSE_HOLES_HPP
#define ABUT_CAPI_RESPONSE_HOLES_HPP

#include <abut/response.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

import abut.response;

namespace abut::capi {

struct ReleaseOwnedShape {
  void operator()(abut_shape* shape) const noexcept { abut_shape_release(shape); }
};
using OwnedShape = std::unique_ptr<abut_shape, ReleaseOwnedShape>;

/// A child of a composite. `sheet` is the surface of a solid of triangles, once it has been asked for.
struct CompositePart {
  std::size_t number = 0;
  OwnedShape shape;
  std::string kind;
  std::vector<double> parameters;
  abut_composite_child info{};
  OwnedShape sheet;
};

[[nodiscard]] abut_status parts_of_composite(const abut_shape* shape, std::vector<CompositePart>& out);

/// Appends to `out` the masses that holes take out of solids, of density 1, in the frame of the composite. Refuses
/// where a hole leaves a solid by other walls than flat ends of it, and where two holes overlap.
[[nodiscard]] abut_status missing_of_holes(std::vector<CompositePart>& parts,
                                           std::vector<response::MassProperties>& out);

}  // namespace abut::capi

#endif
