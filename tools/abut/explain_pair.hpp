// SPDX-License-Identifier: Apache-2.0
// How one pair of geometries of a scene is answered: every way to its distance, one by one.
#pragma once

#include "arguments.hpp"

namespace cli {

void explain_pair(const Arguments& arguments);

}  // namespace cli
