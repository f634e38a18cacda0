// SPDX-License-Identifier: Apache-2.0
// Sets of triangles that look the same way, as they run along the edges between them in opposite directions; and of
// each set its area and its largest triangle, which follow vertices that move.
export module abut.triangles.alike_triangles;
import abut.core.standard;
import abut.math;

export namespace abut {

class AlikeTriangles {
 public:
  AlikeTriangles(std::span<const Vec3> vertices, std::span<const std::uint32_t> indices);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(first_groups_.size() - 1); }
  // The triangles of a set.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t set) const [[clang::lifetimebound]] {
    return between(first_groups_[set], first_groups_[set + 1]);
  }
  // Of several triangles that are as large, the first one is the largest.
  struct Summary {
    Real area = 0, area_of_largest = -1;
    std::uint32_t largest = 0;
  };
  // O(log n).
  [[nodiscard]] Summary summary(std::uint32_t set) const;

  // Of a triangle with a vertex that has moved. O(log n).
  void move(std::uint32_t triangle, std::span<const Vec3> vertices, std::span<const std::uint32_t> indices);

 private:
  static constexpr std::size_t most_in_group = 8;

  [[nodiscard]] std::span<const std::uint32_t> between(std::uint32_t group, std::uint32_t end) const
      [[clang::lifetimebound]] {
    return std::span(order_).subspan(begins_[group], begins_[end] - begins_[group]);
  }
  [[nodiscard]] static Summary both(const Summary& a, const Summary& b);
  [[nodiscard]] Summary of_group(std::uint32_t group, std::span<const Vec3> vertices,
                                 std::span<const std::uint32_t> indices) const;

  std::vector<std::uint32_t> order_;         // triangles by sets
  std::vector<std::uint32_t> groups_;        // of triangles: a few of a set together
  std::vector<std::uint32_t> begins_;        // where in that order groups begin, and the last one ends
  std::vector<std::uint32_t> first_groups_;  // of sets; and the end
  std::vector<Summary> summaries_;  // a binary tree: node i is of nodes 2 i and 2 i + 1; the last ones are of groups
};

}  // namespace abut
