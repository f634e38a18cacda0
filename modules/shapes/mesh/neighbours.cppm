// SPDX-License-Identifier: Apache-2.0
// Which triangles of a mesh lie beside each other: 26 bytes for a triangle of a mesh with half as many vertices.
export module abut.shapes.mesh.neighbours;
import abut.core.standard;
import abut.core;
export import abut.triangles.buffers;

export namespace abut {

class MeshNeighbours {
 public:
  MeshNeighbours(std::size_t vertex_count, std::span<const std::uint32_t> indices, const Workers& workers);

  // The triangles that have a vertex. Some of them may have been removed.
  [[nodiscard]] inline std::span<const std::uint32_t> around_vertex(std::uint32_t vertex) const
      [[clang::lifetimebound]] {
    return std::span(around_).subspan(first_around_[vertex], first_around_[vertex + 1] - first_around_[vertex]);
  }
  // Asks the memory for where the triangles around a vertex are listed, and for the list.
  inline void fetch_begin(std::uint32_t vertex) const { __builtin_prefetch(&first_around_[vertex]); }
  inline void fetch_list(std::uint32_t vertex) const {
    if (const std::uint32_t begin = first_around_[vertex]; begin < around_.size()) {
      __builtin_prefetch(&around_[begin]);
    }
  }
  // The same for what lies across the edges of a triangle.
  inline void fetch_across(std::uint32_t triangle) const { __builtin_prefetch(&across_[3 * std::size_t{triangle}]); }
  // The corner that the neighbour across an edge of a triangle has opposite to it. Edge i leads from corner i to the
  // next one. Across a border it is the corner of the triangle itself; where several neighbours share the edge,
  // no_index.
  [[nodiscard]] inline std::uint32_t across(std::uint32_t triangle, std::size_t edge) const {
    return across_[3 * std::size_t{triangle} + edge];
  }

  // A triangle is about to be removed; after that, the edges that it had are told to those that are left.
  void remove(std::uint32_t triangle, std::span<std::uint32_t> indices);

 private:
  [[nodiscard]] std::uint32_t across_of(std::span<const std::uint32_t> indices, std::uint32_t triangle,
                                        std::size_t edge) const;

  // Those of vertex v are around_[first_around_[v]] to around_[first_around_[v + 1] - 1].
  std::vector<std::uint32_t> first_around_, around_;
  std::vector<std::uint32_t> across_;
};

}  // namespace abut
