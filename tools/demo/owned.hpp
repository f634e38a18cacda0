// SPDX-License-Identifier: Apache-2.0
// What the demo shares with other tools.
#pragma once

#include "common/owners.hpp"
#include "common/vector.hpp"

namespace demo {

using namespace tools;

}  // namespace demo
