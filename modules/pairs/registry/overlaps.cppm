// SPDX-License-Identifier: Apache-2.0
// Whether two shapes of any kind overlap, without a search for how deep.
export module abut.pairs.registry.overlaps;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.pairs.shape_handle;

export namespace abut {

// What counts as an overlap of a surface that stops from its front only: with distances each triangle from either side,
// with contacts what reaches before it.
enum class OverlapRule : std::uint8_t { of_distances, of_contacts };

// Whether balls around the origins of two shapes that lie at these places tell that they are further apart than a
// margin.
[[nodiscard]] bool are_far_apart(const AnyShape& a, const AnyShape& b, const Vec3& from, const Vec3& to, Real margin);

// Whether two placed shapes are no further apart than a margin. A margin below zero asks whether they overlap by more.
// Touching is an overlap, and so is a gap of the size of rounding. `out` is written when the outcome is ok. `scratch`:
// memory for contacts, where only these tell.
[[nodiscard]] Outcome ask_overlap(const AnyShape& a, const AnyShape& b, const Pose& pose_a, const Pose& pose_b,
                                  Real margin, OverlapRule rule, Manifold& scratch, bool& out);

}  // namespace abut
