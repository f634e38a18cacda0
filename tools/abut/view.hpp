// SPDX-License-Identifier: Apache-2.0
// From where a picture looks at a scene.
#pragma once

#include "arguments.hpp"
#include "world.hpp"

namespace cli {

struct View {
  abut_vec3 eye;
  abut_vec3 target;
  abut_vec3 up;
  double radius;  // of what is looked at, from the target
};

inline constexpr double vertical_fov = 0.6;

/// What the arguments say; else everything of a finite size fits in. What stands still does not count where it is more
/// than eight times as large as all that moves. Throws BadInput when the arguments give no direction.
[[nodiscard]] View view_of(const World& world, const Arguments& arguments);

}  // namespace cli
