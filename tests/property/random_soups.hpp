// SPDX-License-Identifier: Apache-2.0
// Seeded triangles about 2 wide, times a scale.
#pragma once

#include "oracle/body.hpp"
#include "scenes.hpp"

namespace property {

// In a grid, around a closed body or anywhere. What is dirty has triangles that are turned, missing, there twice, or
// slivers beside an edge. Half of all have corners in float.
[[nodiscard]] oracle::Soup random_soup(Random& random, double scale);
// Around a closed body, each wound once.
[[nodiscard]] oracle::Soup closed_soup(Random& random, double scale);

[[nodiscard]] bool happens(Random& random, double probability);
// How far corners are off: often not at all.
[[nodiscard]] double roughness(Random& random);

}  // namespace property
