// SPDX-License-Identifier: Apache-2.0
// The triangle of many that is nearest to a point: a tree of boxes, of which those that are further away than the
// nearest triangle so far are passed over. Points that lie close to each other go down the tree together, four to a
// vector.
export module abut.trees.inside.nearest_triangle;
import abut.core.standard;
import abut.math;

export namespace abut {

struct TriangleAt {
  Vec3 a, b, c;
};

// Over a triangle the distance is that of its plane, elsewhere that of its edges.
[[nodiscard]] Real squared_distance(const Vec3& point, const TriangleAt& triangle);

class NearestTriangle {
 public:
  // By its number in the order of the tree.
  struct Found {
    std::uint32_t triangle;
    Real squared;
  };

  explicit NearestTriangle(std::vector<TriangleAt> triangles);

  [[nodiscard]] std::span<const TriangleAt> triangles() const [[clang::lifetimebound]] { return triangles_; }
  // For each point. `close`: some triangles; the search is the shorter the nearer they are, and the closer the points
  // lie to each other.
  static constexpr std::size_t most_points = 32;
  void find(std::span<const Vec3> points, std::span<const std::uint32_t> close, std::span<Found> found) const;

 private:
  static constexpr std::uint32_t most_in_leaf = 4;
  // A leaf has triangles [first, first + count). Of an inner node the children are the next one and `first`.
  struct Node {
    Aabb box;
    std::uint32_t first, count;
  };
  // Holds a triangle. `up` is zero for a ball, which stands for a triangle that is too narrow for a sure plane.
  struct Disc {
    Vec3 centre, up;
    Real radius;
  };
  class Search;
  [[nodiscard]] static Disc disc_of(const TriangleAt& triangle);
  void build(std::uint32_t begin, std::uint32_t end);

  std::vector<TriangleAt> triangles_;
  std::vector<Disc> discs_;
  std::vector<Node> nodes_;
};

}  // namespace abut
