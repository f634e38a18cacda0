// SPDX-License-Identifier: Apache-2.0
// Meshes whose vertices move from step to step: a sheet in folds, and two sheets in waves, one above the other.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene.hpp"

namespace bench {

// The vertices move on straight lines from start to end.
struct Deforming {
  std::vector<Point> start, end;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;  // the lower end first, in the order of their ends
};

// A step of one mesh with itself, or of two meshes.
struct DeformingCase {
  Deforming a, b;  // b has no vertices where a is asked with itself
  double reach = 0;

  [[nodiscard]] bool is_of_one() const { return b.start.empty(); }
};

// Each case is the next step of the one before.
struct DeformingScene {
  std::string name;
  std::vector<DeformingCase> cases;
};

// Layers of a sheet of 1,152 triangles, some hundredths apart, that sway into each other.
[[nodiscard]] DeformingScene sheet_in_folds(std::size_t steps);
// Two sheets of as many triangles; the upper one goes down until crests of both cross.
[[nodiscard]] DeformingScene two_sheets(std::size_t steps);

}  // namespace bench
