// SPDX-License-Identifier: Apache-2.0
// A row of the tables of the property tests in which the library falls short of a fact: in how many cases, and by how
// much.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace property {

struct Shortfall {
  std::string_view row;  // pair of kinds and scene, or extreme; then the fact
  std::uint64_t cases;
  double most;  // largest offence: how far off, as a part of the sizes of both shapes and the way between them
};

// A known offence may grow by this part: what the compiler rounds differently.
inline constexpr double headroom = 0.1;

// The list of this program. Each program of the property tests defines it.
[[nodiscard]] std::span<const Shortfall> known_shortfalls();

}  // namespace property
