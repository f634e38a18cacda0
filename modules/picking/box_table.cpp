// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

module abut.picking;
import :box_table;
import :region;
import :vector;

namespace abut::picking {

namespace {

// Rounding of a height above a plane, in parts of the coordinates.
constexpr double rounding = 0x1p-46;

using Lanes = decltype(Four{} < Four{});

[[nodiscard]] unsigned bits_of(const Lanes& lanes) {
  return static_cast<unsigned>(__builtin_reduce_or(lanes & Lanes{1, 2, 4, 8}));
}

}  // namespace

void BoxTable::set(std::uint32_t slot, const abut_aabb& box) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (slot / 4 >= groups_.size()) groups_.resize(slot / 4 + 1, Group{none, none, none, 0, 0, 0});
  Group& group = groups_[slot / 4];
  const std::size_t lane = slot % 4;
  const abut_vec3 middle = centre_of(box);
  const abut_vec3 half = scale(subtract(box.maximum, box.minimum), 0.5);
  group.x[lane] = middle.x;
  group.y[lane] = middle.y;
  group.z[lane] = middle.z;
  group.half_x[lane] = half.x;
  group.half_y[lane] = half.y;
  group.half_z[lane] = half.z;
}

void BoxTable::erase(std::uint32_t slot) {
  if (slot / 4 < groups_.size()) groups_[slot / 4].x[slot % 4] = std::numeric_limits<double>::quiet_NaN();
}

// The lowest and the highest points of boxes above all planes decide most groups; only a group with a box that crosses
// one is looked at plane by plane.
BoxTable::Crossed BoxTable::crossed_by(const Group& group, std::span<const HalfSpace> planes) {
  const Four blur = rounding * (__builtin_elementwise_abs(group.x) + __builtin_elementwise_abs(group.y) +
                                __builtin_elementwise_abs(group.z) + group.half_x + group.half_y + group.half_z);
  const auto height_of = [&](const HalfSpace& plane) {
    return plane.normal.x * group.x + plane.normal.y * group.y + plane.normal.z * group.z - plane.offset;
  };
  const auto reach_of = [&](const HalfSpace& plane) {
    return std::fabs(plane.normal.x) * group.half_x + std::fabs(plane.normal.y) * group.half_y +
           std::fabs(plane.normal.z) * group.half_z + (blur + rounding * std::fabs(plane.offset));
  };
  // No number where there is no box.
  Four highest = 0 * group.x + infinity;
  Four lowest = highest;
  for (const HalfSpace& plane : planes) {
    const Four height = height_of(plane);
    const Four reach = reach_of(plane);
    highest = __builtin_elementwise_min(highest, height + reach);
    lowest = __builtin_elementwise_min(lowest, height - reach);
  }
  Crossed out{.inside = bits_of(highest >= 0), .planes = {}};
  if ((out.inside & ~bits_of(lowest >= 0)) == 0) return out;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const unsigned crossed = bits_of(height_of(planes[i]) < reach_of(planes[i]));
    for (std::size_t lane = 0; lane < 4; ++lane) out.planes[lane] |= PlaneBits{crossed >> lane & 1u} << i;
  }
  return out;
}

}  // namespace abut::picking
