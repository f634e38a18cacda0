// SPDX-License-Identifier: Apache-2.0
// Faces and edges of the convex hull of placed points, found by trying every triple.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "body.hpp"
#include "quad.hpp"

namespace oracle {

// Indices refer to `points`. The lists may hold more than the hull has (diagonals of faces, slivers): every entry
// lies inside the hull, so distances to it and axes built from it are valid, only not needed.
struct Features {
  std::vector<Vec> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 2>> edges;
  std::vector<Vec> normals;     // of the faces, unit, one of each pair of opposite signs is enough
  std::vector<Vec> directions;  // of the edges, unit, without repeats
  Vec centre;
  Quad size = 0;  // farthest point from the centre
};

// Local faces and edges. O(n^4) for n points: meant for a few dozen.
[[nodiscard]] Features features_of(const std::vector<Point>& points);

// The same features under a pose, relative to `origin`.
[[nodiscard]] Features placed(const Features& local, const Pose& pose, const Vec& origin);

}  // namespace oracle
