// SPDX-License-Identifier: Apache-2.0
// Triangles as callers hand them over: three numbers a vertex, three indices a triangle.
export module abut.triangles.buffers;
import abut.capability.checks;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Whether a triangle has gone: it names one vertex three times.
[[nodiscard]] inline bool is_removed(std::span<const std::uint32_t> triangles, std::uint32_t triangle) {
  const std::size_t first = 3 * std::size_t{triangle};
  return triangles[first] == triangles[first + 1] && triangles[first] == triangles[first + 2];
}

// Whether indices, of the corners of faces, are those of vertices.
[[nodiscard]] Fault check_indices(std::size_t vertex_count, std::span<const std::uint32_t> indices);
// What is wrong with triangles. `what`: a noun that says what they are for.
[[nodiscard]] Fault check_triangles(std::string_view what, std::span<const Real> xyz,
                                    std::span<const std::uint32_t> triangles);

}  // namespace abut
