// SPDX-License-Identifier: Apache-2.0
// Whether two placed shapes overlap.
export module abut.pairs.any_shape.overlap;
import abut.capability;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.registry;
export import abut.pairs.registry.overlaps;

export namespace abut {

// As ask_overlap, the same whichever shape comes first: the order of work depends on the shapes and poses alone.
[[nodiscard]] inline Outcome pair_overlaps(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                           Real margin, OverlapRule rule, Manifold& scratch, bool& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  return from_b ? ask_overlap(b, a, pose_b, pose_a, margin, rule, scratch, out)
                : ask_overlap(a, b, pose_a, pose_b, margin, rule, scratch, out);
}

}  // namespace abut
