// SPDX-License-Identifier: Apache-2.0
// A mesh that deforms, as the searches of this folder see it: its elements, the tree around them, the shape at rest,
// and where the vertices are at two times.
export module abut.proximity.body;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.triangles.elements;
import abut.trees.elements.element_tree;

export namespace abut {

// Faces around vertices or edges: lists one after the other.
class FacesAround {
 public:
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t element) const [[clang::lifetimebound]] {
    return std::span(faces_).subspan(firsts_[element], firsts_[std::size_t{element} + 1] - firsts_[element]);
  }
  // visit(add) calls add(element, face) for all, and is called twice.
  template <class Visit>
  void make(std::size_t element_count, const Visit& visit) {
    firsts_.assign(element_count + 1, 0);
    visit([&](std::uint32_t element, std::uint32_t) { ++firsts_[element]; });
    std::uint32_t sum = 0;
    for (std::uint32_t& first : firsts_) {
      first = sum += first;
    }
    faces_.resize(sum);
    visit([&](std::uint32_t element, std::uint32_t face) { faces_[--firsts_[element]] = face; });
  }

  [[nodiscard]] std::size_t bytes() const { return (faces_.capacity() + firsts_.capacity()) * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> faces_, firsts_{0};
};

class ElementBody {
 public:
  // Three corners per triangle, each below the number of vertices. The vertices rest where they are given.
  ElementBody(std::vector<Vec3> rest, std::vector<std::uint32_t> triangles, const Workers& workers);

  [[nodiscard]] const ElementTable& table() const [[clang::lifetimebound]] { return table_; }
  [[nodiscard]] const ElementTree& tree() const [[clang::lifetimebound]] { return tree_; }
  [[nodiscard]] std::span<const std::uint32_t> triangles() const [[clang::lifetimebound]] { return triangles_; }
  [[nodiscard]] std::span<const Vec3> rest() const [[clang::lifetimebound]] { return rest_; }
  [[nodiscard]] std::span<const Vec3> start() const [[clang::lifetimebound]] { return start_; }
  [[nodiscard]] std::span<const Vec3> end() const [[clang::lifetimebound]] { return end_.empty() ? start_ : end_; }
  [[nodiscard]] std::span<const std::uint32_t, 3> corners_of(std::uint32_t face) const [[clang::lifetimebound]] {
    return std::span(triangles_).subspan(3 * std::size_t{face}).first<3>();
  }
  [[nodiscard]] const EdgeEnds& ends_of(std::uint32_t edge) const [[clang::lifetimebound]] {
    return table_.edges()[edge];
  }
  [[nodiscard]] const FacesAround& faces_around_vertices() const [[clang::lifetimebound]] { return around_vertices_; }
  [[nodiscard]] const FacesAround& faces_around_edges() const [[clang::lifetimebound]] { return around_edges_; }
  // Around all vertices at both times.
  [[nodiscard]] const Aabb& box() const [[clang::lifetimebound]] { return box_; }

  // Places, or three numbers per vertex. Without an end they do not move.
  void move(std::span<const Real> start, std::span<const Real> end);
  void move(std::span<const Vec3> start, std::span<const Vec3> end);
  // Fits the tree, unless it fits already.
  void fit(const Vec3& origin, Real reach, const Workers& workers);
  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Aabb box_of_vertices() const;

  std::vector<Vec3> rest_, start_, end_;  // no end where nothing moves
  std::vector<std::uint32_t> triangles_;
  ElementTable table_;
  ElementTree tree_;
  FacesAround around_vertices_, around_edges_;
  Aabb box_;
  Real fitted_reach_ = -1;  // below zero where the tree does not fit
};

[[nodiscard]] inline std::array<Vec3, 3> corners_at(std::span<const Vec3> vertices,
                                                    std::span<const std::uint32_t, 3> corners) {
  return {vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]};
}
[[nodiscard]] inline std::array<Vec3, 2> ends_at(std::span<const Vec3> vertices, const EdgeEnds& ends) {
  return {vertices[ends[0]], vertices[ends[1]]};
}

// Whether elements of one mesh were nearer than a distance when it rested.
[[nodiscard]] bool are_near_at_rest(const ElementBody& body, std::uint32_t vertex, std::uint32_t face, Real distance);
[[nodiscard]] bool are_edges_near_at_rest(const ElementBody& body, std::uint32_t a, std::uint32_t b, Real distance);

}  // namespace abut
