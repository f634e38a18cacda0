// SPDX-License-Identifier: Apache-2.0
module abut.triangles.buffers;
import abut.capability.checks;
import abut.core.standard;
import abut.core;
import abut.math;

namespace abut {

Fault check_indices(std::size_t vertex_count, std::span<const std::uint32_t> indices) {
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= vertex_count) {
      return error_about(Errc::index_out_of_range, "triangles[" + std::to_string(i) + "]", std::uint64_t{indices[i]},
                         "below vertex_count, which is " + std::to_string(vertex_count));
    }
  }
  return std::nullopt;
}

Fault check_triangles(std::string_view what, std::span<const Real> xyz, std::span<const std::uint32_t> triangles) {
  const std::string its(what);
  if (xyz.empty()) {
    return Error{Errc::empty, "vertex_count is 0; " + its + " needs vertices"};
  }
  if (triangles.empty()) {
    return Error{Errc::empty, "triangle_count is 0; " + its + " needs at least one triangle"};
  }
  if (xyz.size() % 3 != 0) {
    return error_about(Errc::invalid_argument, "real_count", std::uint64_t{xyz.size()}, "a multiple of 3");
  }
  if (triangles.size() % 3 != 0) {
    return error_about(Errc::invalid_argument, "index_count", std::uint64_t{triangles.size()}, "a multiple of 3");
  }
  constexpr std::size_t most_triangles = 0x3fffffff;  // three corners of each are numbered as well
  constexpr std::size_t most_vertices = std::numeric_limits<std::uint32_t>::max();
  if (xyz.size() / 3 > most_vertices || triangles.size() / 3 > most_triangles) {
    return Error{Errc::size_overflow, its + " has at most 2^32 - 1 vertices and 2^30 - 1 triangles"};
  }
  if (Fault fault = check_all_finite("xyz", xyz)) {
    return fault;
  }
  if (Fault fault = check_indices(xyz.size() / 3, triangles)) {
    return fault;
  }
  for (std::uint32_t triangle = 0; triangle < triangles.size() / 3; ++triangle) {
    if (!is_removed(triangles, triangle)) {
      return std::nullopt;
    }
  }
  return Error{Errc::empty, "triangles names one vertex three times in each; " + its + " needs at least one triangle"};
}

}  // namespace abut
