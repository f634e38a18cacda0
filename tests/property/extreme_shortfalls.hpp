// SPDX-License-Identifier: Apache-2.0
// Where the library falls short in the extremes, as in shortfalls.hpp: row, fact, number of cases. It only shrinks.
//
// - "gap between the bounds" of concentric shapes: many directions are as good, as in certificate_shortfalls.hpp.
// - size ratio 1e9: one bound of the distance of a speck and a giant is off by 6e-13 of the giant.
// - of parallel faces by support points, and hulls of 10000 points: off by rounding more than the row allows.
#pragma once

#include <array>

#include "shortfall.hpp"

namespace property {

inline constexpr auto extreme_shortfalls = std::to_array<Shortfall>({
    {"faces parallel to 1e-12 rad (by support points) the oracle's distance <= upper", 2, 6.5e-14},
    {"faces parallel to 1e-9 rad (by support points) error within the limit of the row", 1, 1.5e-14},
    {"hulls of 10000 points error within the limit of the row", 1, 3.1e-16},
    {"size ratio 1e9 (curved) -upper <= overlap along any direction", 1, 5.8e-13},
    {"size ratio 1e9 (curved) the oracle's distance <= upper", 1, 5.8e-13},
});

}  // namespace property
