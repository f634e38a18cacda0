// SPDX-License-Identifier: Apache-2.0
// A tree of items that come in an order: eight in turn make a node, and eight of these nodes a small sub-tree (Kamel,
// Faloutsos, "On packing R-trees", 1993). The sub-trees are items of a tree above them, where boxes that lie across
// each other would cost most.
//
// A tree packed up to its root took up to 2.6 times as long for distances, because its large boxes overlap each other.
module abut.trees.boxes.bvh;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {

Bvh::Bvh(const Aabb& around, std::span<const Aabb> boxes, std::span<const std::uint32_t> order) : Bvh(around) {
  constexpr std::size_t width = EightBoxes::width, nodes_of_small = 1 + width, ahead = 16;
  constexpr std::uint32_t levels_of_small = 2;
  std::vector<EightBoxes> small;  // the node above, then those of items; only the last sub-tree may have fewer
  const std::size_t count = (order.size() + width * width - 1) / (width * width);
  small.reserve(nodes_of_small * count);
  std::vector<Entry> entries;
  entries.reserve(count);
  for (std::size_t next = 0; next < order.size();) {
    const auto above = static_cast<std::uint32_t>(small.size());
    small.push_back(EightBoxes::empty());
    for (std::uint32_t child = 0; child < width && next < order.size(); ++child) {
      EightBoxes node = EightBoxes::empty();
      for (std::size_t lane = 0; lane < width && next < order.size(); ++lane, ++next) {
        __builtin_prefetch(&boxes[order[std::min(next + ahead, order.size() - 1)]]);
        node.set_sides(lane, entry_of(boxes[order[next]], order[next]).sides());
        node.numbers[lane] = order[next] | EightBoxes::item_bit;
      }
      small[above].set_sides(child, node.sides_around());
      small[above].numbers[child] = above + 1 + child;
      small.push_back(node);
    }
    const BoxSides sides = small[above].sides_around();
    const auto number = static_cast<std::uint32_t>(entries.size());
    entries.push_back({{sides[0], sides[1], sides[2], sides[3], sides[4], sides[5], 0, std::bit_cast<float>(number)}});
  }
  nodes_ = made_of(std::move(entries), levels_of_small, Workers(1));
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  for (EightBoxes& node : nodes_) {
    for (std::uint32_t& child : node.numbers) {
      child = EightBoxes::is_item(child)
                  ? first + static_cast<std::uint32_t>(nodes_of_small) * EightBoxes::item_of(child)
                  : child;
    }
  }
  nodes_.reserve(nodes_.size() + small.size());
  nodes_.insert(nodes_.end(), small.begin(), small.end());
  for (EightBoxes& node : std::span(nodes_).subspan(first)) {
    for (std::uint32_t& child : node.numbers) {
      child += EightBoxes::is_item(child) || child == nobody ? 0 : first;
    }
  }
}

}  // namespace abut
