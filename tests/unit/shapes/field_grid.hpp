// SPDX-License-Identifier: Apache-2.0
// Grids of samples for distance fields, and solids in closed form to fill them with.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../made.hpp"

import abut.math;
import abut.shapes.distance_field;

namespace test {

// Solids in closed form: how far a point is from the surface, negative inside.
inline double from_ball(const abut::Vec3& p) { return std::hypot(p.x, p.y, p.z) - 0.8; }
inline double from_box(const abut::Vec3& p) {
  const abut::Vec3 out{std::fabs(p.x) - 0.7, std::fabs(p.y) - 0.5, std::fabs(p.z) - 0.6};
  return std::hypot(std::fmax(out.x, 0.0), std::fmax(out.y, 0.0), std::fmax(out.z, 0.0)) +
         std::fmin(std::fmax(out.x, std::fmax(out.y, out.z)), 0.0);
}
inline double from_torus(const abut::Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 0.7, p.z) - 0.3; }

// A grid around the origin.
struct Grid {
  std::array<double, 3> counts, spacing;

  [[nodiscard]] std::vector<double> parameters(bool is_inside_out = false, bool is_smooth = false) const {
    std::vector<double> all(counts.begin(), counts.end());
    all.insert(all.end(), spacing.begin(), spacing.end());
    for (std::size_t i = 0; i < 3; ++i) {
      all.push_back(-0.5 * (counts[i] - 1) * spacing[i]);
    }
    all.push_back(is_inside_out ? 1 : 0);
    all.push_back(is_smooth ? 1 : 0);
    return all;
  }
  template <class ValueOf>
  [[nodiscard]] std::vector<double> values(ValueOf&& value_of) const {
    const std::vector<double> all = parameters();
    std::vector<double> out;
    for (double k = 0; k < counts[2]; ++k) {
      for (double j = 0; j < counts[1]; ++j) {
        for (double i = 0; i < counts[0]; ++i) {
          out.push_back(
              value_of(abut::Vec3{all[6] + i * spacing[0], all[7] + j * spacing[1], all[8] + k * spacing[2]}));
        }
      }
    }
    return out;
  }
  template <class ValueOf>
  [[nodiscard]] abut::DistanceField field(ValueOf&& value_of, bool is_inside_out = false,
                                          bool is_smooth = false) const {
    return made<abut::DistanceField>(parameters(is_inside_out, is_smooth), values(value_of));
  }
  [[nodiscard]] double finest() const { return *std::ranges::min_element(spacing); }
  [[nodiscard]] double coarsest() const { return *std::ranges::max_element(spacing); }
};
inline const Grid even{{41, 43, 45}, {0.06, 0.06, 0.06}}, uneven{{51, 36, 66}, {0.05, 0.07, 0.04}},
    fine{{97, 97, 41}, {0.022, 0.022, 0.022}};

}  // namespace test
