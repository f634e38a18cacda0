// SPDX-License-Identifier: Apache-2.0
// A hull around points that are known to be good.
#pragma once
#include <vector>

#include "made.hpp"

import abut.math;
import abut.shapes.hull;

namespace test {

inline abut::Hull hull_of(const std::vector<abut::Vec3>& points) {
  std::vector<double> numbers;
  for (const abut::Vec3& p : points) {
    numbers.insert(numbers.end(), {p.x, p.y, p.z});
  }
  return made<abut::Hull>({}, numbers);
}

}  // namespace test
