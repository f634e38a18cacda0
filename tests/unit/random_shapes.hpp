// SPDX-License-Identifier: Apache-2.0
// Seeded shapes whose parameters are lengths of about one unit.
#pragma once
#include <cstddef>
#include <vector>

#include "made.hpp"
#include "random_boxes.hpp"

namespace test {

// Parameters are `least` to 1; of those that have several, the last one is none in a share of the shapes.
template <class S>
S random_shape(Random& random, double least, double share_without_last = 0) {
  std::vector<double> parameters;
  for (std::size_t i = 0; i < S::parameter_names.size(); ++i) {
    parameters.push_back(random.uniform(least, 1));
  }
  if (share_without_last > 0 && parameters.size() > 1 && random.uniform(0, 1) < share_without_last) {
    parameters.back() = 0;
  }
  return made<S>(parameters);
}

}  // namespace test
