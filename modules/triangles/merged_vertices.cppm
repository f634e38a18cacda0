// SPDX-License-Identifier: Apache-2.0
// Triangles whose vertices are near each other made to share them.
//
// Merged vertices and collapsed triangles keep their numbers. So a caller whose vertices are repeated, as for drawing,
// moves them by its own numbers; vertices that gave way belong to no triangle.
export module abut.triangles.merged_vertices;
import abut.core.standard;
import abut.math;

export namespace abut {

struct MergedVertices {
  // Those of before, numbered as before. One with two corners in one vertex then has gone: it names one vertex three
  // times.
  std::vector<std::uint32_t> triangles;
  std::uint64_t vertices;   // that gave way to another one
  std::uint64_t collapsed;  // triangles that had three corners, or two
  Real error;               // how far a corner has moved at most
};

// In the order of their numbers, vertices of triangles stay where none that stayed is within `distance`. The others
// give way to the nearest one that stayed, of several to the one with the lowest number.
[[nodiscard]] MergedVertices merge_vertices(std::span<const Real> xyz, std::span<const std::uint32_t> triangles,
                                            Real distance);

}  // namespace abut
