// SPDX-License-Identifier: Apache-2.0
// Shapes, poses and casts for tests of shapes that move.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

import abut.capability;
import abut.core;
import abut.math;
import abut.pairs.any_shape.casts.shape_cast;
import abut.pairs.any_shape;

namespace test::casts {

using namespace abut;

inline ShapeHandle make(std::string_view kind, const std::vector<Real>& parameters, const std::vector<Real>& reals = {},
                        const std::vector<std::uint32_t>& indices = {}) {
  return make_shape(*find_kind(kind), parameters, reals, indices).value();
}
inline ShapeHandle make_hull_of_box(const Vec3& half) {
  std::vector<Real> corners;
  for (int i = 0; i < 8; ++i) {
    corners.insert(corners.end(),
                   {(i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y, (i & 4) != 0 ? half.z : -half.z});
  }
  return make("hull", {}, corners);
}
inline ShapeHandle make_square(Real half, bool one_sided) {
  return make("mesh", {one_sided ? 1.0 : 0.0}, {-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0},
              {0, 1, 2, 0, 2, 3});
}
inline Pose at(const Vec3& position) { return {Rotation::identity(), position}; }

inline std::optional<ShapeCastHit> cast(const AnyShape& a, const Pose& pose_a, const Vec3& displacement_a,
                                        const AnyShape& b, const Pose& pose_b, const Vec3& displacement_b = {0, 0, 0},
                                        Real margin = 0) {
  std::optional<ShapeCastHit> hit;
  EXPECT_EQ(cast_shapes(a, pose_a, displacement_a, b, pose_b, displacement_b, {.margin = margin}, 1, hit), Outcome::ok);
  return hit;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  Real in(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine_); }
  Vec3 vector(Real size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  Pose pose(const Vec3& position) { return {Rotation::from({in(0.1, 1), in(-1, 1), in(-1, 1), in(-1, 1)}), position}; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace test::casts
