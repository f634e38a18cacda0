// SPDX-License-Identifier: Apache-2.0
// Prescribed motion of a part: a constant velocity and spin, or keyframes.
#pragma once

#include <vector>

#include "node.hpp"

namespace cli {

struct Keyframe {
  double time;
  abut_pose pose;  // in the frame of where the part stands in the scene
};

struct Script {
  abut_vec3 velocity{};                // in the world, per second
  abut_vec3 spin_axis{0.0, 0.0, 1.0};  // in the world, through the origin of the part
  double degrees_per_second = 0.0;
  std::vector<Keyframe> keyframes;  // none: velocity and spin
  bool repeat = false;              // from the last keyframe on to the first
};

[[nodiscard]] Script read_script(const Node& node);

/// Where a part is at a time that is not negative; `start` is its pose in the scene.
[[nodiscard]] abut_pose pose_at(const Script& script, const abut_pose& start, double time);

}  // namespace cli
