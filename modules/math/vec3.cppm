// SPDX-License-Identifier: Apache-2.0
// Vectors of three numbers, and those of length one.
export module abut.math.vec3;
import abut.core.standard;

export namespace abut {

using Real = double;

inline constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
inline constexpr Real infinity = std::numeric_limits<Real>::infinity();

struct Vec3 {
  Real x, y, z;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  [[nodiscard]] inline constexpr Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

[[nodiscard]] inline constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
[[nodiscard]] inline constexpr Vec3 operator*(Real s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
[[nodiscard]] inline constexpr Vec3 operator*(const Vec3& a, Real s) { return {s * a.x, s * a.y, s * a.z}; }
inline constexpr Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }

[[nodiscard]] inline constexpr Real dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline constexpr Real squared_norm(const Vec3& a) { return dot(a, a); }
[[nodiscard]] inline Vec3 absolute(const Vec3& a) { return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}; }
[[nodiscard]] inline constexpr Vec3 minimum(const Vec3& a, const Vec3& b) {
  return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
[[nodiscard]] inline constexpr Vec3 maximum(const Vec3& a, const Vec3& b) {
  return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
[[nodiscard]] inline Real largest_magnitude(const Vec3& a) {
  const Vec3 sizes = absolute(a);
  const Real larger = sizes.x > sizes.y ? sizes.x : sizes.y;
  return larger > sizes.z ? larger : sizes.z;
}
[[nodiscard]] inline bool is_finite(const Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// Length without overflow or underflow of the squares; for vectors of extreme length.
[[nodiscard]] inline Real norm(const Vec3& a) {
  const Real square = squared_norm(a);
  if (square > 1e-280 && square < 1e280) [[likely]] {
    return std::sqrt(square);
  }
  const Real scale = largest_magnitude(a);
  if (!(scale > 0) || !std::isfinite(scale)) {
    return scale;
  }
  const Vec3 scaled{a.x / scale, a.y / scale, a.z / scale};
  return scale * std::sqrt(squared_norm(scaled));
}

// A direction: length one within rounding.
class UnitVec3 {
 public:
  // Nothing for a vector of no length or with a NaN or an infinity in it.
  [[nodiscard]] static inline std::optional<UnitVec3> make(const Vec3& a) {
    const Real square = squared_norm(a);
    if (square > 1e-280 && square < 1e280) [[likely]] {
      return UnitVec3((1 / std::sqrt(square)) * a);
    }
    const Real scale = largest_magnitude(a);
    if (!(scale > 0) || !is_finite(a)) {
      return std::nullopt;
    }
    const Vec3 scaled{a.x / scale, a.y / scale, a.z / scale};
    return UnitVec3((1 / std::sqrt(squared_norm(scaled))) * scaled);
  }
  // For a vector that is known to have length one within rounding, or about to be scaled to it.
  [[nodiscard]] static inline constexpr UnitVec3 from_unit_unchecked(const Vec3& a) { return UnitVec3(a); }
  [[nodiscard]] static inline constexpr UnitVec3 axis_z() { return UnitVec3({0, 0, 1}); }

  [[nodiscard]] inline constexpr const Vec3& vec() const [[clang::lifetimebound]] { return value_; }
  inline constexpr operator Vec3() const { return value_; }
  [[nodiscard]] inline constexpr UnitVec3 operator-() const { return UnitVec3(-value_); }

 private:
  explicit constexpr UnitVec3(const Vec3& a) : value_(a) {}
  Vec3 value_;
};

// Two directions that form a right-handed frame with n (Duff et al., "Building an orthonormal basis,
// revisited", 2017).
struct Tangents {
  Vec3 first, second;
};
[[nodiscard]] inline Tangents tangents_of(const Vec3& n) {
  const Real sign = std::copysign(Real{1}, n.z);
  const Real a = -1 / (sign + n.z);
  const Real b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

}  // namespace abut
