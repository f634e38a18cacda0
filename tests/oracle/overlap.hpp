// SPDX-License-Identifier: Apache-2.0
// The overlap of two solids along a direction in double, fast enough to propose directions that float128 judges.
#pragma once

#include <array>
#include <cmath>

#include "solid.hpp"
#include "support.hpp"

namespace oracle {

using Matrix = std::array<Point, 3>;  // rows

[[nodiscard]] inline double inner(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
[[nodiscard]] inline Point times(const Matrix& m, const Point& v) {
  return {inner(m[0], v), inner(m[1], v), inner(m[2], v)};
}
[[nodiscard]] inline Point sum(const Point& u, const Point& v, double factor) {
  return {u[0] + factor * v[0], u[1] + factor * v[1], u[2] + factor * v[2]};
}
[[nodiscard]] inline Point vector_product(const Point& u, const Point& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
[[nodiscard]] inline Point unit_of(const Point& v) {
  const double size = std::sqrt(inner(v, v));
  return {v[0] / size, v[1] / size, v[2] / size};
}
[[nodiscard]] inline Point rounded(const Vec& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
[[nodiscard]] inline Vec exact(const Point& p) { return {quad(p[0]), quad(p[1]), quad(p[2])}; }

// The rows are the axes of the local frame in the world.
[[nodiscard]] inline Matrix turned_back(const Pose& pose) {
  return {rounded(pose.rotate({1, 0, 0})), rounded(pose.rotate({0, 1, 0})), rounded(pose.rotate({0, 0, 1}))};
}

class Pair {
 public:
  Pair(const Solid& a, const Pose& pose_a, const Solid& b, const Pose& pose_b)
      : a_(a),
        b_(b),
        to_a_(turned_back(pose_a)),
        to_b_(turned_back(pose_b)),
        from_b_(rounded(pose_a.position - pose_b.position)) {}

  [[nodiscard]] double overlap(const Point& n) const {
    const Point in_b = times(to_b_, n);
    return support(a_, times(to_a_, n)) + support(b_, Point{-in_b[0], -in_b[1], -in_b[2]}) + inner(from_b_, n);
  }

  [[nodiscard]] const Solid& a() const { return a_; }
  [[nodiscard]] const Solid& b() const { return b_; }
  [[nodiscard]] const Matrix& to_a() const { return to_a_; }
  [[nodiscard]] const Matrix& to_b() const { return to_b_; }
  [[nodiscard]] const Point& from_b() const { return from_b_; }

 private:
  const Solid& a_;
  const Solid& b_;
  Matrix to_a_;
  Matrix to_b_;
  Point from_b_;
};

}  // namespace oracle
