// SPDX-License-Identifier: Apache-2.0
// Four doubles in one vector register, where the target has one. Vectors of space lie in the first three. The fused
// multiply-add is exact on every target, so answers do not depend on whether the processor has one.
//
// All is inlined at once. Optimised alone, a function that reads a vector by its address reads the numbers in pairs.
// Then the vectors of its callers have to be in memory.
export module abut.math.lanes;
import abut.core.standard;
import abut.math.vec3;

export namespace abut {

using Lanes = double __attribute__((ext_vector_type(4)));
using LaneNumbers = std::int64_t __attribute__((ext_vector_type(4)));

// The fourth lane of a vector of space is zero.
[[nodiscard]] [[gnu::always_inline]] inline Lanes lanes_of(const Vec3& a) { return Lanes{a.x, a.y, a.z, 0}; }
[[nodiscard]] [[gnu::always_inline]] inline Vec3 vec3_of(Lanes a) { return {a[0], a[1], a[2]}; }
[[nodiscard]] [[gnu::always_inline]] inline Lanes all_lanes(Real value) { return Lanes{value, value, value, value}; }

[[nodiscard]] [[gnu::always_inline]] inline Lanes absolute(Lanes a) { return __builtin_elementwise_abs(a); }
[[nodiscard]] [[gnu::always_inline]] inline Lanes minimum(Lanes a, Lanes b) { return a < b ? a : b; }
[[nodiscard]] [[gnu::always_inline]] inline Lanes maximum(Lanes a, Lanes b) { return a > b ? a : b; }
// The nearest value within -limit and limit.
[[nodiscard]] [[gnu::always_inline]] inline Lanes clamp(Lanes a, Lanes limit) {
  return minimum(maximum(a, -limit), limit);
}
[[nodiscard]] [[gnu::always_inline]] inline Lanes multiply_add(Lanes a, Lanes b, Lanes c) {
  return __builtin_elementwise_fma(a, b, c);
}

// A bit per lane of a comparison, and with the sign of each number.
[[nodiscard]] [[gnu::always_inline]] inline std::uint64_t bits_of(LaneNumbers flags) {
#if defined(__AVX__) && !defined(__AVX512VL__)
  // Of comparisons that are combined the compiler packs the flags first, which takes eight instructions.
  using Numbers = double __attribute__((vector_size(32)));
  return static_cast<std::uint64_t>(__builtin_ia32_movmskpd256(std::bit_cast<Numbers>(flags)));
#else
  using Flags = bool __attribute__((ext_vector_type(4)));
  return std::bit_cast<std::uint8_t>(__builtin_convertvector(flags, Flags)) & 15u;
#endif
}
[[nodiscard]] [[gnu::always_inline]] inline std::uint64_t signs_of(Lanes values) {
  return bits_of(values < all_lanes(0));
}

[[nodiscard]] [[gnu::always_inline]] inline Real sum(Lanes a) {
  const auto pairs = a.lo + a.hi;
  return pairs[0] + pairs[1];
}
// Over all four lanes.
[[nodiscard]] [[gnu::always_inline]] inline Real largest(Lanes a) {
  const auto pairs = a.lo > a.hi ? a.lo : a.hi;
  return pairs[0] > pairs[1] ? pairs[0] : pairs[1];
}
[[nodiscard]] [[gnu::always_inline]] inline Real dot(Lanes a, Lanes b) { return sum(a * b); }

}  // namespace abut
