// SPDX-License-Identifier: Apache-2.0
// A build without surfaces: nothing has a side.
module abut.pairs.surfaces.kept_sides;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {

bool may_keep_side(std::size_t, std::size_t) { return false; }
bool may_be_of(std::span<const SidesOfChildren>, const AnyShape&, const AnyShape&) { return false; }
bool contacts_on_side(const AnyShape&, const AnyShape&, const Pose&, const QuerySettings&, KeptSide&, Manifold&) {
  return false;
}

}  // namespace abut
