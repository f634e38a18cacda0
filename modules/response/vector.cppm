// SPDX-License-Identifier: Apache-2.0
// Vectors, matrices, turns and ids, on the plain structs of the C interface.
module;

#include <abut/abut.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

export module abut.response:vector;

export namespace abut::response {

using Matrix = std::array<double, 9>;  // row by row

[[nodiscard]] inline bool is_same(const abut_geometry_id& a, const abut_geometry_id& b) {
  return a.slot == b.slot && a.generation == b.generation;
}

// The i-th of vectors that lie as three numbers each.
[[nodiscard]] inline abut_vec3 vector_at(const std::vector<double>& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}
inline void set_vector_at(std::vector<double>& numbers, std::size_t i, const abut_vec3& v) {
  numbers[3 * i] = v.x;
  numbers[3 * i + 1] = v.y;
  numbers[3 * i + 2] = v.z;
}

[[nodiscard]] inline abut_vec3 add(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] inline abut_vec3 subtract(const abut_vec3& a, const abut_vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline abut_vec3 scale(const abut_vec3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
[[nodiscard]] inline double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(const abut_vec3& a) { return std::sqrt(dot(a, a)); }

// Of numbers whose squares stay finite. A square root has the same bits on any machine; std::hypot need not.
[[nodiscard]] inline double norm_of(double a, double b, double c = 0) { return std::sqrt(a * a + b * b + c * c); }

[[nodiscard]] inline abut_vec3 times(const Matrix& m, const abut_vec3& v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}
[[nodiscard]] inline Matrix transposed(const Matrix& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}
[[nodiscard]] inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) out[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    }
  }
  return out;
}

// Of a unit quaternion.
[[nodiscard]] inline Matrix matrix_of(const abut_quat& q) {
  return {1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z),     2 * (q.x * q.z + q.w * q.y),
          2 * (q.x * q.y + q.w * q.z),     1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x),
          2 * (q.x * q.z - q.w * q.y),     2 * (q.y * q.z + q.w * q.x),     1 - 2 * (q.x * q.x + q.y * q.y)};
}
[[nodiscard]] inline abut_quat product(const abut_quat& a, const abut_quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
[[nodiscard]] inline abut_quat normalized(const abut_quat& q) {
  const double size = 1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * size, q.x * size, q.y * size, q.z * size};
}
// Any direction at right angles to a unit vector: Duff et al., "Building an orthonormal basis, revisited" (2017),
// https://jcgt.org/published/0006/01/01/.
[[nodiscard]] inline abut_vec3 across(const abut_vec3& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z);
  return {1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}
// The turn by 2 atan(|half|) about the direction of a vector: no sine, so the same bits on any machine.
[[nodiscard]] inline abut_quat cayley(const abut_vec3& half) { return normalized({1, half.x, half.y, half.z}); }

}  // namespace abut::response
