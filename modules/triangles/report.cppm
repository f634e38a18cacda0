// SPDX-License-Identifier: Apache-2.0
// What is unusual about triangles as a surface, in numbers.
export module abut.triangles.report;
import abut.core.standard;
import abut.math;

export namespace abut {

struct TriangleReport {
  std::uint64_t triangles = 0;            // that have not gone
  std::uint64_t vertices = 0;             // of these
  std::uint64_t duplicate_vertices = 0;   // in the place of one with a lower number
  std::uint64_t duplicate_triangles = 0;  // with the vertices of one with a lower number
  std::uint64_t slivers = 0;              // whose least height is below a thousandth of the longest side
  std::uint64_t open_edges = 0;           // of one triangle
  std::uint64_t non_manifold_edges = 0;   // of more than two
  std::uint64_t reversed_triangles = 0;   // the least number to be turned so that neighbours agree
  std::uint64_t twisted_patches = 0;      // that no turning makes agree, as a Moebius strip
  std::uint64_t components = 0;           // that share no vertex with each other
  Real volume = 0;                        // that they enclose
};

// Of triangles without faults. A patch is what edges of two triangles connect.
[[nodiscard]] TriangleReport report_triangles(std::span<const Real> xyz, std::span<const std::uint32_t> triangles);

}  // namespace abut
