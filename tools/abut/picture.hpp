// SPDX-License-Identifier: Apache-2.0
// The command "picture".
#pragma once

#include "arguments.hpp"

namespace cli {

/// Draws the last step of a scene, with its contacts, as a PNG.
void draw_scene(const Arguments& arguments);

}  // namespace cli
