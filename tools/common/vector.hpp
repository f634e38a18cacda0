// SPDX-License-Identifier: Apache-2.0
// Small arithmetic on the vectors, quaternions and poses of the C interface. Only operations that IEEE 754 rounds
// correctly (+ - * / sqrt) are used, so that a motion built from them is the same on every machine.
#pragma once

#include <cmath>

#include "abut/abut.h"

namespace tools {

using Vec3 = abut_vec3;

[[nodiscard]] constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] constexpr Vec3 operator*(const Vec3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
[[nodiscard]] constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// The vector must not be zero.
[[nodiscard]] inline Vec3 normalised(const Vec3& a) { return a * (1.0 / length(a)); }

[[nodiscard]] constexpr abut_quat conjugate(const abut_quat& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// First q, then p.
[[nodiscard]] constexpr abut_quat multiply(const abut_quat& p, const abut_quat& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

[[nodiscard]] inline double norm(const abut_quat& q) {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}

/// The quaternion must not be zero.
[[nodiscard]] inline abut_quat unit(const abut_quat& q) {
  const double scale = 1.0 / norm(q);
  return {q.w * scale, q.x * scale, q.y * scale, q.z * scale};
}

/// v turned by a unit quaternion.
[[nodiscard]] constexpr Vec3 rotate(const abut_quat& q, const Vec3& v) {
  const Vec3 axis{q.x, q.y, q.z};
  const Vec3 twice = cross(axis, v) * 2.0;
  return v + twice * q.w + cross(axis, twice);
}

/// The rotation whose matrix has the orthonormal, right-handed columns x, y and z.
[[nodiscard]] inline abut_quat from_axes(const Vec3& x, const Vec3& y, const Vec3& z) {
  // The largest of the four components is computed first: the others are quotients by it.
  const double trace = x.x + y.y + z.z;
  if (trace > 0.0) {
    const double s = 2.0 * std::sqrt(trace + 1.0);
    return {0.25 * s, (y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s};
  }
  if (x.x > y.y && x.x > z.z) {
    const double s = 2.0 * std::sqrt(1.0 + x.x - y.y - z.z);
    return {(y.z - z.y) / s, 0.25 * s, (y.x + x.y) / s, (z.x + x.z) / s};
  }
  if (y.y > z.z) {
    const double s = 2.0 * std::sqrt(1.0 + y.y - x.x - z.z);
    return {(z.x - x.z) / s, (y.x + x.y) / s, 0.25 * s, (z.y + y.z) / s};
  }
  const double s = 2.0 * std::sqrt(1.0 + z.z - x.x - y.y);
  return {(x.y - y.x) / s, (z.x + x.z) / s, (z.y + y.z) / s, 0.25 * s};
}

inline constexpr abut_quat no_rotation{1.0, 0.0, 0.0, 0.0};

}  // namespace tools
