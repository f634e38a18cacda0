// SPDX-License-Identifier: Apache-2.0
// Geometries of a world as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "world.hpp"

namespace cli {

struct Placed {
  std::size_t index;  // in the scene
  std::string name;   // PART/GEOMETRY
  const abut_shape* shape;
  abut_pose pose;  // in the world
};

/// A geometry by its number in the scene, where it is now.
[[nodiscard]] Placed placed(const World& world, std::size_t index);

/// The geometries that a name means: of a PART all, of PART/GEOMETRY one. Throws BadInput when there is none.
[[nodiscard]] std::vector<Placed> find_placed(const World& world, const std::string& name);

/// Such as "sphere".
[[nodiscard]] std::string kind_name(const abut_shape* shape);

/// With its kind, for people.
[[nodiscard]] std::string shown(const Placed& its);

}  // namespace cli
