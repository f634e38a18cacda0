// SPDX-License-Identifier: Apache-2.0
// Whether a one-sided triangle stops a convex part that touches it on a straight way.
export module abut.narrow.cast.front_touch;
import abut.core.standard;
import abut.math;

export namespace abut {

// A touch of two parts, one of which is a one-sided triangle. Directions lead from the first part to the second, which
// moves. Gaps are those at the start, less the margin: negative where a part reaches beyond the other one.
struct TouchOfFront {
  Vec3 front;   // in which the triangle faces the other part
  Vec3 normal;  // along which the parts are closest before the touch, or at the start
  Real gap_along_front, gap_along_normal;
  bool is_later;  // than the start
};

// `slack`: how far a part may reach beyond a plane by rounding, which decides neither of these:
//  - Parts on the two sides of a plane that do not approach along its normal never overlap, so they touch nowhere.
//  - A part that is in front of the triangle at the start and moves against its normal is stopped there.
[[nodiscard]] bool stops(const TouchOfFront& touch, const UnitVec3& direction, Real slack);

}  // namespace abut
