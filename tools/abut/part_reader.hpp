// SPDX-License-Identifier: Apache-2.0
// Parts, their geometries, and how they move.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "scene.hpp"

namespace cli {

/// Where the parts of a name are in the list of parts: one, or all copies.
using PartRanges = std::map<std::string, std::pair<std::size_t, std::size_t>>;

/// Adds the parts and geometries of a list to the scene.
[[nodiscard]] PartRanges read_parts(const Node& node, Scene& scene);

}  // namespace cli
