// SPDX-License-Identifier: Apache-2.0
// A build without surfaces: no children are a group.
module abut.pairs.surfaces.surface_group;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.triangle.stopping_sides;

namespace abut {

std::optional<StoppingSides> sides_of_surface(const AnyShape&) { return std::nullopt; }
ChildPairs group_of(const AnyShape&, const AnyShape&, const Pose&, const ChildPair&, bool) { return {}; }
bool may_group(const QuerySettings&) { return false; }
void contacts_of_group(std::span<const ChildPair>, bool, const QuerySettings&, Manifold&) {}
bool depth_of_group(std::span<const ChildPair>, bool, const QuerySettings&, Distance&) { return false; }
bool depth_of_children(const AnyShape&, const AnyShape&, const Pose&, bool, Real, const QuerySettings&, Distance&) {
  return false;
}

}  // namespace abut
