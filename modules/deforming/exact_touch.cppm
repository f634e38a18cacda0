// SPDX-License-Identifier: Apache-2.0
// The same as quick_touch in whole numbers of any length: for what rounding leaves open.
export module abut.deforming.exact_touch;
import abut.core.standard;
import abut.deforming;
import abut.deforming.moving_triangle;

export namespace abut {

// Takes some microseconds, and up to a millisecond where coordinates have very different exponents or all of the motion
// lies in one plane. Coordinates are finite.
[[nodiscard]] MovingTouch exact_touch(const std::array<MovingDifference, 3>& corners);

}  // namespace abut
