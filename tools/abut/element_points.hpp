// SPDX-License-Identifier: Apache-2.0
// Where element contacts are in the world.
#pragma once

#include <vector>

#include "abut/abut.h"
#include "world.hpp"

namespace cli {

struct ElementPoint {
  abut_vec3 middle;  // between both features, in the world
  abut_geometry_id geometry_a;
  abut_geometry_id geometry_b;
};

/// Of the element contacts of the last step, in their order. Features of first touches are taken where they are now.
[[nodiscard]] std::vector<ElementPoint> element_points_of(const World& world);

}  // namespace cli
