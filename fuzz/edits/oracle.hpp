// SPDX-License-Identifier: Apache-2.0
// Distances and crossings of rays by a loop over all triangles or balls, apart from the library.
#pragma once

#include <optional>

#include "subject.hpp"

namespace edit_fuzzing {

// Of a point from the nearest.
[[nodiscard]] double distance_from(const Point& point, const std::vector<Triangle>& triangles);
[[nodiscard]] double distance_from(const Point& point, const std::vector<Ball>& balls);

// Where a ray first crosses, in multiples of the direction. Nothing where it passes an edge so closely that either
// answer is right.
struct Crossing {
  bool is_sure = true;
  std::optional<double> at;
};
[[nodiscard]] Crossing first_crossing(const Point& origin, const Point& direction,
                                      const std::vector<Triangle>& triangles);

}  // namespace edit_fuzzing
