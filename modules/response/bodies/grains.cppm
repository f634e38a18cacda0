// SPDX-License-Identifier: Apache-2.0
// Bodies that do not turn: the particles or the vertices of a geometry. And meshes that follow them.
module;

#include <abut/abut.h>

#include <cstddef>
#include <cstdint>
#include <vector>

export module abut.response:grains;
import :elastic;

export namespace abut::response {

// The world frame. Vectors are three numbers each, because callers borrow them.
struct Grains {
  abut_geometry_id geometry{};
  std::vector<double> masses;  // 0: held
  std::vector<double> xyz, velocities;
  std::vector<Spring> springs;  // between particles by their numbers, as tetrahedra
  std::vector<Tetrahedron> tetrahedra;
};

// A mesh whose vertices are means of particles of a carrier, by weights with the sum 1.
struct Surface {
  static constexpr std::size_t width = 4;  // particles of a vertex

  abut_geometry_id geometry{}, carrier{};
  std::vector<std::uint32_t> nodes;  // vertex after vertex
  std::vector<double> weights;
};

}  // namespace abut::response
