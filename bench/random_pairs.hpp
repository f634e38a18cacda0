// SPDX-License-Identifier: Apache-2.0
// Random solids of a kind, and random places of two of them, some apart and some overlapping.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "pairs.hpp"

namespace bench {

// Hulls with their surfaces.
[[nodiscard]] std::vector<Solid> random_solids(Kind kind, std::size_t count, Random& random);

[[nodiscard]] Case random_case(std::span<const Solid> solids_a, std::span<const Solid> solids_b, Random& random);

// Lets b move toward a point, such as a, and past it by up to 0.7 of the reach. So most pairs meet.
void give_motion(Case& one, const Point& aim, double reach, Random& random);
void give_motion(Case& one, double reach, Random& random);

}  // namespace bench
