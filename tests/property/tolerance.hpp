// SPDX-License-Identifier: Apache-2.0
// What a result may be off by. The one place that says so for the property tests.
#pragma once

#include <limits>

namespace property {

// The magnitudes that rounding grows with, all in the same unit of length.
struct Magnitude {
  double size_a = 0;
  double size_b = 0;
  double apart = 0;  // between the two positions
  double far = 0;    // of the positions from the origin of the world
};

// Of quantities that depend on the relative pose only: rounding of coordinates of the two shapes.
[[nodiscard]] inline double rounding(const Magnitude& m) {
  return 64 * std::numeric_limits<double>::epsilon() * (m.size_a + m.size_b + m.apart);
}

// Of points in the world frame: the same, and rounding of world coordinates.
[[nodiscard]] inline double point_rounding(const Magnitude& m) {
  return rounding(m) + 8 * std::numeric_limits<double>::epsilon() * m.far;
}

// Default error bounds of a query, relative to the diameters of the shapes; the second where a cylinder, a cone or an
// ellipsoid takes part.
inline constexpr double error_bound = 1e-12;
inline constexpr double curved_error_bound = 1e-9;

// Of a signed distance: rounding, and the error bound.
[[nodiscard]] inline double distance_tolerance(const Magnitude& m, double bound = error_bound) {
  return rounding(m) + 2 * bound * (m.size_a + m.size_b);
}

// The length of a unit normal may be off 1 by this.
inline constexpr double unit_tolerance = 16 * std::numeric_limits<double>::epsilon();

}  // namespace property
