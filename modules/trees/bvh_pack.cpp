// SPDX-License-Identifier: Apache-2.0
// A tree of items that come in an order: eight in turn make a node, and eight nodes the node above (Kamel, Faloutsos,
// "On packing R-trees", 1993).
module abut.trees.bvh;
import abut.core.standard;
import abut.math;
import abut.trees.eight_boxes;

namespace abut {

Bvh::Bvh(const Aabb& around, std::span<const Aabb> boxes, std::span<const std::uint32_t> order) : Bvh(around) {
  constexpr std::size_t width = EightBoxes::width;
  const auto nodes_above = [](std::size_t count) { return std::max((count + width - 1) / width, std::size_t{1}); };
  std::vector<std::size_t> counts{nodes_above(order.size())};  // of the nodes of a level, of those with items first
  std::size_t all = counts.front();
  while (counts.back() > 1) {
    counts.push_back(nodes_above(counts.back()));
    all += counts.back();
  }
  nodes_.assign(all, EightBoxes::empty());
  // Children come after their parents.
  std::size_t first = all - counts.front();
  constexpr std::size_t ahead = 16;
  for (std::size_t i = 0; i < order.size(); ++i) {
    __builtin_prefetch(&boxes[order[std::min(i + ahead, order.size() - 1)]]);
    EightBoxes& node = nodes_[first + i / width];
    node.set_sides(i % width, entry_of(boxes[order[i]], order[i]).sides());
    node.numbers[i % width] = order[i] | EightBoxes::item_bit;
  }
  for (std::size_t level = 1; level < counts.size(); ++level) {
    const std::size_t first_above = first - counts[level];
    for (std::size_t i = 0; i < counts[level - 1]; ++i) {
      EightBoxes& node = nodes_[first_above + i / width];
      node.set_sides(i % width, nodes_[first + i].sides_around());
      node.numbers[i % width] = static_cast<std::uint32_t>(first + i);
    }
    first = first_above;
  }
}

}  // namespace abut
