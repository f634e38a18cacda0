// Where the library falls short in the extremes, as in shortfalls.hpp: row, fact, number of cases. It only shrinks.
//
// - "gap between the bounds" of coincident and concentric shapes: many directions are as good, as in
//   certificate_shortfalls.hpp.
// - size ratio 1e9: the depth of a speck in a giant and its bounds are off by up to 3e-10 of the giant.
// - needles that nearly touch: the distance is right to 1e-12, but the normal is 1e-4 off, and a plane across it does not
//   part them.
// - far from the origin: one touch that GJK leaves unproven. A core is then rounded off, and the points and the upper
//   bound are those of the rounded core.
// - flat hulls, slivers and repeated vertices: points up to 2e-8 outside of the shapes, and a bound wider than asked for.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "shortfall.hpp"

namespace property {

inline constexpr auto extreme_shortfalls = std::to_array<Shortfall>({
    {"1e9 m from the origin (curved) error within the limit of the row", 1},
    {"1e9 m from the origin (curved) point_a lies in a", 1},
    {"1e9 m from the origin (curved) point_b lies in b", 1},
    {"1e9 m from the origin (curved) points are as far apart as the distance", 1},
    {"1e9 m from the origin (curved) the oracle's distance <= upper", 1},
    {"coincident (curved) gap between the bounds", 13},
    {"concentric (curved) gap between the bounds", 11},
    {"faces parallel to 1e-12 rad (by support points) the oracle's distance <= upper", 2},
    {"faces parallel to 1e-9 rad (by support points) error within the limit of the row", 1},
    {"hulls of 10000 points error within the limit of the row", 1},
    {"hulls that are flat (curved) point_a lies in a", 1},
    {"hulls that are slivers (curved) gap between the bounds", 3},
    {"hulls that are slivers (curved) point_a lies in a", 3},
    {"needles of aspect 1e6 (curved) distance <= separation along the normal", 3},
    {"needles of aspect 1e6 (curved) error within the limit of the row", 2},
    {"needles of aspect 1e6 (curved) lower <= separation along the normal", 3},
    {"size ratio 1e9 (by support points) error within the limit of the row", 3},
    {"size ratio 1e9 (curved) -upper <= overlap along any direction", 2},
    {"size ratio 1e9 (curved) gap between the bounds", 2},
    {"size ratio 1e9 (curved) the oracle's distance <= upper", 2},
    {"size ratio 1e9 -upper <= overlap along any direction", 1},
    {"size ratio 1e9 depth <= overlap along any direction", 2},
    {"size ratio 1e9 error within the limit of the row", 2},
    {"size ratio 1e9 gap between the bounds", 1},
    {"size ratio 1e9 iterations within the limit", 1},
    {"size ratio 1e9 point_b lies in b", 1},
    {"size ratio 1e9 the oracle's distance <= upper", 1},
});

[[nodiscard]] constexpr std::uint64_t known_extreme_shortfall(std::string_view row) {
  for (const Shortfall& shortfall : extreme_shortfalls) {
    if (shortfall.row == row) return shortfall.cases;
  }
  return 0;
}

}  // namespace property
