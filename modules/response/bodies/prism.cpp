// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// Axes and profiles may differ by so much of their size: far above the rounding of poses, far below what a mass tells.
constexpr double slack = 1e-10;

[[nodiscard]] abut_vec3 column(const Matrix& m, std::size_t i) { return {m[i], m[3 + i], m[6 + i]}; }

[[nodiscard]] Matrix from_columns(const abut_vec3& x, const abut_vec3& y, const abut_vec3& z) {
  return {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
}

// Bits of open faces: x+, x-, y+, y-, z+, z-; of open ends: top, bottom.
[[nodiscard]] bool is_open(double bits, std::size_t bit) { return (static_cast<std::uint32_t>(bits) >> bit & 1U) != 0; }

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<Prism> prisms_of(std::string_view kind, const std::vector<double>& parameters, const abut_pose& pose) {
  const Matrix turn = matrix_of(normalized(pose.orientation));
  std::vector<Prism> out;
  if (kind == "cylinder" || kind == "cylinder_hole") {
    const double open = kind == "cylinder" ? 0 : parameters.at(2);
    out.push_back({.centre = pose.position,
                   .axes = turn,
                   .low = is_open(open, 1) ? -infinity : -parameters.at(1),
                   .high = is_open(open, 0) ? infinity : parameters.at(1),
                   .half = {},
                   .radius = parameters.at(0)});
  }
  if (kind == "box" || kind == "box_hole") {
    const double open = kind == "box" ? 0 : parameters.at(3);
    for (std::size_t z = 0; z < 3; ++z) {
      const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
      // Faces are open along one axis at most, which then is that of the only prism.
      if (open > 0 && !is_open(open, 2 * z) && !is_open(open, 2 * z + 1)) continue;
      out.push_back({.centre = pose.position,
                     .axes = from_columns(column(turn, x), column(turn, y), column(turn, z)),
                     .low = is_open(open, 2 * z + 1) ? -infinity : -parameters.at(z),
                     .high = is_open(open, 2 * z) ? infinity : parameters.at(z),
                     .half = {parameters.at(x), parameters.at(y)},
                     .radius = 0});
    }
  }
  return out;
}

std::optional<Prism> part_within(const Prism& hole, const Prism& solid) {
  const abut_vec3 along = column(solid.axes, 2);
  const double cosine = dot(column(hole.axes, 2), along);
  if (std::fabs(cosine) < 1 - slack || length(cross(column(hole.axes, 2), along)) > slack) return std::nullopt;
  const abut_vec3 apart = subtract(hole.centre, solid.centre);
  const std::array<double, 2> middle{dot(apart, column(solid.axes, 0)), dot(apart, column(solid.axes, 1))};
  // The corners of the hole, or how far its disc goes along each axis.
  std::vector<std::array<double, 2>> outermost;
  if (hole.radius > 0) {
    for (const double sign : {-1.0, 1.0}) {
      outermost.push_back({middle[0] + sign * hole.radius, middle[1] + sign * hole.radius});
    }
  } else {
    for (const double x : {-hole.half[0], hole.half[0]}) {
      for (const double y : {-hole.half[1], hole.half[1]}) {
        const abut_vec3 corner = add(scale(column(hole.axes, 0), x), scale(column(hole.axes, 1), y));
        outermost.push_back(
            {middle[0] + dot(corner, column(solid.axes, 0)), middle[1] + dot(corner, column(solid.axes, 1))});
      }
    }
  }
  const double room = solid.radius > 0 ? solid.radius : std::max(solid.half[0], solid.half[1]);
  const bool is_inside = std::ranges::all_of(outermost, [&](const std::array<double, 2>& at) {
    if (solid.radius > 0) return norm_of(at[0], at[1]) <= solid.radius + slack * room;
    return std::fabs(at[0]) <= solid.half[0] + slack * room && std::fabs(at[1]) <= solid.half[1] + slack * room;
  });
  const bool is_disc_in_disc =
      hole.radius > 0 && solid.radius > 0 && norm_of(middle[0], middle[1]) + hole.radius <= solid.radius + slack * room;
  if (!is_inside && !is_disc_in_disc) return std::nullopt;
  Prism out = hole;
  // The ends of the solid along the axis of the hole.
  const double start = -dot(apart, column(hole.axes, 2));
  const double low = start + (cosine > 0 ? solid.low : -solid.high);
  const double high = start + (cosine > 0 ? solid.high : -solid.low);
  out.low = std::max(hole.low, low);
  out.high = std::max(out.low, std::min(hole.high, high));
  return out;
}

MassProperties mass_of(const Prism& prism) {
  const double half_height = 0.5 * (prism.high - prism.low);
  const MassProperties own = prism.radius > 0 ? cylinder_mass(prism.radius, half_height)
                                              : box_mass({prism.half[0], prism.half[1], half_height});
  return {.mass = own.mass,
          .centre = pose_of(prism).position,
          .inertia = product(product(prism.axes, own.inertia), transposed(prism.axes))};
}

// By the largest of the four squares, which cancels nothing: Shepperd, "Quaternion from rotation matrix" (1978).
abut_pose pose_of(const Prism& prism) {
  const Matrix& m = prism.axes;
  const std::array<double, 4> squares{m[0] + m[4] + m[8], m[0] - m[4] - m[8], m[4] - m[0] - m[8], m[8] - m[0] - m[4]};
  const auto largest = std::ranges::max_element(squares) - squares.begin();
  const double whole = 1 + squares[static_cast<std::size_t>(largest)];
  const double wx = m[7] - m[5], wy = m[2] - m[6], wz = m[3] - m[1];
  const double xy = m[1] + m[3], xz = m[2] + m[6], yz = m[5] + m[7];
  const std::array<abut_quat, 4> turns{
      {{whole, wx, wy, wz}, {wx, whole, xy, xz}, {wy, xy, whole, yz}, {wz, xz, yz, whole}}};
  return {.position = add(prism.centre, scale(column(m, 2), 0.5 * (prism.low + prism.high))),
          .orientation = normalized(turns[static_cast<std::size_t>(largest)])};
}

}  // namespace abut::response
