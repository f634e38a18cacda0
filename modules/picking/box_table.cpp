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

BoxTable::Crossed BoxTable::crossed_by(const Group& group, std::span<const HalfSpace> planes) {
  Crossed out{.inside = 15, .planes = {}};
  const Four size = __builtin_elementwise_abs(group.x) + __builtin_elementwise_abs(group.y) +
                    __builtin_elementwise_abs(group.z) + group.half_x + group.half_y + group.half_z;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [normal, offset] = planes[i];
    const Four height = normal.x * group.x + normal.y * group.y + normal.z * group.z - offset;
    const Four reach = std::fabs(normal.x) * group.half_x + std::fabs(normal.y) * group.half_y +
                       std::fabs(normal.z) * group.half_z + rounding * (size + std::fabs(offset));
    out.inside &= bits_of(height >= -reach);
    if (out.inside == 0) return out;
    const unsigned crossed = bits_of(height < reach);
    if (crossed == 0) continue;
    for (std::size_t lane = 0; lane < 4; ++lane) out.planes[lane] |= PlaneBits{crossed >> lane & 1u} << i;
  }
  return out;
}

}  // namespace abut::picking
