// SPDX-License-Identifier: Apache-2.0
// The build that holds what a scene needs, and nothing else.
#pragma once

#include "arguments.hpp"

namespace cli {

/// Prints the line that configures it.
void print_lean_build(const Arguments& arguments);

}  // namespace cli
