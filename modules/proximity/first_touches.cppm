// SPDX-License-Identifier: Apache-2.0
// What first touches while the vertices of a mesh, or of two, move on straight lines.
export module abut.proximity.first_touches;
import abut.core.standard;
import abut.core;
import abut.deforming;
import abut.math;
import abut.proximity.body;
import abut.proximity.search;
import abut.proximity.stencil;

export namespace abut {

struct FirstTouchOptions {
  std::uint32_t kinds = 0;  // a bit for StencilKind::vertex_face and ::edge_edge; 0: both
  TouchSettings touch{};
  Real rest_distance = 0;  // of one mesh: what was nearer than that at rest is left out
};

// Keeps its memory from search to search.
class FirstTouches {
 public:
  // Replaces `out`: vertices of a with faces of b by their numbers, then vertices of b with faces of a, then edges.
  // Each pair that touches occurs once, as it lies at its first touch. One mesh is given twice.
  void find(ElementBody& a, ElementBody& b, const FirstTouchOptions& options, const Workers& workers,
            std::vector<Stencil>& out);
  // But for candidates, of which there are few at a time.
  [[nodiscard]] std::size_t bytes() const;

 private:
  ElementSearch search_;
  std::vector<std::vector<Stencil>> found_;  // by task
};

}  // namespace abut
