module;
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>
module abut.broadphase.box_tree;
import abut.math;

namespace abut {

std::uint32_t BoxTree::new_node() {
  if (free_ != none) {
    const std::uint32_t node = free_;
    free_ = nodes_[node].parent;
    return node;
  }
  nodes_.emplace_back();
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void BoxTree::set_parent(std::uint32_t child, std::uint32_t parent) {
  if (is_leaf(child)) {
    parents_of_leaves_[child & ~leaf_bit] = parent;
  } else {
    nodes_[child].parent = parent;
  }
}

// Goes down where the surfaces of the boxes on the way grow least. Stops where a new node above the
// present child costs less than the least that going on can cost. (Surface area heuristic: Goldsmith
// and Salmon, "Automatic creation of object hierarchies for ray tracing", 1987.)
void BoxTree::insert(std::uint32_t leaf, const CompactAabb& box) {
  if (leaf >= parents_of_leaves_.size()) {
    parents_of_leaves_.resize(std::size_t{leaf} + 1, none);
  }
  const std::uint32_t added = leaf | leaf_bit;
  if (nodes_[0].children[0] == none) {
    nodes_[0].children[0] = added;
    nodes_[0].boxes[0] = box;
    set_parent(added, 0);
    return;
  }
  const std::uint32_t node = new_node();
  std::uint32_t above = 0;
  std::size_t side = 0;
  for (;;) {
    Node& parent = nodes_[above];
    const std::uint32_t child = parent.children[side];
    const CompactAabb whole = merged(parent.boxes[side], box);
    if (is_leaf(child)) {
      break;
    }
    const Node& here = nodes_[child];
    const float stop = half_surface(whole);
    const float grown = stop - half_surface(parent.boxes[side]);
    std::array<float, 2> go_on{};
    for (std::size_t i = 0; i < 2; ++i) {
      const float inside = is_leaf(here.children[i]) ? 0.0f : half_surface(here.boxes[i]);
      go_on[i] = grown + half_surface(merged(here.boxes[i], box)) - inside;
    }
    if (stop < go_on[0] && stop < go_on[1]) {
      break;
    }
    parent.boxes[side] = whole;
    above = child;
    side = go_on[0] <= go_on[1] ? 0 : 1;
  }
  Node& parent = nodes_[above];
  const std::uint32_t sibling = parent.children[side];
  nodes_[node] = {{parent.boxes[side], box}, {sibling, added}, above};
  parent.children[side] = node;
  parent.boxes[side] = merged(parent.boxes[side], box);
  set_parent(sibling, node);
  set_parent(added, node);
  for (std::uint32_t at = above; at != 0; at = nodes_[at].parent) {
    rotate(at);
  }
}

// Exchanges a child with a child of the other one if that makes the box of the latter smaller.
// (Kensler, "Tree rotations for improving bounding volume hierarchies", 2008.)
void BoxTree::rotate(std::uint32_t at) {
  Node& node = nodes_[at];
  float best = 0;
  std::size_t best_side = 0, best_inner = 0;
  for (std::size_t side = 0; side < 2; ++side) {
    if (is_leaf(node.children[side])) {
      continue;
    }
    const Node& child = nodes_[node.children[side]];
    const float now = half_surface(node.boxes[side]);
    for (std::size_t inner = 0; inner < 2; ++inner) {
      const float gain = now - half_surface(merged(node.boxes[1 - side], child.boxes[1 - inner]));
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
  const std::uint32_t lower = node.children[best_side];
  Node& child = nodes_[lower];
  std::swap(node.boxes[1 - best_side], child.boxes[best_inner]);
  std::swap(node.children[1 - best_side], child.children[best_inner]);
  node.boxes[best_side] = merged(child.boxes[0], child.boxes[1]);
  set_parent(node.children[1 - best_side], at);
  set_parent(child.children[best_inner], lower);
}

void BoxTree::erase(std::uint32_t leaf) {
  const std::uint32_t gone = leaf | leaf_bit;
  const std::uint32_t node = parents_of_leaves_[leaf];
  if (node == 0) {
    nodes_[0] = Node{};
    return;
  }
  // The sibling takes the place of the node; the boxes above may shrink.
  const std::size_t other = 1 - side_of(gone, node);
  const std::uint32_t sibling = nodes_[node].children[other];
  std::uint32_t above = nodes_[node].parent;
  const std::size_t side = side_of(node, above);
  nodes_[above].children[side] = sibling;
  nodes_[above].boxes[side] = nodes_[node].boxes[other];
  set_parent(sibling, above);
  nodes_[node].parent = free_;
  free_ = node;
  while (above != 0) {
    const std::uint32_t next = nodes_[above].parent;
    const CompactAabb box = merged(nodes_[above].boxes[0], nodes_[above].boxes[1]);
    CompactAabb& stored = nodes_[next].boxes[side_of(above, next)];
    if (stored.low == box.low && stored.high == box.high) {
      return;
    }
    stored = box;
    above = next;
  }
}

}  // namespace abut
