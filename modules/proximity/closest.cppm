// SPDX-License-Identifier: Apache-2.0
// Closest features of a mesh that deforms with itself, or of two such meshes. A method is a row of a table: which pairs
// of features it takes, and which of them it keeps.
export module abut.proximity.closest;
import abut.core.standard;
import abut.core;
import abut.elements.keeping;
import abut.elements.nearest;
import abut.math;
import abut.proximity.body;
import abut.proximity.search.cones;
import abut.proximity.search.least_of_faces;
import abut.proximity.search;
import abut.proximity.stencil;

export namespace abut {

enum class ClosestMethod : std::uint32_t { closest, faces, all, nearest, local_minima };

struct ClosestOptions {
  ClosestMethod method = ClosestMethod::closest;
  std::uint32_t kinds = 0;  // a bit for each StencilKind that is told; 0: those of the method
  Real reach = 0;
  Real rest_distance = 0;  // of one mesh: what was nearer than that at rest is left out
  ConeOptions cones{};
};

// Closest points that both lie strictly inside their edges.
struct EdgeStencil {
  std::uint32_t a, b;
  NearestOfEdges nearest;
};

// Keeps its memory from search to search.
class ClosestFeatures {
 public:
  // Replaces `out`: stencils of vertices of a in the order of their numbers, those of one by distance; then those of
  // vertices of b with edges and faces of a; then edges by their numbers. Two vertices occur once: of one mesh the
  // lower number is first. One mesh is given twice.
  void find(ElementBody& a, ElementBody& b, const ClosestOptions& options, const Workers& workers,
            std::vector<Stencil>& out);
  // But for candidates, of which there are few at a time.
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Found {
    std::array<std::vector<FaceStencil>, 2> of_vertices;  // of a, of b
    std::vector<EdgeStencil> edges;
    std::vector<Stencil> stencils;
  };
  // Stencils of vertices, sorted by vertex.
  struct Grouped {
    std::vector<FaceStencil> stencils;
    std::vector<std::uint32_t> firsts;
  };

  void collect(const ElementBody& a, const ElementBody& b, const ClosestOptions& options, const Workers& workers);
  void group(std::size_t side, std::size_t vertex_count);
  void gather_edges();
  void keep_least_of_faces(const ElementBody& a, const ElementBody& b);
  void tell_vertices(std::size_t side, const ElementBody& own, const ElementBody& other, const ClosestOptions& options,
                     const Workers& workers, std::vector<Stencil>& out);
  static void merge_vertices(bool is_one_mesh, std::vector<Stencil>& out);
  void tell_edges(const ElementBody& a, const ElementBody& b, const ClosestOptions& options, std::vector<Stencil>& out);

  ElementSearch search_;
  std::vector<Found> found_;  // by task
  std::array<Grouped, 2> grouped_;
  std::vector<EdgeStencil> edges_;
  LeastOfFaces least_;
};

}  // namespace abut
