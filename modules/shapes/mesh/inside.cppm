// SPDX-License-Identifier: Apache-2.0
// What is inside of a solid mesh, its connected pieces, and which triangles are wound the wrong way. All of it follows
// vertices that move, at the cost of the triangles around them.
export module abut.shapes.mesh.inside;
import abut.core.standard;
import abut.math;
import abut.trees.inside.winding_number;
import abut.triangles.alike_triangles;

export namespace abut {

class MeshInside {
 public:
  // Three indices to a triangle. `box`: around those that have not gone.
  MeshInside(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const Aabb& box);

  [[nodiscard]] bool contains(const Vec3& point) const { return winding_.contains(point); }
  // Whether a triangle is wound the wrong way.
  [[nodiscard]] inline bool turns(std::uint32_t index) const { return turned_sets_ > 0 && is_turned_[index]; }
  // A vertex of each connected piece.
  [[nodiscard]] std::span<const Vec3> pieces() const [[clang::lifetimebound]] { return pieces_; }

  // Of a triangle with a vertex that has moved. settle comes after the last one. Where around that vertex each edge
  // leads as often out as in, nothing changes but near these triangles: what they were and what they are enclose a
  // volume together. Else it may change everywhere.
  void move(std::uint32_t triangle, std::span<const Vec3> vertices, std::span<const std::uint32_t> indices);
  void change_everywhere() { changed_ = Aabb::everything(); }
  void settle(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const Aabb& box);
  // Whether a query costs much more than when this was made.
  [[nodiscard]] bool is_worn() const { return winding_.is_worn(); }

 private:
  // Where a set of triangles was asked whether it is wound the wrong way.
  struct Look {
    Vec3 in_front{0, 0, 0}, behind{0, 0, 0};
    bool is_turned = false;
  };
  void look(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices, const Aabb& box);

  WindingNumber winding_;
  AlikeTriangles alike_;
  std::vector<Look> looks_;  // of sets
  std::size_t turned_sets_ = 0;
  std::vector<bool> is_turned_;  // of triangles
  std::vector<std::uint32_t> vertices_of_pieces_;
  std::vector<Vec3> pieces_;
  Aabb changed_ = Aabb::everything();  // where points may have come in or out since the last settle
};

}  // namespace abut
