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

// Cosines between unit vectors. Directions that are computed from the same numbers in two ways: 1.4e-6 radians.
inline constexpr Real one_direction = 1 - 1e-12;
// Normals that searches found of one face: 4.5e-5 radians.
inline constexpr Real same_normal = 1 - 1e-9;
// Of a unit normal along a unit direction: where less, the way to the plane along the direction is rounding.
inline constexpr Real least_plane_slope = 1e-9;
// Of a length, or of an edge beyond its ends: the rounding of a quotient of lengths.
inline constexpr Real share_slack = 1e-9;

// Squares of sines. A direction nearer to a plane does not pass through the plane.
inline constexpr Real along_plane_square = 1e-26;
// The cross product of two edges nearer to parallel is no axis that separates.
inline constexpr Real slim_square = 1e-20;
// Two edges nearer to parallel span no face: leaving theirs out errs by at most the angle times the
// length of an edge, which is rounding.
inline constexpr Real parallel_square = 1e-28;
// A cross product of two edges nearer to parallel is off by rounding of their lengths, which shows.
inline constexpr Real slender_square = 1e-6;

}  // namespace abut
