// SPDX-License-Identifier: Apache-2.0
// The command "distance".
#pragma once

#include "arguments.hpp"

namespace cli {

/// Prints the distance of two geometries of a scene, or of two shapes that the command line writes out.
void print_distance(const Arguments& arguments);

}  // namespace cli
