// SPDX-License-Identifier: Apache-2.0
module abut.trees.elements.element_pairs;
import abut.core.standard;
import abut.core.memory.small_vector;
import abut.trees.volumes.eight_boxes;
import abut.trees.elements.element_tree;

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

// Vertices of one leaf with faces of another one. Those of one tree share vertices, which `own` says.
template <bool own>
[[gnu::flatten]] void pair_vertices_and_faces(std::span<const EightBoxes> all_vertices, const BoxSides& around_faces,
                                              std::span<const ElementBlock<3>> faces, ElementPairs& out) {
  for (const EightBoxes& vertices : all_vertices) {
    for (std::uint32_t rows = overlapping(vertices, around_faces); rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::size_t>(std::countr_zero(rows));
      const std::uint32_t vertex = vertices.numbers[row];
      const EightBoxes::WideLimits limits = EightBoxes::widened(limits_of_sides(vertices.sides_of_lane(row)));
      for (const ElementBlock<3>& block : faces) {
        if (std::uint32_t mask = block.boxes.overlapping(limits); mask != 0) {
          if constexpr (own) {
            mask &= ~EightBoxes::mask_of(equal(block.corners[0], vertex) | equal(block.corners[1], vertex) |
                                         equal(block.corners[2], vertex));
          }
          out.append(vertex, block.boxes.numbers, mask);
        }
      }
    }
  }
}

// Edges of one leaf with those of another one, or of the same: there each pair once.
template <bool own>
[[gnu::flatten]] void pair_edges(std::span<const ElementBlock<2>> edges, const BoxSides& around_others,
                                 std::span<const ElementBlock<2>> others, bool are_same, ElementPairs& out) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::uint32_t rows = overlapping(edges[i].boxes, around_others); rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::size_t>(std::countr_zero(rows));
      const std::uint32_t edge = edges[i].boxes.numbers[row];
      const std::uint32_t low = edges[i].corners[0][row], high = edges[i].corners[1][row];
      const EightBoxes::WideLimits limits = EightBoxes::widened(limits_of_sides(edges[i].boxes.sides_of_lane(row)));
      for (std::size_t j = are_same ? i : 0; j < others.size(); ++j) {
        const ElementBlock<2>& block = others[j];
        std::uint32_t mask = block.boxes.overlapping(limits);
        if (are_same && i == j) {
          mask &= ~((2u << row) - 1);
        }
        if (mask != 0) {
          if constexpr (own) {
            mask &= ~EightBoxes::mask_of(equal(block.corners[0], low) | equal(block.corners[1], low) |
                                         equal(block.corners[0], high) | equal(block.corners[1], high));
          }
          out.append(edge, block.boxes.numbers, mask);
        }
      }
    }
  }
}

// Edges of one leaf with faces of another one.
template <bool own>
[[gnu::flatten]] void pair_edges_and_faces(std::span<const ElementBlock<2>> all_edges, const BoxSides& around_faces,
                                           std::span<const ElementBlock<3>> faces, ElementPairs& out) {
  for (const ElementBlock<2>& edges : all_edges) {
    for (std::uint32_t rows = overlapping(edges.boxes, around_faces); rows != 0; rows &= rows - 1) {
      const auto row = static_cast<std::size_t>(std::countr_zero(rows));
      const EightBoxes::WideLimits limits = EightBoxes::widened(limits_of_sides(edges.boxes.sides_of_lane(row)));
      for (const ElementBlock<3>& block : faces) {
        if (std::uint32_t mask = block.boxes.overlapping(limits); mask != 0) {
          if constexpr (own) {
            for (const auto& ends : edges.corners) {
              mask &= ~EightBoxes::mask_of(equal(block.corners[0], ends[row]) | equal(block.corners[1], ends[row]) |
                                           equal(block.corners[2], ends[row]));
            }
          }
          out.append(edges.boxes.numbers[row], block.boxes.numbers, mask);
        }
      }
    }
  }
}

// A leaf of a and one of b.
template <bool own>
void pair_leaves(const ElementTree& a, const ElementTree& b, NodePair leaves, Candidates& out) {
  pair_vertices_and_faces<own>(a.vertices_of(leaves.a), b.box_of_leaf(leaves.b), b.faces_of(leaves.b),
                               out.vertices_and_faces);
  if (!own || leaves.a != leaves.b) {
    pair_vertices_and_faces<own>(b.vertices_of(leaves.b), a.box_of_leaf(leaves.a), a.faces_of(leaves.a),
                                 own ? out.vertices_and_faces : out.faces_and_vertices);
  }
  pair_edges<own>(a.edges_of(leaves.a), b.box_of_leaf(leaves.b), b.edges_of(leaves.b), own && leaves.a == leaves.b,
                  out.edges);
}
template <bool own>
void pair_leaves(const ElementTree& a, const ElementTree& b, NodePair leaves, CrossingCandidates& out) {
  pair_edges_and_faces<own>(a.edges_of(leaves.a), b.box_of_leaf(leaves.b), b.faces_of(leaves.b), out.edges_and_faces);
  if (!own || leaves.a != leaves.b) {
    pair_edges_and_faces<own>(b.edges_of(leaves.b), a.box_of_leaf(leaves.a), a.faces_of(leaves.a),
                              own ? out.edges_and_faces : out.faces_and_edges);
  }
}

// Calls add(pair) for the pairs of children of a node with itself.
template <class Add>
void open_with_itself(const EightBoxes& node, const Add& add) {
  for (std::uint32_t left = node.present(); left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    const std::uint32_t child = node.numbers[lane];
    add(NodePair{child, child});
    const std::uint32_t later = overlapping(node, node.sides_of_lane(lane)) & ~((2u << lane) - 1);
    for (std::uint32_t met = later; met != 0; met &= met - 1) {
      add(NodePair{child, node.numbers[static_cast<std::size_t>(std::countr_zero(met))]});
    }
  }
}

// Calls add(child) for the children of a node that overlap a box.
template <class Add>
void open_beside(const EightBoxes& node, const BoxSides& box, const Add& add) {
  for (std::uint32_t met = overlapping(node, box); met != 0; met &= met - 1) {
    add(static_cast<std::size_t>(std::countr_zero(met)));
  }
}

// Calls add(pair) for the pairs of children of two nodes, or of a node and a leaf, that may hold pairs of elements.
template <class Add>
void open(const ElementTree& a, const ElementTree& b, NodePair pair, const Add& add) {
  if (&a == &b && pair.a == pair.b) {
    open_with_itself(a.node(pair.a), add);
  } else if (EightBoxes::is_item(pair.a)) {
    const EightBoxes& node = b.node(pair.b);
    open_beside(node, a.box_of_leaf(EightBoxes::item_of(pair.a)),
                [&](std::size_t lane) { add(NodePair{pair.a, node.numbers[lane]}); });
  } else if (EightBoxes::is_item(pair.b)) {
    const EightBoxes& node = a.node(pair.a);
    open_beside(node, b.box_of_leaf(EightBoxes::item_of(pair.b)),
                [&](std::size_t lane) { add(NodePair{node.numbers[lane], pair.b}); });
  } else {
    const EightBoxes &node = a.node(pair.a), &others = b.node(pair.b);
    open_beside(node, others.sides_around(), [&](std::size_t lane) {
      open_beside(others, node.sides_of_lane(lane),
                  [&](std::size_t its) { add(NodePair{node.numbers[lane], others.numbers[its]}); });
    });
  }
}

[[nodiscard]] bool are_leaves(NodePair pair) { return EightBoxes::is_item(pair.a) && EightBoxes::is_item(pair.b); }

template <class Found>
void append_below(const ElementTree& a, const ElementTree& b, NodePair nodes, Found& out) {
  if (a.is_empty() || b.is_empty()) {
    return;
  }
  SmallVector<NodePair, 256> waiting;
  waiting.push_back(nodes);
  while (!waiting.empty()) {
    const NodePair pair = waiting[waiting.size() - 1];
    waiting.pop_back();
    if (!are_leaves(pair)) {
      open(a, b, pair, [&](NodePair child) { waiting.push_back(child); });
      continue;
    }
    const NodePair leaves{EightBoxes::item_of(pair.a), EightBoxes::item_of(pair.b)};
    if (&a == &b) {
      pair_leaves<true>(a, b, leaves, out);
    } else {
      pair_leaves<false>(a, b, leaves, out);
    }
  }
}

}  // namespace

void ElementPairs::grow() {
  constexpr std::size_t first_size = 1024;
  pairs_.resize(std::max(first_size, 2 * pairs_.size()));
}

void NodePairs::cut(const ElementTree& a, const ElementTree& b, std::size_t least) {
  pairs_.clear();
  if (!a.is_empty() && !b.is_empty()) {
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
        open(a, b, pair, [&](NodePair child) { next_.push_back(child); });
      }
    }
    pairs_.swap(next_);
  }
}

void append_candidates(const ElementTree& a, const ElementTree& b, NodePair nodes, Candidates& out) {
  append_below(a, b, nodes, out);
}
void append_candidates(const ElementTree& a, const ElementTree& b, NodePair nodes, CrossingCandidates& out) {
  append_below(a, b, nodes, out);
}

}  // namespace abut
