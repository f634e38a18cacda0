// SPDX-License-Identifier: Apache-2.0
// The command "explain".
#pragma once

#include "arguments.hpp"

namespace cli {

/// Prints what the last step did and why, and what keeps pairs apart that come near.
void explain(const Arguments& arguments);

}  // namespace cli
