// SPDX-License-Identifier: Apache-2.0
// A box with what decides whom it may pair with, in half a cache line.
export module abut.broadphase.box_record;
import abut.broadphase.proxy;
import abut.core.standard;
import abut.math;

export namespace abut {

struct alignas(32) BoxRecord {
  std::array<float, 3> low;
  std::uint32_t group;
  std::array<float, 3> high;
  std::uint32_t state;

  // Of `state`.
  static constexpr std::uint32_t present = 1, moving = 2, hidden = 4, touched = 8, unbounded = 16;

  [[nodiscard]] inline bool is(std::uint32_t bits) const { return (state & bits) == bits; }
  [[nodiscard]] inline CompactAabb box() const { return {low, high}; }
  inline void set_box(const CompactAabb& box) {
    low = box.low;
    high = box.high;
  }
};
static_assert(sizeof(BoxRecord) == 32);

// Overlaps nothing, not even what is everywhere: a comparison with it is never true.
inline constexpr CompactAabb nowhere{{std::numeric_limits<float>::quiet_NaN(), 0, 0}, {0, 0, 0}};

// Closed intervals. One comparison of eight lanes, of which group and state are left out.
[[nodiscard]] inline bool overlap(const BoxRecord& a, const BoxRecord& b) {
  using Sides = float __attribute__((ext_vector_type(8)));
  using Bits = std::int32_t __attribute__((ext_vector_type(8)));
  // The lower sides of a against the upper ones of b, and the other way round with both negated.
  constexpr std::int32_t sign = std::numeric_limits<std::int32_t>::min();
  constexpr Bits negate_upper{0, 0, 0, 0, sign, sign, sign, sign};
  const auto first = std::bit_cast<Bits>(a), second = std::bit_cast<Bits>(b);
  const Bits swapped = __builtin_shufflevector(second, second, 4, 5, 6, 7, 0, 1, 2, 3);
  const Bits fits = std::bit_cast<Sides>(first ^ negate_upper) <= std::bit_cast<Sides>(swapped ^ negate_upper);
  constexpr Bits not_sides{0, 0, 0, -1, 0, 0, 0, -1};
  return __builtin_reduce_and(fits | not_sides) != 0;
}

}  // namespace abut
