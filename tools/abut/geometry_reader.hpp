// SPDX-License-Identifier: Apache-2.0
// Geometries: shapes on a part, with everything that decides whom they meet and how.
#pragma once

#include <vector>

#include "scene.hpp"

namespace cli {

/// The geometries of one part, which is filled in by the caller. A geometry without a name is called by its number.
[[nodiscard]] std::vector<Geometry> read_geometries(const Node& node, Scene& scene);

}  // namespace cli
