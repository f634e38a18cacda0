// SPDX-License-Identifier: Apache-2.0
// The prescribed motion: bodies lie on the terrain and slide down it with drag.
#pragma once

#include <vector>

#include "bodies.hpp"
#include "terrain.hpp"

namespace demo {

/// Seconds of one step.
inline constexpr double step_seconds = 0.25;

/// Where a body is on the map and where it goes.
struct Slider {
  std::size_t design;  // of the catalogue
  double radius;       // of the design, metres
  double x;
  double y;
  double velocity_x;
  double velocity_y;
  Vec3 heading;  // horizontal, unit
  double spin;   // tangent of half the angle by which the heading turns in a step
};

/// Lays `count` bodies on the slopes around the viewed hillside, at first without touching each other.
[[nodiscard]] std::vector<Slider> lay_out(const Catalogue& catalogue, const Terrain& terrain, std::size_t count,
                                          Random& random);

/// Moves a slider by one step.
void advance(Slider& slider, const Terrain& terrain);

/// Upright on the slope, sunk by a few hundredths of its radius so that it touches the ground.
[[nodiscard]] abut_pose pose_of(const Slider& slider, const Terrain& terrain);

}  // namespace demo
