// SPDX-License-Identifier: Apache-2.0
// Floors of triangles that are flat up to noise, as shapes of the library, and where their normals may point.
#pragma once

#include <abut/abut.h>

#include <array>
#include <cstdint>
#include <vector>

#include "subject.hpp"

namespace property {

struct TriangleSoup {
  std::vector<abut_vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// A square grid, centred on the origin, whose heights are noise of an amplitude; two triangles a cell.
struct Floor {
  std::uint32_t cells = 8;
  double spacing = 0.5;
  double noise = 0;
  bool as_float = false;  // coordinates rounded to float, after a turn by an angle that no float holds
};

// Heights differ from run to run of `seed` only. Corner (0, 0) of a height field is its origin: `pose` puts its middle
// where the middle of the mesh lies.
[[nodiscard]] TriangleSoup soup_of(const Floor& floor, std::uint64_t seed);
[[nodiscard]] std::vector<double> heights_of(const Floor& floor, std::uint64_t seed);
[[nodiscard]] ShapePtr mesh_of(const TriangleSoup& soup, abut_sides sides);

// How far the surface around one of its points rises over the plane through that point across a unit normal: the
// largest sine of the angle to a corner of a triangle that holds the point. The normal lies in the cone of normals of
// the surface there where nothing rises.
[[nodiscard]] double rise_around(const TriangleSoup& soup, const abut_vec3& point, const abut_vec3& normal);

}  // namespace property
