// SPDX-License-Identifier: Apache-2.0
module abut.pairs.two_shapes.overlap;
import abut.capability;
import abut.math;
import abut.pairs.any_shape;

namespace abut {

Outcome pair_overlaps(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b, Real margin,
                      OverlapRule rule, Manifold& scratch, bool& out) {
  const bool from_b = starts_from_b(a, b, pose_a, pose_b);
  return from_b ? ask_overlap(b, a, pose_b, pose_a, margin, rule, scratch, out)
                : ask_overlap(a, b, pose_a, pose_b, margin, rule, scratch, out);
}

}  // namespace abut
