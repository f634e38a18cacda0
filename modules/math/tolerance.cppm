// SPDX-License-Identifier: Apache-2.0
// How far computed lengths may be off: the one scale of the narrow phase, in units in the last place of `size`, the
// largest coordinate.
//
// - touching: 4, the difference of two coordinates, each of which a pose has rounded.
// - rounding: 16, a coordinate after a search: some ten products and sums.
// - noise: 64, a depth along a computed normal: the rounding of the normal comes times the lever of the cores. Depths
//   that differ by less are equal.
export module abut.math.tolerance;
import abut.core.standard;
import abut.math.lanes;
import abut.math.vec3;

export namespace abut {

[[nodiscard]] [[gnu::always_inline]] inline Real touching_distance(Real size) { return 4 * epsilon * size; }
[[nodiscard]] [[gnu::always_inline]] inline Real rounding_of(Real size) { return 16 * epsilon * size; }
[[nodiscard]] [[gnu::always_inline]] inline Real noise_of(Real size) { return 64 * epsilon * size; }
[[nodiscard]] [[gnu::always_inline]] inline Lanes noise_of(Lanes size) { return 64 * epsilon * size; }

// Squares of sines. Two edges nearer to parallel span no face: leaving theirs out errs by at most the angle times the
// length of an edge, which is rounding.
inline constexpr Real parallel_square = 1e-28;
// A cross product of two edges nearer to parallel is off by rounding of their lengths, which shows.
inline constexpr Real slender_square = 1e-6;

}  // namespace abut
