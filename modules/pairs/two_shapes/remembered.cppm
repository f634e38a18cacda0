// SPDX-License-Identifier: Apache-2.0
// Queries on two placed shapes that begin with what earlier ones of the same two have left.
export module abut.pairs.two_shapes.remembered;
import abut.capability;
import abut.math;
export import abut.narrow.apart.pair_hint;
export import abut.narrow.warm.pair_memory;
import abut.pairs.shape_handle;

export namespace abut {

// With what earlier calls for the same two shapes in this order have left in `memory`, which begins all zero: the
// answer is the same bit by bit, sooner where the bodies have moved little.
[[nodiscard]] Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, PairMemory& memory, Manifold& out);

// With what the last query for the same two shapes has left in `hint`, and leaving there what this one found. Any hint
// gives the answer without one, within its bound.
[[nodiscard]] Outcome pair_distance(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, PairHint& hint, Distance& out);
[[nodiscard]] Outcome pair_contacts(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                    const QuerySettings& settings, PairHint& hint, Manifold& out);

}  // namespace abut
