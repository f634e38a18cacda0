// SPDX-License-Identifier: Apache-2.0
// Pairs of geometries that come near each other, whether they meet or not.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gates.hpp"

namespace cli {

/// Two geometries by their numbers in the scene, the lesser first.
using NumberPair = std::pair<std::size_t, std::size_t>;

/// Pairs whose boxes overlap or that have contacts, in ascending order; parked geometries count as well. Boxes are as
/// large as tolerances make them. O(n log n + pairs whose boxes overlap along X).
[[nodiscard]] std::vector<NumberPair> near_pairs(const World& world);

/// How many near pairs a gate keeps apart, and the first of them.
struct KeptApart {
  std::string_view gate;
  std::size_t pairs = 0;
  NumberPair example;
};

/// For each gate that keeps pairs apart, in the order in which they are asked.
[[nodiscard]] std::vector<KeptApart> kept_apart(const World& world);

}  // namespace cli
