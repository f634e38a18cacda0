// SPDX-License-Identifier: Apache-2.0
// Edges that pass faces as the vertices lie at the start: whether a mesh, or two, are free of intersections.
export module abut.proximity.crossings;
import abut.core.standard;
import abut.core;
import abut.proximity.body;
import abut.proximity.search;
import abut.proximity.stencil;

export namespace abut {

// Keeps its memory from search to search.
class Crossings {
 public:
  // Replaces `out`: edges of a by their numbers, each with its faces, then those of b. Exact: an edge that only touches
  // a face counts, also along it. One mesh is given twice; elements that share a vertex are no pair then.
  void find(ElementBody& a, ElementBody& b, const Workers& workers, std::vector<Crossing>& out);

 private:
  ElementSearch search_;
  std::vector<std::vector<Crossing>> found_;  // by task
};

}  // namespace abut
