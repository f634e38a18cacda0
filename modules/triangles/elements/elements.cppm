// SPDX-License-Identifier: Apache-2.0
// Vertices, edges and faces of triangles as elements: each edge has one number, and each vertex and edge belongs to one
// triangle, so that a search over triangles reports each element once.
export module abut.triangles.elements;
import abut.core.standard;

export namespace abut {

// The ends of an edge, the lower number first.
using EdgeEnds = std::array<std::uint32_t, 2>;

// Triangles with two equal corners are edges without a face, those with three equal corners are removed.
class ElementTable {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  ElementTable() = default;
  // Three corners per triangle, each below vertex_count.
  ElementTable(std::size_t vertex_count, std::span<const std::uint32_t> triangles);

  [[nodiscard]] std::size_t triangle_count() const { return edges_of_.size(); }
  // In the order of their ends.
  [[nodiscard]] std::span<const EdgeEnds> edges() const [[clang::lifetimebound]] { return edges_; }
  // Edge i of a triangle is from corner i to the next one; none where these are equal.
  [[nodiscard]] const std::array<std::uint32_t, 3>& edges_of(std::uint32_t triangle) const [[clang::lifetimebound]] {
    return edges_of_[triangle];
  }
  // The number of the edge between two vertices, or none.
  [[nodiscard]] std::uint32_t edge_between(std::uint32_t a, std::uint32_t b) const;

  // The edges of a vertex, in order.
  [[nodiscard]] std::span<const std::uint32_t> edges_around(std::uint32_t vertex) const [[clang::lifetimebound]] {
    return part(edges_around_, first_around_vertex_, vertex);
  }
  // The corner across from an edge, for each face of the edge.
  [[nodiscard]] std::span<const std::uint32_t> corners_across(std::uint32_t edge) const [[clang::lifetimebound]] {
    return part(corners_across_, first_across_edge_, edge);
  }

  // The lowest triangle of each vertex and edge is its owner.
  [[nodiscard]] bool owns_corner(std::uint32_t triangle, std::size_t corner) const {
    return (flags_[triangle] >> corner & 1u) != 0;
  }
  [[nodiscard]] bool owns_edge(std::uint32_t triangle, std::size_t edge) const {
    return (flags_[triangle] >> (edge + 3) & 1u) != 0;
  }
  // The edge is part of one face, or of none.
  [[nodiscard]] bool is_border(std::uint32_t triangle, std::size_t edge) const {
    return (flags_[triangle] >> (edge + 6) & 1u) != 0;
  }
  [[nodiscard]] bool is_face(std::uint32_t triangle) const { return (flags_[triangle] >> 9 & 1u) != 0; }
  [[nodiscard]] std::size_t face_count() const { return face_count_; }

  [[nodiscard]] std::size_t bytes() const {
    return edges_.capacity() * sizeof(EdgeEnds) + edges_of_.capacity() * sizeof(std::array<std::uint32_t, 3>) +
           flags_.capacity() * sizeof(std::uint16_t) +
           (edges_around_.capacity() + first_around_vertex_.capacity() + corners_across_.capacity() +
            first_across_edge_.capacity()) *
               sizeof(std::uint32_t);
  }

 private:
  [[nodiscard]] static std::span<const std::uint32_t> part(std::span<const std::uint32_t> all,
                                                           std::span<const std::uint32_t> firsts, std::uint32_t which) {
    return all.subspan(firsts[which], firsts[std::size_t{which} + 1] - firsts[which]);
  }
  void list_edges_around(std::size_t vertex_count);
  void number_edges(std::span<const std::uint32_t> triangles);

  std::vector<EdgeEnds> edges_;
  std::vector<std::array<std::uint32_t, 3>> edges_of_;  // of triangles
  std::vector<std::uint16_t> flags_;                    // of triangles: own corners, own edges, borders, whether a face
  std::size_t face_count_ = 0;
  // Lists one after the other, and where each begins.
  std::vector<std::uint32_t> edges_around_, first_around_vertex_{0};
  std::vector<std::uint32_t> corners_across_, first_across_edge_{0};
};

}  // namespace abut
