// SPDX-License-Identifier: Apache-2.0
// Numbers of twice the digits, each the sum of two that do not overlap: error-free sums by Knuth (1969), products by a
// fused multiply-add, the rest as in Hida, Li, Bailey, "Algorithms for quad-double precision floating point
// arithmetic", 2001.
export module abut.math.wide;
import abut.core.standard;
import abut.math.vec3;

export namespace abut {

struct Wide {
  Real high, low;

  inline constexpr Wide(Real value) : high(value), low(0) {}
  inline constexpr Wide(Real larger, Real smaller) : high(larger), low(smaller) {}
  explicit inline constexpr operator Real() const { return high; }

  // Two numbers whose sum is exact; `larger` is.
  [[nodiscard]] static inline constexpr Wide of_ordered(Real larger, Real smaller) {
    const Real sum = larger + smaller;
    return {sum, smaller - (sum - larger)};
  }
  [[nodiscard]] static inline constexpr Wide sum(Real a, Real b) {
    const Real sum = a + b, of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
  }
  [[nodiscard]] static inline Wide product(Real a, Real b) {
    const Real rounded = a * b;
    return {rounded, __builtin_fma(a, b, -rounded)};
  }
};

[[nodiscard]] inline constexpr Wide operator-(const Wide& a) { return {-a.high, -a.low}; }
[[nodiscard]] inline constexpr Wide operator+(const Wide& a, const Wide& b) {
  const Wide high = Wide::sum(a.high, b.high), low = Wide::sum(a.low, b.low);
  const Wide both = Wide::of_ordered(high.high, high.low + low.high);
  return Wide::of_ordered(both.high, both.low + low.low);
}
[[nodiscard]] inline constexpr Wide operator-(const Wide& a, const Wide& b) { return a + -b; }
[[nodiscard]] inline Wide operator*(const Wide& a, const Wide& b) {
  const Wide product = Wide::product(a.high, b.high);
  return Wide::of_ordered(product.high, product.low + (a.high * b.low + a.low * b.high));
}
// Long division: each digit is what the one before leaves.
[[nodiscard]] inline Wide operator/(const Wide& a, const Wide& b) {
  const Real first = a.high / b.high;
  const Wide rest = a - b * first;
  const Real second = rest.high / b.high;
  const Real third = (rest - b * second).high / b.high;
  return Wide::of_ordered(first, second) + third;
}
[[nodiscard]] inline constexpr bool operator<(const Wide& a, const Wide& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
[[nodiscard]] inline constexpr bool operator>(const Wide& a, const Wide& b) { return b < a; }
[[nodiscard]] inline constexpr bool operator<=(const Wide& a, const Wide& b) {
  return a < b || (a.high == b.high && a.low == b.low);
}
[[nodiscard]] inline constexpr bool operator>=(const Wide& a, const Wide& b) { return b <= a; }

struct WideVec3 {
  Wide x, y, z;
};

// Exact.
[[nodiscard]] inline constexpr WideVec3 wide_difference(const Vec3& a, const Vec3& b) {
  return {Wide::sum(a.x, -b.x), Wide::sum(a.y, -b.y), Wide::sum(a.z, -b.z)};
}
[[nodiscard]] inline constexpr Vec3 rounded(const WideVec3& a) { return {a.x.high, a.y.high, a.z.high}; }

[[nodiscard]] inline constexpr WideVec3 operator+(const WideVec3& a, const WideVec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline constexpr WideVec3 operator-(const WideVec3& a, const WideVec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline WideVec3 operator*(const Wide& s, const WideVec3& a) { return {s * a.x, s * a.y, s * a.z}; }

[[nodiscard]] inline Wide dot(const WideVec3& a, const WideVec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline WideVec3 cross(const WideVec3& a, const WideVec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Wide squared_norm(const WideVec3& a) { return dot(a, a); }
[[nodiscard]] inline Real largest_magnitude(const WideVec3& a) { return largest_magnitude(rounded(a)); }

// What a calculation with coordinates of such vectors rounds by, relative to its numbers.
template <class Vector>
inline constexpr Real epsilon_of = epsilon;
template <>
inline constexpr Real epsilon_of<WideVec3> = 0x1p-102;

}  // namespace abut
