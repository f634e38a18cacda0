// SPDX-License-Identifier: Apache-2.0
// The picking library, loaded by the first picture, so that all else runs without Embree.
#pragma once

#include "picture/picker.hpp"

namespace cli {

/// Throws BadInput when the library is not installed.
[[nodiscard]] tools::PickingFunctions load_picking();

}  // namespace cli
