// SPDX-License-Identifier: Apache-2.0
// Pairs on which other libraries failed, read from tests/data/known_failures.jsonl.
#pragma once
#include <string>
#include <vector>

#include "pairs.hpp"

namespace bench {

struct KnownCase {
  std::string id;
  Solid a, b;
  Case placed;
  double reference = 0;  // signed distance, from arithmetic with 113 bits
};

// Those of two convex solids; rows about rays, meshes, hulls and motion have no signed distance of a pair.
[[nodiscard]] std::vector<KnownCase> read_known_cases(const std::string& path);

}  // namespace bench
