// SPDX-License-Identifier: Apache-2.0
// Pairs of elements whose boxes overlap, of two trees with one origin, or of a tree with itself: a vertex and a face,
// two edges, or an edge and a face. Elements of one tree that share a vertex are no pair.
export module abut.trees.elements.element_pairs;
import abut.core.standard;
import abut.trees.elements.element_tree;

export namespace abut {

using ElementPair = std::array<std::uint32_t, 2>;

// A list that is filled again and again and keeps its memory.
class ElementPairs {
 public:
  [[nodiscard]] std::span<const ElementPair> list() const [[clang::lifetimebound]] {
    return std::span(pairs_).first(size_);
  }
  void clear() { size_ = 0; }
  // `first` with each of eight numbers whose bit is set.
  [[gnu::always_inline]] inline void append(std::uint32_t first, const std::array<std::uint32_t, 8>& numbers,
                                            std::uint32_t mask) {
    if (pairs_.size() < size_ + numbers.size()) [[unlikely]] {
      grow();
    }
    for (; mask != 0; mask &= mask - 1) {
      pairs_[size_++] = {first, numbers[static_cast<std::size_t>(std::countr_zero(mask))]};
    }
  }

 private:
  void grow();

  std::vector<ElementPair> pairs_;
  std::size_t size_ = 0;
};

// Of a tree a with a tree b. Lists of different tasks share no line of the cache.
struct alignas(64) Candidates {
  ElementPairs vertices_and_faces;  // a vertex of a first; of one tree all pairs
  ElementPairs faces_and_vertices;  // a vertex of b first, then the face of a; none of one tree
  ElementPairs edges;               // that of a first

  void clear() {
    vertices_and_faces.clear();
    faces_and_vertices.clear();
    edges.clear();
  }
};
struct alignas(64) CrossingCandidates {
  ElementPairs edges_and_faces;  // an edge of a first; of one tree all pairs
  ElementPairs faces_and_edges;  // an edge of b first, then the face of a; none of one tree

  void clear() {
    edges_and_faces.clear();
    faces_and_edges.clear();
  }
};

// Two nodes or leaves as their trees number children.
struct NodePair {
  std::uint32_t a, b;
};

// The pairs of elements of two trees, or of one that is given twice, as pairs of nodes: at least `least` of them where
// there are so many. They follow from the trees alone, whatever the number of threads. The lists keep their memory.
class NodePairs {
 public:
  void cut(const ElementTree& a, const ElementTree& b, std::size_t least);
  [[nodiscard]] std::span<const NodePair> list() const [[clang::lifetimebound]] { return pairs_; }

 private:
  std::vector<NodePair> pairs_, next_;
};

// Appends the pairs of elements below a pair of nodes. Each pair occurs once for all pairs of NodePairs.
void append_candidates(const ElementTree& a, const ElementTree& b, NodePair nodes, Candidates& out);
void append_candidates(const ElementTree& a, const ElementTree& b, NodePair nodes, CrossingCandidates& out);

}  // namespace abut
