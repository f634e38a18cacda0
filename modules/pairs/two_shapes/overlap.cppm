// SPDX-License-Identifier: Apache-2.0
// Whether two placed shapes overlap.
export module abut.pairs.two_shapes.overlap;
import abut.capability;
import abut.math;
export import abut.pairs.registry.overlaps;
import abut.pairs.shape_handle;

export namespace abut {

// As ask_overlap, the same whichever shape comes first: the order of work depends on the shapes and poses alone.
[[nodiscard]] Outcome pair_overlaps(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    Real margin, OverlapRule rule, Manifold& scratch, bool& out);

}  // namespace abut
