// SPDX-License-Identifier: Apache-2.0
module abut.trees.boxes.box_tree;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {
namespace {

// Children of a node that is made among leaves that move, so that the first ones that come do not split it.
constexpr std::size_t usual_fill = 6;

// From so many leaves on, the scratch of the first making is given back: most of them may never move.
constexpr std::size_t many_leaves = 65'536;

// A side, or what stands for an infinite one where sums must not overflow.
[[nodiscard]] inline float finite(float side) {
  constexpr float far = std::numeric_limits<float>::max() / 4;
  return std::clamp(side, -far, far);
}

}  // namespace

// Halves along the longest axis of the centres until what is left fills a node. Cuts lie at whole nodes of the highest
// level that both sides have.
void BoxTree::put_in_order_of_space(std::span<Entry> entries, std::size_t fill) {
  while (entries.size() > fill) {
    BoxSides around = no_sides;
    const auto centre = [](const Entry& entry, std::size_t axis) {
      return finite(entry.sides[axis]) - finite(entry.sides[axis + 3]);
    };
    for (const Entry& entry : entries) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        around[axis] = std::min(around[axis], centre(entry, axis));
        around[axis + 3] = std::min(around[axis + 3], -centre(entry, axis));
      }
    }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
      longest = around[axis] + around[axis + 3] < around[longest] + around[longest + 3] ? axis : longest;
    }
    std::size_t unit = fill;
    while (unit * fill < entries.size()) {
      unit *= fill;
    }
    const std::size_t units = (entries.size() + unit - 1) / unit;
    const std::size_t cut = units / 2 * unit;
    std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(cut), entries.end(),
                     [&](const Entry& a, const Entry& b) {
                       const float at_a = centre(a, longest), at_b = centre(b, longest);
                       return at_a < at_b || (at_a == at_b && a.child < b.child);
                     });
    put_in_order_of_space(entries.first(cut), fill);
    entries = entries.subspan(cut);
  }
}

// From the leaves in the scratch. `fill`: of the children that a node gets.
void BoxTree::build(std::size_t fill) {
  put_in_order_of_space(entries_, fill);
  nodes_.clear();
  links_.clear();
  free_ = none;
  // Level by level; each becomes the entries of the next.
  for (std::uint8_t level = 0;; ++level) {
    std::size_t above = 0;
    for (std::size_t begin = 0; begin < entries_.size() || begin == 0; begin += fill) {
      const std::size_t count = std::min(fill, entries_.size() - begin);
      const std::uint32_t node = make_node(level);
      for (std::size_t lane = 0; lane < count; ++lane) {
        set_lane(node, lane, entries_[begin + lane]);
      }
      links_[node].count = static_cast<std::uint8_t>(count);
      root_ = node;
      if (count > 0) {
        entries_[above++] = {nodes_[node].sides_around(), node};
      }
    }
    entries_.resize(above);
    if (above <= 1) {
      break;
    }
  }
}

BoxTree::BoxTree(std::span<const CompactAabb> boxes) : places_(boxes.size()), size_(boxes.size()) {
  entries_.reserve(boxes.size());
  for (const CompactAabb& box : boxes) {
    entries_.push_back({sides_of(box), static_cast<std::uint32_t>(entries_.size()) | leaf_bit});
  }
  build(width);
  std::vector<Entry>().swap(entries_);
}

void BoxTree::tidy() {
  if (changes_ < least_changes + most_changes_of_each * size_ && links_[root_].level < most_levels / 2) {
    return;
  }
  const bool are_all_new = changes_ >= changes_of_new * size_;
  changes_ = 0;
  entries_.clear();
  entries_.reserve(size_);
  std::array<std::uint32_t, most_waiting> waiting;
  waiting[0] = root_;
  std::size_t count_waiting = 1;
  while (count_waiting > 0) {
    const std::uint32_t node = waiting[--count_waiting];
    for (std::size_t lane = 0; lane < links_[node].count; ++lane) {
      const std::uint32_t child = nodes_[node].numbers[lane];
      if (is_leaf(child)) {
        entries_.push_back({nodes_[node].sides_of_lane(lane), child});
      } else {
        waiting[count_waiting++] = child;
      }
    }
  }
  build(usual_fill);
  if (are_all_new && size_ >= many_leaves) {
    std::vector<Entry>().swap(entries_);
  }
}

}  // namespace abut
