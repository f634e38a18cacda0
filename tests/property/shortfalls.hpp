// SPDX-License-Identifier: Apache-2.0
// Where the library falls short of a fact, row by row: pair of kinds, scene, fact; number of cases; largest offence.
// A ratchet: one more case, an offence that is larger by a tenth, or a row that is not here fails the test. Fewer
// cases, or an offence that is half as large, fail it too: lower the number. The program prints the right lines.
//
// - "lie across": nearly parallel edges share a stretch, which keeps bodies steady, although only the place where the
//   edges cross is exact; and normals that tie within rounding.
// - "as deep as each triangle": the way out of the deepest triangle leads into a neighbour. It is no way out of the
//   surface, so that other contacts count, which are less deep.
#pragma once

#include <array>

#include "shortfall.hpp"

namespace property {

inline constexpr auto contact_shortfalls = std::to_array<Shortfall>({
    {"box/box parallel touching contact points lie across each other", 3, 0.00016},
    {"box/capsule parallel overlapping contact points lie across each other", 3, 1.6e-07},
    {"box/capsule parallel touching contact points lie across each other", 4, 0.0003},
    {"capsule/capsule parallel overlapping contact points lie across each other", 2, 5.5e-10},
    {"capsule/capsule parallel touching contact points lie across each other", 10, 0.00013},
    {"hull/hull parallel touching contact points lie across each other", 1, 3.5e-10},
});

}  // namespace property
