// SPDX-License-Identifier: Apache-2.0
// Contacts of a surface and a convex body that has passed it: as deep as the way back to the side from which the body
// came.
export module abut.pairs.registry.kept_sides;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
export import abut.narrow.warm.side_memory;
import abut.pairs.registry;

export namespace abut {

// Whether pairs of a surface, by its place in the registry, and another kind may remember a side.
[[nodiscard]] bool may_keep_side(std::size_t surface, std::size_t body);
// Whether a memory may be of a pair with this surface.
[[nodiscard]] bool may_be_of(const SideMemory& memory, const AnyShape& surface);

// What a pair has from the detection before, and what it leaves for the next one.
struct KeptSide {
  SideMemory before, after;
};
// The contacts of a body that is placed by `ab` in the frame of a surface, which is side a. Answers false where those
// that the pair has without a memory stand; else they are added to `out`. Whatever the margin, what touches is
// remembered. O(triangles that the body touches).
[[nodiscard]] bool contacts_on_side(const AnyShape& surface, const AnyShape& body, const Pose& ab,
                                    const QuerySettings& settings, KeptSide& side, Manifold& out);

}  // namespace abut
