// SPDX-License-Identifier: Apache-2.0
// Signed distance of two convex cores from their features.
#pragma once

#include <optional>

#include "features.hpp"
#include "quad.hpp"

namespace oracle {

struct CoreWitness {
  Vec a;
  Vec b;
};

struct CoreAnswer {
  Quad distance = 0;
  Vec normal;
  std::optional<CoreWitness> witness;
};

[[nodiscard]] CoreAnswer core_distance(const Features& a, const Features& b);

}  // namespace oracle
