// SPDX-License-Identifier: Apache-2.0
// Kinds of solids, and solids out of proportion.
#pragma once
#include "scene.hpp"

namespace bench {

[[nodiscard]] constexpr bool is_curved(Kind kind) {
  return kind == Kind::cylinder || kind == Kind::cone || kind == Kind::ellipsoid;
}

// Thin along two axes or along one; a sphere stays as it is, and a capsule can only be a needle. The points of a hull
// move; its surface is left to the caller.
[[nodiscard]] Solid made_thin(Solid solid, bool is_needle, double aspect);
[[nodiscard]] Solid scaled(Solid solid, double factor);

}  // namespace bench
