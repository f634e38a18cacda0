// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

constexpr double pi = std::numbers::pi;

[[nodiscard]] MassProperties about_z(double mass, double across, double along) {
  return {.mass = mass, .centre = {}, .inertia = {across, 0, 0, 0, across, 0, 0, 0, along}};
}

// The inertia of a point mass about the origin.
[[nodiscard]] Matrix point_inertia(double mass, const abut_vec3& at) {
  const double square = dot(at, at);
  return {mass * (square - at.x * at.x), -mass * at.x * at.y,           -mass * at.x * at.z,
          -mass * at.y * at.x,           mass * (square - at.y * at.y), -mass * at.y * at.z,
          -mass * at.z * at.x,           -mass * at.z * at.y,           mass * (square - at.z * at.z)};
}

// Whether each directed edge has one partner in the other direction.
[[nodiscard]] bool is_closed(std::span<const std::uint32_t> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges, partners;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint32_t from = triangles[i + j], to = triangles[i + (j + 1) % 3];
      edges.emplace_back(from, to);
      partners.emplace_back(to, from);
    }
  }
  std::ranges::sort(edges);
  std::ranges::sort(partners);
  return edges == partners && std::ranges::adjacent_find(edges) == edges.end();
}

}  // namespace

MassProperties ellipsoid_mass(const abut_vec3& radii) {
  const double mass = 4 * pi / 3 * radii.x * radii.y * radii.z, part = mass / 5;
  const double x = radii.x * radii.x, y = radii.y * radii.y, z = radii.z * radii.z;
  return {.mass = mass, .centre = {}, .inertia = {part * (y + z), 0, 0, 0, part * (x + z), 0, 0, 0, part * (x + y)}};
}

MassProperties box_mass(const abut_vec3& half_extents) {
  const double mass = 8 * half_extents.x * half_extents.y * half_extents.z, part = mass / 3;
  const double x = half_extents.x * half_extents.x, y = half_extents.y * half_extents.y;
  const double z = half_extents.z * half_extents.z;
  return {.mass = mass, .centre = {}, .inertia = {part * (y + z), 0, 0, 0, part * (x + z), 0, 0, 0, part * (x + y)}};
}

MassProperties cylinder_mass(double radius, double half_height) {
  const double mass = 2 * pi * radius * radius * half_height, square = radius * radius;
  return about_z(mass, mass * (square / 4 + half_height * half_height / 3), mass * square / 2);
}

// A cylinder, and a half ball on either end, whose centre of mass lies 3/8 of the radius beyond.
MassProperties capsule_mass(double radius, double half_height) {
  const MassProperties middle = cylinder_mass(radius, half_height), ball = ellipsoid_mass({radius, radius, radius});
  const double beyond = half_height * half_height + 0.75 * half_height * radius;
  return about_z(middle.mass + ball.mass, middle.inertia[0] + ball.inertia[0] + ball.mass * beyond,
                 middle.inertia[8] + ball.inertia[8]);
}

MassProperties cone_mass(double radius, double half_height) {
  const double height = 2 * half_height, mass = pi / 3 * radius * radius * height, square = radius * radius;
  MassProperties out = about_z(mass, mass * (3 * square / 20 + 3 * height * height / 80), mass * 3 * square / 10);
  out.centre.z = -half_height / 2;
  return out;
}

// Signed tetrahedra from a corner of the surface: Tonon, "Explicit exact formulas for the 3-D tetrahedron inertia
// tensor" (2004), https://doi.org/10.3844/jmssp.2005.8.11.
std::optional<MassProperties> enclosed_mass(std::span<const double> xyz, std::span<const std::uint32_t> triangles) {
  if (triangles.empty() || !is_closed(triangles)) return std::nullopt;
  const auto vertex = [&](std::uint32_t i) { return abut_vec3{xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]}; };
  const abut_vec3 origin = vertex(triangles[0]);
  double volume = 0;
  abut_vec3 first{};
  Matrix second{};  // sums of products of coordinates
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::array corners{subtract(vertex(triangles[i]), origin), subtract(vertex(triangles[i + 1]), origin),
                             subtract(vertex(triangles[i + 2]), origin)};
    const double part = dot(corners[0], cross(corners[1], corners[2])) / 6;
    const abut_vec3 sum = add(add(corners[0], corners[1]), corners[2]);
    volume += part;
    first = add(first, scale(sum, part / 4));
    const std::array s{sum.x, sum.y, sum.z};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        double products = s[row] * s[column];
        for (const abut_vec3& corner : corners) {
          const std::array c{corner.x, corner.y, corner.z};
          products += c[row] * c[column];
        }
        second[3 * row + column] += part / 20 * products;
      }
    }
  }
  if (!(volume > 0)) return std::nullopt;
  const abut_vec3 middle = scale(first, 1 / volume);
  const Matrix away = point_inertia(volume, middle);
  const double trace = second[0] + second[4] + second[8];
  MassProperties out{.mass = volume, .centre = add(origin, middle), .inertia = {}};
  for (std::size_t i = 0; i < 9; ++i) out.inertia[i] = (i % 4 == 0 ? trace : 0) - second[i] - away[i];
  return out;
}

MassProperties scaled(const MassProperties& mass, double density) {
  MassProperties out = mass;
  out.mass *= density;
  for (double& number : out.inertia) number *= density;
  return out;
}

MassProperties placed(const MassProperties& mass, const abut_pose& pose) {
  const Matrix turn = matrix_of(pose.orientation);
  return {.mass = mass.mass,
          .centre = add(pose.position, times(turn, mass.centre)),
          .inertia = product(product(turn, mass.inertia), transposed(turn))};
}

MassProperties combined(std::span<const MassProperties> masses) {
  MassProperties out;
  for (const MassProperties& part : masses) {
    out.mass += part.mass;
    out.centre = add(out.centre, scale(part.centre, part.mass));
  }
  out.centre = scale(out.centre, 1 / out.mass);
  for (const MassProperties& part : masses) {
    const Matrix away = point_inertia(part.mass, subtract(part.centre, out.centre));
    for (std::size_t i = 0; i < out.inertia.size(); ++i) out.inertia[i] += part.inertia[i] + away[i];
  }
  return out;
}

}  // namespace abut::response
