// SPDX-License-Identifier: Apache-2.0
// Where the library falls short in the extremes, as in shortfalls.hpp: row, fact, number of cases. It only shrinks.
//
// - of parallel faces by support points, and hulls of 10000 points: off by rounding more than the row allows.
#pragma once

#include <array>

#include "shortfall.hpp"

namespace property {

inline constexpr auto extreme_shortfalls = std::to_array<Shortfall>({
    {"faces parallel to 1e-9 rad (by support points) error within the limit of the row", 1, 1.5e-14},
    {"hulls of 10000 points error within the limit of the row", 1, 3.1e-16},
});

}  // namespace property
