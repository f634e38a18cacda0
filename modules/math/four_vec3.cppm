// SPDX-License-Identifier: Apache-2.0
// Four vectors of space at a time, one per lane.
export module abut.math.four_vec3;
import abut.core.standard;
import abut.math;

export namespace abut {

struct Columns {
  Lanes x, y, z;

  // Each lane of it the same vector.
  [[nodiscard]] [[gnu::always_inline]] static inline Columns all(const Vec3& v) {
    return {all_lanes(v.x), all_lanes(v.y), all_lanes(v.z)};
  }
  // From vectors of space with any fourth lane.
  [[nodiscard]] [[gnu::always_inline]] static inline Columns of(Lanes a, Lanes b, Lanes c, Lanes d) {
    const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5), __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
            __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7)};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Vec3 operator[](std::size_t lane) const {
    return {x[lane], y[lane], z[lane]};
  }
  inline void put(std::size_t lane, const Vec3& v) {
    x[lane] = v.x;
    y[lane] = v.y;
    z[lane] = v.z;
  }
};
[[nodiscard]] [[gnu::always_inline]] inline Columns operator+(const Columns& a, const Columns& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] [[gnu::always_inline]] inline Columns operator-(const Columns& a, const Columns& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] [[gnu::always_inline]] inline Columns operator*(Lanes s, const Columns& a) {
  return {s * a.x, s * a.y, s * a.z};
}
[[nodiscard]] [[gnu::always_inline]] inline Lanes dot(const Columns& a, const Columns& b) {
  return multiply_add(a.z, b.z, multiply_add(a.y, b.y, a.x * b.x));
}
[[nodiscard]] [[gnu::always_inline]] inline Lanes largest_magnitude(const Columns& a) {
  return maximum(maximum(absolute(a.x), absolute(a.y)), absolute(a.z));
}
[[nodiscard]] [[gnu::always_inline]] inline Columns cross(const Columns& a, const Columns& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace abut
