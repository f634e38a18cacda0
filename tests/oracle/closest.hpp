// SPDX-License-Identifier: Apache-2.0
// Closest points of two segments, and of a point and the inside of a triangle.
#pragma once

#include <optional>

#include "quad.hpp"

namespace oracle {

struct ClosestPair {
  Vec a;
  Vec b;
  Quad squared = 0;
};

[[nodiscard]] ClosestPair pair_of(const Vec& a, const Vec& b);

// Ends may coincide. Nearly parallel segments lose at most half of the digits of the place, none of the distance.
[[nodiscard]] ClosestPair closest_of_segments(const Vec& a0, const Vec& a1, const Vec& b0, const Vec& b1);

// The foot of the perpendicular from `point`, when it falls inside the triangle or on its rim.
[[nodiscard]] std::optional<Vec> foot_in_triangle(const Vec& point, const Vec& a, const Vec& b, const Vec& c);

}  // namespace oracle
