// SPDX-License-Identifier: Apache-2.0
// The command "pairs".
#pragma once

#include "arguments.hpp"

namespace cli {

/// Lists the pairs of a scene that come near, or which kinds of shapes meet.
void list_pairs(const Arguments& arguments);

}  // namespace cli
