// SPDX-License-Identifier: Apache-2.0
module abut.trees.boxes.box_tree;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {
namespace {

// Nodes of leaves with fewer are given up, their leaves put elsewhere.
constexpr std::size_t least_fill = 3;

}  // namespace

// What the chance of being visited is proportional to (Goldsmith and Salmon, "Automatic creation of object hierarchies
// for ray tracing", 1987).
inline float BoxTree::half_surface(const BoxSides& box) {
  // Minus the lengths of the edges; the signs cancel in the products.
  const float x = box[0] + box[3], y = box[1] + box[4], z = box[2] + box[5];
  return x * y + y * z + z * x;
}

void BoxTree::set_lane(std::uint32_t node, std::size_t lane, const Entry& entry) {
  nodes_[node].set_sides(lane, entry.sides);
  nodes_[node].numbers[lane] = entry.child;
  if (is_leaf(entry.child)) {
    places_[entry.child & ~leaf_bit] = node * width + static_cast<std::uint32_t>(lane);
  } else if (entry.child != none) {
    links_[entry.child].parent = node;
    links_[entry.child].lane = static_cast<std::uint8_t>(lane);
  }
}

std::uint32_t BoxTree::make_node(std::uint8_t level) {
  std::uint32_t node = free_;
  if (node != none) {
    free_ = links_[node].parent;
    nodes_[node] = {};
  } else {
    node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    links_.emplace_back();
  }
  links_[node] = {none, 0, 0, level};
  return node;
}

void BoxTree::free_node(std::uint32_t node) {
  links_[node].parent = free_;
  free_ = node;
}

// The child whose surface grows least; of several the smallest.
std::size_t BoxTree::cheapest_lane(const EightBoxes& node, std::size_t count, const BoxSides& sides) const {
  std::array<EightBoxes::Floats, 3> present, whole;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const EightBoxes::Floats low = node.side(axis), high = node.side(axis + 3);
    present[axis] = low + high;
    whole[axis] = (low < sides[axis] ? low : EightBoxes::Floats(sides[axis])) +
                  (high < sides[axis + 3] ? high : EightBoxes::Floats(sides[axis + 3]));
  }
  const EightBoxes::Floats before = present[0] * present[1] + present[1] * present[2] + present[2] * present[0];
  const EightBoxes::Floats growth = whole[0] * whole[1] + whole[1] * whole[2] + whole[2] * whole[0] - before;
  std::size_t best = 0;
  for (std::size_t lane = 1; lane < count; ++lane) {
    if (growth[lane] < growth[best] || (growth[lane] == growth[best] && before[lane] < before[best])) {
      best = lane;
    }
  }
  return best;
}

void BoxTree::insert(std::uint32_t leaf, const CompactAabb& box) {
  if (leaf >= places_.size()) {
    places_.resize(std::size_t{leaf} + 1, 0);
  }
  ++size_;
  changes_ += changes_of_new;
  insert_below(root_, {sides_of(box), leaf | leaf_bit});
}

// The boxes above the node are around the entry already.
void BoxTree::insert_below(std::uint32_t node, const Entry& entry) {
  while (links_[node].level > 0) {
    const std::size_t lane = cheapest_lane(nodes_[node], links_[node].count, entry.sides);
    nodes_[node].set_sides(lane, merged(nodes_[node].sides_of_lane(lane), entry.sides));
    node = nodes_[node].numbers[lane];
  }
  add(node, entry);
}

// The boxes above the node are around the entry already.
void BoxTree::add(std::uint32_t node, const Entry& entry) {
  Link& link = links_[node];
  if (link.count < width) {
    set_lane(node, link.count++, entry);
  } else {
    split(node, entry);
  }
}

// Both halves have at least three children. Of all cuts along the axes it takes the one with the least surfaces,
// counted once for each child.
void BoxTree::split(std::uint32_t node, const Entry& entry) {
  std::array<Entry, width + 1> best{}, sorted{};
  for (std::size_t lane = 0; lane < width; ++lane) {
    sorted[lane] = {nodes_[node].sides_of_lane(lane), nodes_[node].numbers[lane]};
  }
  sorted[width] = entry;
  std::size_t best_cut = 0;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::sort(sorted.begin(), sorted.end(), [&](const Entry& a, const Entry& b) {
      return a.sides[axis] - a.sides[axis + 3] < b.sides[axis] - b.sides[axis + 3];
    });
    std::array<float, width + 2> costs_of_first{};
    BoxSides around = sorted.front().sides;
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      around = merged(around, sorted[i].sides);
      costs_of_first[i + 1] = half_surface(around) * static_cast<float>(i + 1);
    }
    around = sorted.back().sides;
    for (std::size_t cut = sorted.size() - 1; cut >= least_fill; --cut) {
      around = merged(around, sorted[cut].sides);
      const std::size_t rest = sorted.size() - cut;
      const float cost = costs_of_first[cut] + half_surface(around) * static_cast<float>(rest);
      if (rest >= least_fill && (best_cut == 0 || cost < least)) {
        least = cost;
        best_cut = cut;
        best = sorted;
      }
    }
  }
  const std::uint8_t level = links_[node].level;
  const std::uint32_t other = make_node(level);
  const std::uint32_t parent = links_[node].parent;
  const std::uint8_t lane_in_parent = links_[node].lane;
  nodes_[node] = {};
  const auto fill = [&](std::uint32_t to, std::span<const Entry> entries) {
    for (std::size_t lane = 0; lane < entries.size(); ++lane) {
      set_lane(to, lane, entries[lane]);
    }
    links_[to].count = static_cast<std::uint8_t>(entries.size());
  };
  fill(node, std::span<const Entry>(best).first(best_cut));
  fill(other, std::span<const Entry>(best).subspan(best_cut));
  const Entry first{nodes_[node].sides_around(), node}, second{nodes_[other].sides_around(), other};
  if (parent == none) {
    root_ = make_node(static_cast<std::uint8_t>(level + 1));
    fill(root_, std::array{first, second});
  } else {
    set_lane(parent, lane_in_parent, first);
    add(parent, second);
  }
}

// Fits the boxes above a node whose children have changed.
void BoxTree::fit_from(std::uint32_t node) {
  for (std::uint32_t parent = links_[node].parent; parent != none; parent = links_[node].parent) {
    const std::size_t lane = links_[node].lane;
    const BoxSides sides = nodes_[node].sides_around();
    if (sides == nodes_[parent].sides_of_lane(lane)) {
      return;
    }
    nodes_[parent].set_sides(lane, sides);
    node = parent;
  }
}

// The last child takes the place of the one that goes.
void BoxTree::take_out(std::uint32_t node, std::size_t lane) {
  const std::size_t last = --links_[node].count;
  if (lane != last) {
    set_lane(node, lane, {nodes_[node].sides_of_lane(last), nodes_[node].numbers[last]});
  }
  set_lane(node, last, {no_sides, none});
}

void BoxTree::erase(std::uint32_t leaf) {
  take_away(leaf);
  --size_;
  ++changes_;
}

void BoxTree::take_away(std::uint32_t leaf) {
  std::uint32_t node = places_[leaf] / width;
  take_out(node, places_[leaf] % width);
  if (links_[node].count >= least_fill || node == root_) {
    fit_from(node);
    return;
  }
  // The rest of the node goes elsewhere, and what is empty above goes with it.
  std::array<Entry, least_fill> rest{};
  const std::size_t count = links_[node].count;
  for (std::size_t lane = 0; lane < count; ++lane) {
    rest[lane] = {nodes_[node].sides_of_lane(lane), nodes_[node].numbers[lane]};
  }
  links_[node].count = 0;
  while (links_[node].count == 0 && node != root_) {
    const std::uint32_t parent = links_[node].parent;
    take_out(parent, links_[node].lane);
    free_node(node);
    node = parent;
  }
  fit_from(node);
  if (links_[node].count == 0) {
    links_[node].level = 0;
  }
  while (links_[root_].level > 0 && links_[root_].count == 1) {
    const std::uint32_t child = nodes_[root_].numbers[0];
    free_node(root_);
    root_ = child;
    links_[root_].parent = none;
  }
  for (const Entry& entry : std::span(rest).first(count)) {
    insert_below(root_, entry);
  }
}

// Everything is inside the root.
inline bool BoxTree::is_inside(std::uint32_t node, const BoxSides& sides) const {
  const Link& link = links_[node];
  if (link.parent == none) {
    return true;
  }
  const BoxSides around = nodes_[link.parent].sides_of_lane(link.lane);
  return merged(around, sides) == around;
}

bool BoxTree::moved_in_place(std::uint32_t leaf, const CompactAabb& box) {
  const BoxSides sides = sides_of(box);
  const std::uint32_t node = places_[leaf] / width;
  if (!is_inside(node, sides)) {
    return false;
  }
  nodes_[node].set_sides(places_[leaf] % width, sides);
  return true;
}

// Mostly it goes not far: the way down begins at the lowest node whose box is around the new one.
void BoxTree::move_elsewhere(std::uint32_t leaf, const CompactAabb& box) {
  const Entry entry{sides_of(box), leaf | leaf_bit};
  const std::uint32_t node = places_[leaf] / width;
  if (links_[node].count <= least_fill) {
    take_away(leaf);
    insert_below(root_, entry);
  } else {
    std::uint32_t above = node;
    while (!is_inside(above, entry.sides)) {
      above = links_[above].parent;
    }
    take_out(node, places_[leaf] % width);
    insert_below(above, entry);
    fit_from(node);
  }
  changes_ += places_[leaf] / width == node ? 1 : 2;
}

std::uint32_t BoxTree::leaf_near(const std::array<float, 3>& point) const {
  std::uint32_t at = root_;
  while (!is_leaf(at)) {
    const EightBoxes& node = nodes_[at];
    EightBoxes::Floats square(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const EightBoxes::Floats below = node.side(axis) - point[axis], above = point[axis] + node.side(axis + 3);
      const EightBoxes::Floats beyond = below > above ? below : above;
      square += beyond > 0.0f ? beyond * beyond : EightBoxes::Floats(0.0f);
    }
    std::size_t nearest = 0;
    for (std::size_t lane = 1; lane < links_[at].count; ++lane) {
      nearest = square[lane] < square[nearest] ? lane : nearest;
    }
    at = node.numbers[nearest];
  }
  return at & ~leaf_bit;
}

}  // namespace abut
