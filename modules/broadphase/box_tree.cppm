// A binary tree of boxes whose leaves come and go.
module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>
export module abut.broadphase.box_tree;
import abut.math;

export namespace abut {

[[nodiscard]] inline CompactAabb merged(const CompactAabb& a, const CompactAabb& b) {
  const auto least = [](float x, float y) { return x < y ? x : y; };
  const auto most = [](float x, float y) { return x > y ? x : y; };
  return {{least(a.low[0], b.low[0]), least(a.low[1], b.low[1]), least(a.low[2], b.low[2])},
          {most(a.high[0], b.high[0]), most(a.high[1], b.high[1]), most(a.high[2], b.high[2])}};
}

// Half the surface: what the chance of being visited is proportional to.
[[nodiscard]] inline float half_surface(const CompactAabb& box) {
  const float x = box.high[0] - box.low[0], y = box.high[1] - box.low[1], z = box.high[2] - box.low[2];
  return x * y + y * z + z * x;
}

// A node holds the boxes of both of its children, which makes one cache line: a visit reads no more
// than the nodes that it enters. Leaves are numbers of the caller and need no node.
class BoxTree {
 public:
  // Boxes are finite and small enough for their surface to be (|coordinate| below 1e18).
  void insert(std::uint32_t leaf, const CompactAabb& box);
  void erase(std::uint32_t leaf);

  // Calls visit_leaf(leaf) for every leaf whose box overlaps. `stack` is scratch.
  template <class Visitor>
  void visit(const CompactAabb& box, std::vector<std::uint32_t>& stack, Visitor&& visit_leaf) const {
    stack.clear();
    std::uint32_t at = 0;
    for (;;) {
      const Node& node = nodes_[at];
      for (std::size_t side = 0; side < 2; ++side) {
        if (node.boxes[side].overlaps(box)) {
          const std::uint32_t child = node.children[side];
          if (is_leaf(child)) {
            visit_leaf(child & ~leaf_bit);
          } else {
            stack.push_back(child);
          }
        }
      }
      if (stack.empty()) {
        return;
      }
      at = stack.back();
      stack.pop_back();
    }
  }

  [[nodiscard]] std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + parents_of_leaves_.capacity() * sizeof(std::uint32_t);
  }

 private:
  // A child is the index of a node or, with this bit, the number of a leaf.
  static constexpr std::uint32_t leaf_bit = 0x80000000;
  [[nodiscard]] static constexpr bool is_leaf(std::uint32_t child) { return (child & leaf_bit) != 0; }
  // Overlaps nothing: the box of a child that is not there.
  static constexpr CompactAabb nowhere{{1, 1, 1}, {-1e30f, -1e30f, -1e30f}};
  static constexpr std::uint32_t none = 0;

  struct alignas(64) Node {
    std::array<CompactAabb, 2> boxes{nowhere, nowhere};
    std::array<std::uint32_t, 2> children{none, none};
    std::uint32_t parent = none;
  };
  static_assert(sizeof(Node) == 64);

  [[nodiscard]] std::uint32_t new_node();
  void set_parent(std::uint32_t child, std::uint32_t parent);
  [[nodiscard]] std::size_t side_of(std::uint32_t child, std::uint32_t parent) const {
    return nodes_[parent].children[0] == child ? 0 : 1;
  }
  void rotate(std::uint32_t at);

  // Node 0 stands above the root, which is its first child, so that the root is like any other child.
  std::vector<Node> nodes_ = std::vector<Node>(1);
  std::vector<std::uint32_t> parents_of_leaves_;
  std::uint32_t free_ = none;  // nodes that are not in use, linked by their parents
};

}  // namespace abut
