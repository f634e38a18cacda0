// SPDX-License-Identifier: Apache-2.0
// Placed pairs of two kinds, as they are ordinary: sizes that differ by up to three times, any orientation.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/owners.hpp"

namespace cli {

using namespace tools;

struct SizedShape {
  ShapeOwner shape;
  double diameter = 0;
};

struct TunedPair {
  const abut_shape *a = nullptr, *b = nullptr;
  abut_pose pose_a{}, pose_b{};
  double size = 0;  // the sum of both diameters
};

/// A thousandth to a half of the size apart, and a hundredth to a tenth of it deep.
struct TunedPairs {
  std::vector<SizedShape> shapes_a, shapes_b;
  std::vector<TunedPair> apart, overlapping;
};

/// The kinds that are measured, as many as this build has.
[[nodiscard]] std::vector<std::string_view> tuned_kinds();

/// Whether the default error bound of distances is 1e-9 in place of 1e-12.
[[nodiscard]] bool is_curved(std::string_view kind);

/// The same for the same seed, on every machine.
[[nodiscard]] TunedPairs make_pairs(std::string_view kind_a, std::string_view kind_b, std::size_t count,
                                    std::uint64_t seed);

}  // namespace cli
