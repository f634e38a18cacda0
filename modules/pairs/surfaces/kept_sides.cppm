// SPDX-License-Identifier: Apache-2.0
// Contacts of a surface and a body that has passed it, a convex shape or one of many solids: as deep as the way back to
// the side from which it came.
export module abut.pairs.surfaces.kept_sides;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.warm.side_memory;
import abut.pairs.shape_handle;

export namespace abut {

// Whether pairs of two kinds, by their places in the registry, may remember a side: a convex shape or many solids and a
// surface, or a composite that may have children of which one is convex and one a surface.
[[nodiscard]] bool may_keep_side(std::size_t a, std::size_t b);

// What a pair has from the detection before, and what it leaves for the next one: of its children, in their order.
struct KeptSide {
  std::vector<SidesOfChildren> before, after;
};
// Whether memories may be of a pair of these two.
[[nodiscard]] bool may_be_of(std::span<const SidesOfChildren> memories, const AnyShape& a, const AnyShape& b);
// The contacts of a pair with a body that touches a surface, in the frame of a: out to the side from which it came.
// Answers false where those that the pair has without a memory stand; else they are added to `out`. Whatever the
// margin, what touches is remembered. O(triangles that bodies touch).
[[nodiscard]] bool contacts_on_side(const AnyShape& a, const AnyShape& b, const Pose& ab, const QuerySettings& settings,
                                    KeptSide& side, Manifold& out);

}  // namespace abut
