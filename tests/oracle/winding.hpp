// SPDX-License-Identifier: Apache-2.0
// The winding number of a surface of triangles around a point: the sum of all solid angles, in 113 bits but for the
// arc tangent, which has 64.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "overlap.hpp"
#include "quad.hpp"

namespace oracle {

[[nodiscard]] inline long double solid_angle(const Vec& a, const Vec& b, const Vec& c) {
  const Quad of_a = length(a), of_b = length(b), of_c = length(c);
  const Quad sine = dot(a, cross(b, c));
  const Quad cosine = of_a * of_b * of_c + dot(a, b) * of_c + dot(b, c) * of_a + dot(c, a) * of_b;
  // The quotient is the same for both, and neither of them then leaves the range of a long double.
  const Quad largest = larger(absolute(sine), absolute(cosine));
  return sine == 0
             ? 0
             : 2 * std::atan2(static_cast<long double>(sine / largest), static_cast<long double>(cosine / largest));
}

[[nodiscard]] inline long double winding_number(std::span<const double> xyz, std::span<const std::uint32_t> triangles,
                                                const Vec& point) {
  const auto seen = [&](std::uint32_t vertex) {
    return Vec{quad(xyz[3 * std::size_t{vertex}]), quad(xyz[3 * std::size_t{vertex} + 1]),
               quad(xyz[3 * std::size_t{vertex} + 2])} -
           point;
  };
  long double sum = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    sum += solid_angle(seen(triangles[i]), seen(triangles[i + 1]), seen(triangles[i + 2]));
  }
  return sum / (4 * std::numbers::pi_v<long double>);
}

// The same in double, for searches. Points of the surface have any number.
[[nodiscard]] inline double rough_winding_number(std::span<const double> xyz, std::span<const std::uint32_t> triangles,
                                                 const Point& point) {
  const auto seen = [&](std::uint32_t vertex) {
    const std::size_t at = 3 * std::size_t{vertex};
    return Point{xyz[at] - point[0], xyz[at + 1] - point[1], xyz[at + 2] - point[2]};
  };
  double sum_of_angles = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Point a = seen(triangles[i]), b = seen(triangles[i + 1]), c = seen(triangles[i + 2]);
    const double of_a = std::sqrt(inner(a, a)), of_b = std::sqrt(inner(b, b)), of_c = std::sqrt(inner(c, c));
    const double cosine = of_a * of_b * of_c + inner(a, b) * of_c + inner(b, c) * of_a + inner(c, a) * of_b;
    sum_of_angles += 2 * std::atan2(inner(a, vector_product(b, c)), cosine);
  }
  return sum_of_angles / (4 * std::numbers::pi);
}

}  // namespace oracle
