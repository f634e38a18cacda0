// SPDX-License-Identifier: Apache-2.0
// A tree over the triangles of a deforming mesh whose leaves also hold the vertices and edges that their triangles own.
// One descent then finds pairs of a vertex and a face as well as pairs of edges. The form of the tree stays, its boxes
// are fitted to the vertices of one time or of two.
export module abut.trees.elements.element_tree;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.triangles.elements;
import abut.trees.boxes.bvh;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// Boxes of eight edges or faces, their numbers, and the vertices at their corners.
template <std::size_t corner_count>
struct ElementBlock {
  EightBoxes boxes = EightBoxes::empty();
  std::array<std::array<std::uint32_t, EightBoxes::width>, corner_count> corners{};
};

// Near the middle of a box, but a multiple of a power of two that is no less than its extent: coordinates relative to
// it have no more digits than before, and it is zero for a box around the origin.
[[nodiscard]] Vec3 origin_for(const Aabb& box);

class ElementTree {
 public:
  // Where the blocks of a leaf begin; they end where those of the next leaf begin.
  struct Leaf {
    std::uint32_t vertices, edges, faces;
    BoxSides around;
  };

  ElementTree() = default;
  // Of the triangles that `table` was made of. The form follows from where the vertices are; call fit afterwards.
  ElementTree(const ElementTable& table, std::span<const std::uint32_t> triangles, std::span<const Vec3> vertices,
              const Workers& workers);

  // What boxes are relative to from the next fit on. Two trees are compared where they have the same origin.
  void set_origin(const Vec3& origin) { origin_ = origin; }
  // Fits all boxes to the vertices at two times, and to all places between them. Each box is grown by `reach` and
  // rounded outward. Vertices of single precision near the origin give exact boxes. Linear; allocates nothing.
  void fit(std::span<const Vec3> start, std::span<const Vec3> end, Real reach, const Workers& workers);

  [[nodiscard]] bool is_empty() const { return leaves_.size() < 2; }
  // See Hierarchy; its items are leaves.
  [[nodiscard]] const Vec3& origin() const [[clang::lifetimebound]] { return origin_; }
  [[nodiscard]] const EightBoxes& node(std::uint32_t index) const [[clang::lifetimebound]] { return nodes_[index]; }
  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  template <class Visitor>
  void visit_children(std::uint32_t node, Visitor&& visit) const {
    visit(nodes_[node]);
  }

  [[nodiscard]] std::size_t leaf_count() const { return is_empty() ? 0 : leaves_.size() - 1; }
  [[nodiscard]] const BoxSides& box_of_leaf(std::uint32_t leaf) const [[clang::lifetimebound]] {
    return leaves_[leaf].around;
  }
  [[nodiscard]] std::span<const EightBoxes> vertices_of(std::uint32_t leaf) const [[clang::lifetimebound]] {
    return part(std::span<const EightBoxes>(vertices_), leaves_[leaf].vertices, leaves_[leaf + 1].vertices);
  }
  [[nodiscard]] std::span<const ElementBlock<2>> edges_of(std::uint32_t leaf) const [[clang::lifetimebound]] {
    return part(std::span<const ElementBlock<2>>(edges_), leaves_[leaf].edges, leaves_[leaf + 1].edges);
  }
  [[nodiscard]] std::span<const ElementBlock<3>> faces_of(std::uint32_t leaf) const [[clang::lifetimebound]] {
    return part(std::span<const ElementBlock<3>>(faces_), leaves_[leaf].faces, leaves_[leaf + 1].faces);
  }
  [[nodiscard]] std::size_t bytes() const;

 private:
  using LeafTriangles = std::array<std::uint32_t, EightBoxes::width>;
  // Eight numbers to copy at once: the sides of a box, and two without use.
  using Row = EightBoxes::Floats;
  template <class Block>
  [[nodiscard]] static std::span<const Block> part(std::span<const Block> all, std::size_t begin, std::size_t end) {
    return all.subspan(begin, end - begin);
  }
  std::uint32_t take_form(const Bvh& form, std::uint32_t node, std::vector<LeafTriangles>& leaves);
  void add_leaf(const ElementTable& table, std::span<const std::uint32_t> triangles, const LeafTriangles& its);
  [[nodiscard]] Leaf end_of_blocks() const;
  void fit_leaf(Leaf& leaf, const Leaf& next);
  void fit_nodes();

  Vec3 origin_{0, 0, 0};
  std::vector<EightBoxes> nodes_;  // children come after their parents
  std::vector<Leaf> leaves_;       // and one more, where the last blocks end
  std::vector<EightBoxes> vertices_;
  std::vector<ElementBlock<2>> edges_;
  std::vector<ElementBlock<3>> faces_;
  std::vector<Row> boxes_;  // of vertices
};
static_assert(Hierarchy<ElementTree>);

}  // namespace abut
