// SPDX-License-Identifier: Apache-2.0
// When two boxes overlap of which one moves without turning. On each of the fifteen separating axes they do in a
// stretch of the way. The boxes overlap in what all stretches have in common (Gottschalk et al., "OBBTree", 1996).
export module abut.narrow.cast.swept_boxes;
import abut.math;
import abut.narrow.cast.linear_cast;

export namespace abut {

// The stretch of the way on which the boxes are no further apart than `slack`. It ends before it begins where there is
// none. Axes across nearly parallel edges are left out: the stretch may begin too early, and never too late. b is
// placed by ab before it moves. The way goes on before the start and after the end.
[[nodiscard]] Passage passage_of_boxes(const Vec3& half_a, const Vec3& half_b, const Pose& ab,
                                       const LinearMotion& motion, Real slack);

}  // namespace abut
