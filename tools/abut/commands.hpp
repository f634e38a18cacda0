// SPDX-License-Identifier: Apache-2.0
// What the program can be asked to do.
#pragma once

#include "arguments.hpp"
#include "world.hpp"

namespace cli {

/// The world of a scene after the steps that the arguments ask for, or one.
[[nodiscard]] World world_at_last_step(const Arguments& arguments);

void run(const Arguments& arguments);
void list_shapes(const Arguments& arguments);

}  // namespace cli
