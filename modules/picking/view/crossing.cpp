// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

module abut.picking;
import :crossing;
import :vector;

namespace abut::picking {

namespace {

[[nodiscard]] int sign(double a, double b) { return a > b ? 1 : a < b ? -1 : 0; }

[[nodiscard]] std::array<double, 3> numbers_of(const abut_vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

LineOfSight::LineOfSight(const abut_vec3& start, const abut_vec3& direction, double size) noexcept
    : start_(start), direction_(direction), scale_(size > 0 ? std::scalbn(1.0, -std::ilogb(size)) : 1) {
  const std::array<double, 3> along = numbers_of(direction);
  std::size_t largest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (std::fabs(along[axis]) > std::fabs(along[largest])) largest = axis;
  }
  axes_ = {(largest + 1) % 3, (largest + 2) % 3, largest};
  along_ = along[largest];
  shear_x_ = along[axes_[0]] / along_;
  shear_y_ = along[axes_[1]] / along_;
}

LineOfSight::Seen LineOfSight::seen(const abut_vec3& point) const noexcept {
  const std::array<double, 3> p = numbers_of(scale(subtract(point, start_), scale_));
  const double z = p[axes_[2]];
  return {p[axes_[0]] - shear_x_ * z, p[axes_[1]] - shear_y_ * z, z};
}

// Of the origin, by the sign of from.x * to.y - from.y * to.x: exact, as products are compared before they are rounded.
// Zero only where both are one point.
int LineOfSight::side_of(const Seen& from, const Seen& to) noexcept {
  const double left = from.x * to.y;
  const double right = from.y * to.x;
  if (left != right) return sign(left, right);
  if (const int rest = sign(std::fma(from.x, to.y, -left), std::fma(from.y, to.x, -right)); rest != 0) return rest;
  if (const int by_y = sign(from.y, to.y); by_y != 0) return by_y;
  return sign(to.x, from.x);
}

std::optional<LineOfSight::Met> LineOfSight::crosses(const std::array<abut_vec3, 3>& corners) const noexcept {
  const Seen a = seen(corners[0]), b = seen(corners[1]), c = seen(corners[2]);
  const int side = side_of(a, b);
  if (side == 0 || side_of(b, c) != side || side_of(c, a) != side) return std::nullopt;
  // On its plane, but never beyond its corners, however steep it is.
  const abut_vec3 normal =
      cross(scale(subtract(corners[1], corners[0]), scale_), scale(subtract(corners[2], corners[0]), scale_));
  const double exact = dot(normal, subtract(corners[0], start_)) / dot(normal, direction_);
  const auto [low, high] = std::minmax({a.z / (scale_ * along_), b.z / (scale_ * along_), c.z / (scale_ * along_)});
  return Met{std::isfinite(exact) ? std::clamp(exact, low, high) : 0.5 * (low + high), (side > 0) != (along_ > 0)};
}

std::array<abut_vec3, 3> CrossedSurface::corners_of(std::uint32_t triangle) const {
  std::array<abut_vec3, 3> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = 3 * static_cast<std::size_t>(list.indices[3 * std::size_t{triangle} + k]);
    out[k] = {list.xyz[at], list.xyz[at + 1], list.xyz[at + 2]};
  }
  return out;
}

}  // namespace abut::picking
