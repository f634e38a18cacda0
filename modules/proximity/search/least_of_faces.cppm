// SPDX-License-Identifier: Apache-2.0
// Which pairs of features are the closest ones of two faces: of fifteen, the least.
export module abut.proximity.search.least_of_faces;
import abut.core.standard;
import abut.math;
import abut.proximity.body;

export namespace abut {

// Pairs of features are numbered as they are added. Faces of one mesh that share a vertex are no pair. Keeps its memory
// from search to search.
class LeastOfFaces {
 public:
  void clear() {
    entries_.clear();
    count_ = 0;
  }
  // A vertex with a face of the other mesh; `is_of_b` tells whose vertex it is.
  void add_vertex(const ElementBody& a, const ElementBody& b, std::uint32_t vertex, std::uint32_t face, bool is_of_b,
                  Real square);
  void add_edges(const ElementBody& a, const ElementBody& b, std::uint32_t of_a, std::uint32_t of_b, Real square);
  // Whether each is the closest of some two faces. Distances that differ by a billionth are equal.
  [[nodiscard]] const std::vector<bool>& result() [[clang::lifetimebound]];
  [[nodiscard]] std::size_t bytes() const { return entries_.capacity() * sizeof(Entry) + is_least_.capacity() / 8; }

 private:
  struct Entry {
    std::uint64_t faces;  // of a, then of b
    Real square;
    std::uint32_t number;
  };
  void add(const ElementBody& a, const ElementBody& b, std::uint32_t of_a, std::uint32_t of_b, Real square);

  std::vector<Entry> entries_;
  std::vector<bool> is_least_;
  std::uint32_t count_ = 0;
};

}  // namespace abut
