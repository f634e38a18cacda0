// SPDX-License-Identifier: Apache-2.0
// Bodies that do not turn: the particles of a geometry.
module;

#include <abut/abut.h>

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

}  // namespace abut::response
