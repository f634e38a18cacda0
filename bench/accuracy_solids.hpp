// SPDX-License-Identifier: Apache-2.0
// Solids out of proportion, made of ordinary ones.
#pragma once
#include "scene.hpp"

namespace bench {

// Thin along two axes or along one; a sphere stays as it is, and a capsule can only be a needle. The points of a hull
// move; its surface is left to the caller.
[[nodiscard]] Solid made_thin(Solid solid, bool is_needle, double aspect);
[[nodiscard]] Solid scaled(Solid solid, double factor);

}  // namespace bench
