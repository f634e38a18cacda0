// SPDX-License-Identifier: Apache-2.0
// When two choices of a feature are equally good. Rounding of coordinates must not decide between them, or contacts
// would change their number and their ids under the least motion.
export module abut.capability.ties;
import abut.core.standard;
import abut.math;

export namespace abut {

// Heights and places that differ by less than this share of the size are the same. Some thousand units of rounding:
// ties stay ties under motions of a picometre per metre. It is a hundredth of what points of contacts may be off by.
inline constexpr Real tie_share = 4e-12;

// The axis along which a direction is longest; of those that tie the first one.
[[nodiscard]] [[gnu::always_inline]] inline int longest_axis(const Vec3& direction) {
  constexpr Real lead = 1 + tie_share;
  const Vec3 size = absolute(direction);
  const int first = size.y > lead * size.x ? 1 : 0;
  return size.z > lead * (first == 1 ? size.y : size.x) ? 2 : first;
}

}  // namespace abut
