module;
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>
module abut.broadphase.box_tree;
import abut.math;

namespace abut {

BoxTree::Sides BoxTree::sides_of(const CompactAabb& box) {
  return {box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1], -box.high[2]};
}

inline BoxTree::Sides BoxTree::merged(const Sides& a, const Sides& b) {
  Sides both;
  for (std::size_t i = 0; i < both.size(); ++i) {
    both[i] = a[i] < b[i] ? a[i] : b[i];
  }
  return both;
}

// What the chance of being visited is proportional to.
inline float BoxTree::half_surface(const Sides& box) {
  // Minus the lengths of the edges; the signs cancel in the products.
  const float x = box[0] + box[3], y = box[1] + box[4], z = box[2] + box[5];
  return x * y + y * z + z * x;
}

inline BoxTree::Sides BoxTree::box_of(std::uint32_t node, std::size_t side) const {
  Sides box;
  const std::span<const float> stored = std::span(nodes_[node].sides).subspan(6 * side, 6);
  std::copy(stored.begin(), stored.end(), box.begin());
  return box;
}

inline void BoxTree::set_box(std::uint32_t node, std::size_t side, const Sides& box) {
  const std::span<float> stored = std::span(nodes_[node].sides).subspan(6 * side, 6);
  std::copy(box.begin(), box.end(), stored.begin());
}

void BoxTree::set_child(std::uint32_t node, std::size_t side, std::uint32_t child, const Sides& box) {
  nodes_[node].children[side] = child;
  set_box(node, side, box);
  if (is_leaf(child)) {
    parents_of_leaves_[child & ~leaf_bit] = node;
  } else {
    parents_[child] = node;
  }
}

std::uint32_t BoxTree::new_node() {
  if (free_ != none) {
    const std::uint32_t node = free_;
    free_ = parents_[node];
    return node;
  }
  nodes_.push_back({{}, {none, none}});
  parents_.push_back(none);
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

// Goes down where the surfaces of the boxes on the way grow least. Stops where a new node above the
// present child costs less than the least that going on can cost. (Surface area heuristic: Goldsmith
// and Salmon, "Automatic creation of object hierarchies for ray tracing", 1987.)
void BoxTree::insert(std::uint32_t leaf, const CompactAabb& compact_box) {
  if (leaf >= parents_of_leaves_.size()) {
    parents_of_leaves_.resize(std::size_t{leaf} + 1, none);
  }
  const std::uint32_t added = leaf | leaf_bit;
  const Sides box = sides_of(compact_box);
  if (nodes_[0].children[0] == none) {
    set_child(0, 0, added, box);
    return;
  }
  const std::uint32_t node = new_node();
  std::uint32_t above = 0;
  std::size_t side = 0;
  for (;;) {
    const std::uint32_t child = nodes_[above].children[side];
    if (is_leaf(child)) {
      break;
    }
    const Sides present = box_of(above, side);
    const Sides whole = merged(present, box);
    const float stop = half_surface(whole);
    const float grown = stop - half_surface(present);
    std::array<float, 2> go_on{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Sides inner = box_of(child, i);
      const float inside = is_leaf(nodes_[child].children[i]) ? 0.0f : half_surface(inner);
      go_on[i] = grown + half_surface(merged(inner, box)) - inside;
    }
    if (stop < go_on[0] && stop < go_on[1]) {
      break;
    }
    set_box(above, side, whole);
    above = child;
    side = go_on[0] <= go_on[1] ? 0 : 1;
  }
  const Sides sibling_box = box_of(above, side);
  set_child(node, 0, nodes_[above].children[side], sibling_box);
  set_child(node, 1, added, box);
  set_child(above, side, node, merged(sibling_box, box));
  for (std::uint32_t at = above; at != 0; at = parents_[at]) {
    rotate(at);
  }
}

// Exchanges a child with a child of the other one if that makes the box of the latter smaller.
// (Kensler, "Tree rotations for improving bounding volume hierarchies", 2008.)
void BoxTree::rotate(std::uint32_t node) {
  float best = 0;
  std::size_t best_side = 0, best_inner = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::uint32_t child = nodes_[node].children[side];
    if (is_leaf(child)) {
      continue;
    }
    const float now = half_surface(box_of(node, side));
    const Sides other = box_of(node, 1 - side);
    for (std::size_t inner = 0; inner < 2; ++inner) {
      const float gain = now - half_surface(merged(other, box_of(child, 1 - inner)));
      if (gain > best) {
        best = gain;
        best_side = side;
        best_inner = inner;
      }
    }
  }
  if (!(best > 0)) {
    return;
  }
  const std::uint32_t lower = nodes_[node].children[best_side];
  const std::uint32_t going_down = nodes_[node].children[1 - best_side], coming_up = nodes_[lower].children[best_inner];
  const Sides down_box = box_of(node, 1 - best_side), up_box = box_of(lower, best_inner);
  set_child(node, 1 - best_side, coming_up, up_box);
  set_child(lower, best_inner, going_down, down_box);
  set_box(node, best_side, merged(box_of(lower, 0), box_of(lower, 1)));
}

// Fits the boxes above a node whose children have changed.
void BoxTree::fit_from(std::uint32_t node) {
  while (node != 0) {
    const std::uint32_t above = parents_[node];
    const std::size_t side = side_of(node, above);
    const Sides box = merged(box_of(node, 0), box_of(node, 1));
    if (box == box_of(above, side)) {
      return;
    }
    set_box(above, side, box);
    node = above;
  }
}

void BoxTree::erase(std::uint32_t leaf) {
  const std::uint32_t gone = leaf | leaf_bit;
  const std::uint32_t node = parents_of_leaves_[leaf];
  if (node == 0) {
    nodes_[0].children[0] = none;
    set_box(0, 0, nowhere);
    return;
  }
  // The sibling takes the place of the node.
  const std::size_t other = 1 - side_of(gone, node);
  const std::uint32_t above = parents_[node];
  set_child(above, side_of(node, above), nodes_[node].children[other], box_of(node, other));
  parents_[node] = free_;
  free_ = node;
  fit_from(above);
}

void BoxTree::move(std::uint32_t leaf, const CompactAabb& compact_box) {
  const Sides box = sides_of(compact_box);
  const std::uint32_t node = parents_of_leaves_[leaf];
  const std::uint32_t above = parents_[node];
  const Sides around = box_of(above, node == 0 ? 0 : side_of(node, above));
  if (node != 0 && merged(around, box) == around) {
    set_box(node, side_of(leaf | leaf_bit, node), box);
    fit_from(node);
  } else {
    erase(leaf);
    insert(leaf, compact_box);
  }
}

}  // namespace abut
