// SPDX-License-Identifier: Apache-2.0
// The command "check".
#pragma once

#include "arguments.hpp"

namespace cli {

/// What is odd about a scene, or why two of its geometries touch or not. Answers whether anything is odd.
[[nodiscard]] bool check_scene(const Arguments& arguments);

}  // namespace cli
