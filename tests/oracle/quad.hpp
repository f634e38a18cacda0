// SPDX-License-Identifier: Apache-2.0
// Vectors and rotations in 113-bit floating point, for the oracle only.
#pragma once

#include <array>
#include <cmath>

namespace oracle {

using Quad = __float128;

[[nodiscard]] constexpr Quad quad(double value) { return static_cast<Quad>(value); }

// Square root by Newton steps on the double result: two steps take 53 good bits past 113. The argument is scaled
// by a power of four so that its double neither overflows nor underflows.
[[nodiscard]] inline Quad square_root(Quad value) {
  if (!(value > 0)) return 0;
  Quad scale = 1;
  while (value < quad(1e-200)) {
    value *= quad(0x1p400);
    scale *= quad(0x1p-200);
  }
  while (value > quad(1e200)) {
    value *= quad(0x1p-400);
    scale *= quad(0x1p200);
  }
  Quad root = quad(std::sqrt(static_cast<double>(value)));
  root = (root + value / root) / 2;
  root = (root + value / root) / 2;
  return root * scale;
}

[[nodiscard]] inline Quad absolute(Quad value) { return value < 0 ? -value : value; }
[[nodiscard]] inline Quad smaller(Quad a, Quad b) { return b < a ? b : a; }
[[nodiscard]] inline Quad larger(Quad a, Quad b) { return a < b ? b : a; }
[[nodiscard]] inline Quad clamped(Quad value, Quad low, Quad high) { return larger(low, smaller(value, high)); }

struct Vec {
  Quad x = 0;
  Quad y = 0;
  Quad z = 0;

  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec operator-(const Vec& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec operator*(const Vec& a, Quad s) { return {a.x * s, a.y * s, a.z * s}; }
};

[[nodiscard]] inline Quad dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Quad length(const Vec& a) { return square_root(dot(a, a)); }

// Unit vector along `a`; zero stays zero.
[[nodiscard]] inline Vec unit(const Vec& a) {
  const Quad size = length(a);
  return size > 0 ? a * (1 / size) : Vec{};
}

// Any unit vector at a right angle to the unit vector `a`.
[[nodiscard]] inline Vec perpendicular(const Vec& a) {
  const Vec axis = absolute(a.x) < quad(0.6) ? Vec{1, 0, 0} : Vec{0, 1, 0};
  return unit(cross(a, axis));
}

// A position and an orientation (w, x, y, z), read from doubles; the orientation is normalised in 113 bits.
struct Pose {
  Vec position;
  std::array<Quad, 4> orientation{1, 0, 0, 0};

  [[nodiscard]] static Pose from(const std::array<double, 3>& p, const std::array<double, 4>& wxyz) {
    Pose pose;
    pose.position = {quad(p[0]), quad(p[1]), quad(p[2])};
    Quad squared = 0;
    for (const double part : wxyz) squared += quad(part) * quad(part);
    const Quad size = square_root(squared);
    for (std::size_t i = 0; i < 4; ++i) pose.orientation[i] = quad(wxyz[i]) / size;
    return pose;
  }

  [[nodiscard]] Vec rotate(const Vec& v) const {
    const Vec axis{orientation[1], orientation[2], orientation[3]};
    const Vec twice = cross(axis, v) * 2;
    return v + twice * orientation[0] + cross(axis, twice);
  }
  [[nodiscard]] Vec rotate_back(const Vec& v) const {
    const Vec axis{-orientation[1], -orientation[2], -orientation[3]};
    const Vec twice = cross(axis, v) * 2;
    return v + twice * orientation[0] + cross(axis, twice);
  }
  [[nodiscard]] Vec place(const Vec& local) const { return rotate(local) + position; }
};

}  // namespace oracle
