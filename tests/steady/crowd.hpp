// SPDX-License-Identifier: Apache-2.0
// A block of bodies of all kinds, each in contact with its neighbours, over a ground and a terrain that stay.
#pragma once

#include "support.hpp"

#include <cstddef>
#include <vector>

namespace steady {

// One of each kind of solid or sheet that can move, about one unit large; composites with few children and with many.
std::vector<abut_test::Shape> make_moving_shapes();
// A cylinder without its middle: a composite with a hole.
abut_test::Shape make_tube();
// The same, and what takes longer: a distance field, a grid, a solid mesh and that tube.
std::vector<abut_test::Shape> make_shapes_of_all_kinds();

class Crowd {
 public:
  // Frames after which all bodies are back where they were.
  static constexpr std::size_t period = 16;

  // Bodies take the shapes at random, the same ones each time. `flags`: of every fourth body.
  Crowd(const abut_universe_options& options, const std::vector<abut_test::Shape>& shapes, std::size_t side,
        abut_geometry_flags flags = 0);

  // Every body but those of each third one goes on in its orbit.
  void move(std::size_t frame);
  void step();

  abut_universe* universe() const { return universe_; }
  abut_step_stats stats() const { return universe_.stats(); }
  const std::vector<abut_part_id>& parts() const { return parts_; }
  abut_vec3 middle() const;

 private:
  abut_pose pose_of(std::size_t body, std::size_t frame) const;

  std::size_t side_;
  abut_test::Universe universe_;
  std::vector<abut_part_id> parts_;
};

}  // namespace steady
