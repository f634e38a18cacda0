// SPDX-License-Identifier: Apache-2.0
// Points that lie across from each other: move one core onto the other along the normal that separates them best. Their
// outermost parts meet, and each common point is a pair of witnesses.
export module abut.narrow.points.closest_of_faces;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

struct AcrossPair {
  Vec3 point_a, point_b;
};

// Both supporting faces in one frame, `normal` of length one from a to b; vertices within `slack` of
// the outermost one count as outermost. Where the parts do not meet, the pair that is least aside.
[[nodiscard]] AcrossPair points_across(const Face& a, const Face& b, const Vec3& normal, Real slack);

}  // namespace abut
