// SPDX-License-Identifier: Apache-2.0
// Seeded boxes and placements, and a proof of distance that looks at corners only.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

import abut.math;

namespace test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  abut::Vec3 point(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  abut::Rotation rotation() {
    for (;;) {
      const abut::Quat q{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
      if (square > 0.01 && square < 1) {
        return abut::Rotation::from(q);
      }
    }
  }

 private:
  std::mt19937_64 engine_;
};

inline std::vector<abut::Vec3> corners_of(const abut::Vec3& half, const abut::Pose& pose) {
  std::vector<abut::Vec3> corners;
  for (const double x : {-half.x, half.x}) {
    for (const double y : {-half.y, half.y}) {
      for (const double z : {-half.z, half.z}) {
        corners.push_back(pose * abut::Vec3{x, y, z});
      }
    }
  }
  return corners;
}

inline bool is_inside(const abut::Vec3& half, const abut::Vec3& p, double slack) {
  return std::fabs(p.x) <= half.x + slack && std::fabs(p.y) <= half.y + slack && std::fabs(p.z) <= half.z + slack;
}

// How much nearer than dot(n, q - p) the corners of two convex bodies come along n. Points p and q of
// the bodies are nearest to each other if and only if this is zero for n = q - p.
inline double corners_overreach(const std::vector<abut::Vec3>& a, const std::vector<abut::Vec3>& b, const abut::Vec3& n,
                                double distance) {
  double top = -abut::infinity, bottom = abut::infinity;
  for (const abut::Vec3& p : a) {
    top = std::fmax(top, dot(n, p));
  }
  for (const abut::Vec3& p : b) {
    bottom = std::fmin(bottom, dot(n, p));
  }
  return distance - (bottom - top);
}

}  // namespace test
