// SPDX-License-Identifier: Apache-2.0
// Pairs of elements of one tree whose boxes overlap: a vertex and a face, and two edges. Elements that share a vertex
// are no pair.
export module abut.trees.element_pairs;
import abut.core.standard;
import abut.trees.element_tree;

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

// Lists of different tasks share no line of the cache.
struct alignas(64) Candidates {
  ElementPairs vertices_and_faces;  // the vertex first
  ElementPairs edges;

  void clear() {
    vertices_and_faces.clear();
    edges.clear();
  }
};

// Two nodes or leaves of a tree as it numbers children, or the same one twice: all pairs of elements below.
struct NodePair {
  std::uint32_t a, b;
};

// The pairs of elements of a tree, as pairs of nodes: at least `least` of them where the tree has so many. They follow
// from the tree alone, whatever the number of threads. The lists keep their memory.
class OwnPairs {
 public:
  [[nodiscard]] std::span<const NodePair> cut(const ElementTree& tree, std::size_t least) [[clang::lifetimebound]];

 private:
  std::vector<NodePair> pairs_, next_;
};

// Appends the pairs of elements below a pair of nodes. Each pair occurs once for all pairs of nodes of OwnPairs.
void append_candidates(const ElementTree& tree, NodePair nodes, Candidates& out);

}  // namespace abut
