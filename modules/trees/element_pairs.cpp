// SPDX-License-Identifier: Apache-2.0
module abut.trees.element_pairs;
import abut.core.standard;
import abut.core.small_vector;
import abut.trees.eight_boxes;
import abut.trees.element_tree;

namespace abut {
namespace {

using Numbers = EightBoxes::Numbers;

// What the sides of boxes that overlap do not exceed; see limits_of.
[[nodiscard]] [[gnu::always_inline]] inline BoxSides limits_of_sides(const BoxSides& sides) {
  constexpr float far = std::numeric_limits<float>::max();
  BoxSides limits;
  for (std::size_t i = 0; i < 6; ++i) {
    limits[i] = std::min(-sides[(i + 3) % 6], far);
  }
  return limits;
}
[[nodiscard]] [[gnu::always_inline]] inline std::uint32_t overlapping(const EightBoxes& boxes, const BoxSides& sides) {
  return boxes.overlapping(EightBoxes::widened(limits_of_sides(sides)));
}
// A bit for each lane whose number equals a vertex.
[[nodiscard]] [[gnu::always_inline]] inline Numbers equal(const std::array<std::uint32_t, 8>& lanes,
                                                          std::uint32_t vertex) {
  return std::bit_cast<Numbers>(lanes) == Numbers(static_cast<std::int32_t>(vertex));
}

// Vertices of one leaf with faces of another one, or of the same.
[[gnu::flatten]] void pair_vertices_and_faces(const ElementTree& tree, std::uint32_t a, std::uint32_t b,
                                              ElementPairs& out) {
  const std::span<const ElementBlock<3>> faces = tree.faces_of(b);
  for (const EightBoxes& vertices : tree.vertices_of(a)) {
    for (std::uint32_t rows = overlapping(vertices, tree.box_of_leaf(b)); rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::size_t>(std::countr_zero(rows));
      const std::uint32_t vertex = vertices.numbers[row];
      const EightBoxes::WideLimits limits = EightBoxes::widened(limits_of_sides(vertices.sides_of_lane(row)));
      for (const ElementBlock<3>& block : faces) {
        if (std::uint32_t mask = block.boxes.overlapping(limits); mask != 0) {
          mask &= ~EightBoxes::mask_of(equal(block.corners[0], vertex) | equal(block.corners[1], vertex) |
                                       equal(block.corners[2], vertex));
          out.append(vertex, block.boxes.numbers, mask);
        }
      }
    }
  }
}

// Edges of one leaf with those of another one, or of the same: there each pair once.
[[gnu::flatten]] void pair_edges(const ElementTree& tree, std::uint32_t a, std::uint32_t b, ElementPairs& out) {
  const std::span<const ElementBlock<2>> own = tree.edges_of(a), others = tree.edges_of(b);
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (std::uint32_t rows = overlapping(own[i].boxes, tree.box_of_leaf(b)); rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::size_t>(std::countr_zero(rows));
      const std::uint32_t edge = own[i].boxes.numbers[row];
      const std::uint32_t low = own[i].corners[0][row], high = own[i].corners[1][row];
      const EightBoxes::WideLimits limits = EightBoxes::widened(limits_of_sides(own[i].boxes.sides_of_lane(row)));
      for (std::size_t j = a == b ? i : 0; j < others.size(); ++j) {
        const ElementBlock<2>& block = others[j];
        std::uint32_t mask = block.boxes.overlapping(limits);
        if (a == b && i == j) {
          mask &= ~((2u << row) - 1);
        }
        if (mask != 0) {
          mask &= ~EightBoxes::mask_of(equal(block.corners[0], low) | equal(block.corners[1], low) |
                                       equal(block.corners[0], high) | equal(block.corners[1], high));
          out.append(edge, block.boxes.numbers, mask);
        }
      }
    }
  }
}

void pair_leaves(const ElementTree& tree, std::uint32_t a, std::uint32_t b, Candidates& out) {
  pair_vertices_and_faces(tree, a, b, out.vertices_and_faces);
  if (a != b) {
    pair_vertices_and_faces(tree, b, a, out.vertices_and_faces);
  }
  pair_edges(tree, a, b, out.edges);
}

// Calls add(pair) for the pairs of children of two nodes, or of a node and a leaf, that may hold pairs of elements.
template <class Add>
void open(const ElementTree& tree, NodePair pair, const Add& add) {
  if (pair.a == pair.b) {
    const EightBoxes& node = tree.node(pair.a);
    for (std::uint32_t left = node.present(); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      const std::uint32_t child = node.numbers[lane];
      add(NodePair{child, child});
      const std::uint32_t later = overlapping(node, node.sides_of_lane(lane)) & ~((2u << lane) - 1);
      for (std::uint32_t met = later; met != 0; met &= met - 1) {
        add(NodePair{child, node.numbers[static_cast<std::size_t>(std::countr_zero(met))]});
      }
    }
    return;
  }
  if (EightBoxes::is_item(pair.a)) {
    std::swap(pair.a, pair.b);
  }
  const EightBoxes& node = tree.node(pair.a);
  const bool has_leaf = EightBoxes::is_item(pair.b);
  const BoxSides other = has_leaf ? tree.box_of_leaf(EightBoxes::item_of(pair.b)) : tree.node(pair.b).sides_around();
  for (std::uint32_t met = overlapping(node, other); met != 0; met &= met - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(met));
    if (has_leaf) {
      add(NodePair{node.numbers[lane], pair.b});
      continue;
    }
    const EightBoxes& others = tree.node(pair.b);
    for (std::uint32_t its = overlapping(others, node.sides_of_lane(lane)); its != 0; its &= its - 1) {
      add(NodePair{node.numbers[lane], others.numbers[static_cast<std::size_t>(std::countr_zero(its))]});
    }
  }
}

[[nodiscard]] bool are_leaves(NodePair pair) { return EightBoxes::is_item(pair.a) && EightBoxes::is_item(pair.b); }

}  // namespace

void ElementPairs::grow() {
  constexpr std::size_t first_size = 1024;
  pairs_.resize(std::max(first_size, 2 * pairs_.size()));
}

std::span<const NodePair> OwnPairs::cut(const ElementTree& tree, std::size_t least) {
  pairs_.clear();
  if (!tree.is_empty()) {
    pairs_.push_back({0, 0});
  }
  for (bool can_grow = !pairs_.empty(); can_grow && pairs_.size() < least;) {
    can_grow = false;
    next_.clear();
    for (const NodePair pair : pairs_) {
      if (are_leaves(pair)) {
        next_.push_back(pair);
      } else {
        can_grow = true;
        open(tree, pair, [&](NodePair child) { next_.push_back(child); });
      }
    }
    pairs_.swap(next_);
  }
  return pairs_;
}

void append_candidates(const ElementTree& tree, NodePair nodes, Candidates& out) {
  if (tree.is_empty()) {
    return;
  }
  SmallVector<NodePair, 256> waiting;
  waiting.push_back(nodes);
  while (!waiting.empty()) {
    const NodePair pair = waiting[waiting.size() - 1];
    waiting.pop_back();
    if (are_leaves(pair)) {
      pair_leaves(tree, EightBoxes::item_of(pair.a), EightBoxes::item_of(pair.b), out);
    } else {
      open(tree, pair, [&](NodePair child) { waiting.push_back(child); });
    }
  }
}

}  // namespace abut
