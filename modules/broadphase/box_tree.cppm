// A binary tree of boxes whose leaves come and go.
module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>
export module abut.broadphase.box_tree;
import abut.core.raw;
import abut.math;

export namespace abut {

// A node holds the boxes of both of its children, which makes one cache line: a visit reads no more
// than the nodes that it enters. Leaves are numbers of the caller and need no node.
class BoxTree {
 public:
  // Boxes are finite and small enough for their surface to be (|coordinate| below 1e18).
  void insert(std::uint32_t leaf, const CompactAabb& box);
  void erase(std::uint32_t leaf);
  // Gives a leaf another box. It stays where it is if that does not make any box larger.
  void move(std::uint32_t leaf, const CompactAabb& box);

  // Calls visit_leaf(leaf) for every leaf whose box overlaps. `stack` is scratch.
  template <class Visitor>
  void visit(const CompactAabb& box, std::vector<std::uint32_t>& stack, Visitor&& visit_leaf) const {
    // Lanes past the six sides are compared with infinity and never lie beyond it.
    constexpr float far = std::numeric_limits<float>::infinity();
    const Lanes limits{box.high[0], box.high[1], box.high[2], -box.low[0], -box.low[1], -box.low[2], far, far};
    stack.clear();
    std::uint32_t at = 0;
    for (;;) {
      const Node& node = nodes_[at];
      const std::array<bool, 2> overlaps{!is_any_beyond(lanes(node, 0), limits), !is_any_beyond(lanes(node, 1), limits)};
      for (std::size_t side = 0; side < 2; ++side) {
        if (overlaps[side]) {
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
    return nodes_.capacity() * sizeof(Node) + (parents_.capacity() + parents_of_leaves_.capacity()) * sizeof(std::uint32_t);
  }

 private:
  // A child is the index of a node or, with this bit, the number of a leaf.
  static constexpr std::uint32_t leaf_bit = 0x80000000;
  [[nodiscard]] static constexpr bool is_leaf(std::uint32_t child) { return (child & leaf_bit) != 0; }
  static constexpr std::uint32_t none = 0;

  // The low sides and the negated high sides of a box. That way a box around two others has the lesser
  // of each side, and two boxes overlap when no side of one is beyond the opposite side of the other.
  using Sides = std::array<float, 6>;
  static constexpr Sides nowhere{1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f};

  using Lanes = float __attribute__((vector_size(32)));
  [[nodiscard]] static inline bool is_any_beyond(const Lanes& sides, const Lanes& limits) {
    return __builtin_reduce_or(sides > limits) != 0;
  }

  struct alignas(64) Node {
    std::array<float, 14> sides;  // of both children, and two that fill the last lanes
    std::array<std::uint32_t, 2> children;
  };
  static_assert(sizeof(Node) == 64);
  [[nodiscard]] static inline Lanes lanes(const Node& node, std::size_t side) {
    return loaded<Lanes>(node.sides, 6 * side);
  }

  [[nodiscard]] static Sides sides_of(const CompactAabb& box);
  [[nodiscard]] static Sides merged(const Sides& a, const Sides& b);
  [[nodiscard]] static float half_surface(const Sides& box);
  [[nodiscard]] Sides box_of(std::uint32_t node, std::size_t side) const;
  void set_child(std::uint32_t node, std::size_t side, std::uint32_t child, const Sides& box);
  void set_box(std::uint32_t node, std::size_t side, const Sides& box);
  [[nodiscard]] std::size_t side_of(std::uint32_t child, std::uint32_t parent) const {
    return nodes_[parent].children[0] == child ? 0 : 1;
  }
  [[nodiscard]] std::uint32_t new_node();
  void fit_from(std::uint32_t node);
  void rotate(std::uint32_t node);

  // Node 0 stands above the root, which is its first child, so that the root is like any other child.
  std::vector<Node> nodes_{{{1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 1e30f, 0, 0}, {none, none}}};
  std::vector<std::uint32_t> parents_{none};
  std::vector<std::uint32_t> parents_of_leaves_;
  std::uint32_t free_ = none;  // nodes that are not in use, linked by their parents
};

}  // namespace abut
