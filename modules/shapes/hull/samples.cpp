// SPDX-License-Identifier: Apache-2.0
module abut.shapes.hull;
import abut.core.standard;
import abut.math;

namespace abut {

std::vector<Hull> Hull::samples() {
  const auto hull_of = [](std::span<const Real> xyz) { return make({}, xyz, {}).value(); };
  const auto tetrahedron = std::to_array<Real>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  const auto square = std::to_array<Real>({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
  const auto segment = std::to_array<Real>({-1, 0, 0, 2, 0, 0});
  // 32 and 200 points spread evenly over an ellipsoid (Fibonacci lattice).
  const auto pebble = [&](std::size_t count) {
    std::vector<Real> xyz;
    for (std::size_t i = 0; i < count; ++i) {
      const Real z = 1 - (2 * static_cast<Real>(i) + 1) / static_cast<Real>(count);
      const Real r = std::sqrt(1 - z * z), angle = std::numbers::pi * (3 - std::sqrt(5.0)) * static_cast<Real>(i);
      xyz.insert(xyz.end(), {1.2 * r * std::cos(angle), r * std::sin(angle), 0.8 * z});
    }
    return hull_of(xyz);
  };
  return {pebble(32), hull_of(tetrahedron), hull_of(square), hull_of(segment), pebble(200)};
}

}  // namespace abut
