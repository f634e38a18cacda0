// SPDX-License-Identifier: Apache-2.0
// Tessellated surfaces to slide over, as pieces that a library gets, and the cone of normals of the whole surface.
#pragma once

#include <abut/abut.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace property {

struct Piece {
  std::vector<abut_vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct Tessellation {
  std::string name;
  std::vector<Piece> pieces;  // each a mesh of its own
  double crack = 0;           // pieces and parts of pieces meet within this
  // The middle of where a body may be, seen from above, and how far from there; a ring where `inner` is not zero.
  double inner = 0, outer = 1.2;
};

// Flat, bent, waved and round surfaces, with cracks, T-junctions and seams.
[[nodiscard]] std::vector<Tessellation> tessellations();

// The triangles of a surface by place, for oracles that look near one point.
class Faces {
 public:
  explicit Faces(const Tessellation& surface);

  // The sine of the least angle between a normal and the cone that the normals of the faces within `reach` of a point
  // span; 2 where there are none.
  [[nodiscard]] double off_cone(const abut_vec3& point, const abut_vec3& normal, double reach) const;

 private:
  struct Face {
    std::array<std::array<double, 3>, 3> corners;
    std::array<double, 3> normal;
  };
  [[nodiscard]] std::vector<std::array<double, 3>> normals_near(const abut_vec3& point, double reach) const;
  std::vector<Face> faces_;
  std::vector<std::vector<std::uint32_t>> cells_;
  double low_x_ = 0, low_y_ = 0, cell_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
};

}  // namespace property
