// SPDX-License-Identifier: Apache-2.0
module abut.trees.grids.box_grid;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {
namespace {

Real largest_side(const CompactAabb& box) {
  Real side = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    side = std::max(side, static_cast<Real>(box.high[axis]) - static_cast<Real>(box.low[axis]));
  }
  return side;
}

}  // namespace

// Points count as the least size that has a normal float.
std::int32_t BoxGrid::exponent_of(const CompactAabb& box) { return std::max(-126, std::ilogb(largest_side(box))); }

// The finest cells are of twice this size, so that boxes of up to about twice the mean size fit.
void BoxGrid::set_cells(std::int32_t exponent) {
  cell_exponent_ = exponent;
  for (std::uint32_t level = 0; level < level_count; ++level) {
    cells_per_unit_[level] = std::ldexp(1.0, -(exponent + 1 + 2 * static_cast<std::int32_t>(level)));
  }
}

std::uint64_t BoxGrid::key_of_box(const CompactAabb& box) const {
  // A little more than the side, so that rounding of centres cannot leave the reach of half a cell.
  const Real side = largest_side(box) * (1 + 1e-9);
  std::uint32_t level = 0;
  while (level + 1 < level_count && side * cells_per_unit_[level] > 1) {
    ++level;
  }
  Cell cell{};
  for (std::size_t axis = 0; axis < 3 && level + 1 < level_count; ++axis) {
    cell[axis] = coordinate(level, 0.5 * (static_cast<Real>(box.low[axis]) + static_cast<Real>(box.high[axis])));
  }
  return key_of(level, cell);
}

void BoxGrid::resize_slots(std::size_t count) {
  old_slots_.swap(slots_);
  slots_.assign(count, {});
  slot_shift_ = 64 - static_cast<std::uint32_t>(std::countr_zero(count));
  slot_count_ = 0;
  for (const Slot& slot : old_slots_) {
    if (slot.first != none) {
      slots_[make_slot(slot.key)].first = slot.first;
    }
  }
  old_slots_.clear();
}

// Where the key is, or comes. At most half of the table is in use.
std::size_t BoxGrid::make_slot(std::uint64_t key) {
  std::size_t at = slot_of(key);
  while (slots_[at].first != none && slots_[at].key != key) {
    at = (at + 1) & (slots_.size() - 1);
  }
  if (slots_[at].first == none) {
    if (2 * (slot_count_ + 1) > slots_.size()) {
      resize_slots(2 * slots_.size());
      return make_slot(key);
    }
    slots_[at].key = key;
    ++slot_count_;
  }
  return at;
}

// Those behind it that would not be found any more move up (Knuth, volume 3, 6.4, algorithm R).
void BoxGrid::free_slot(std::size_t slot) {
  const std::size_t mask = slots_.size() - 1;
  --slot_count_;
  slots_[slot].first = none;
  for (std::size_t at = (slot + 1) & mask; slots_[at].first != none; at = (at + 1) & mask) {
    if (((at - slot_of(slots_[at].key)) & mask) >= ((at - slot) & mask)) {
      slots_[slot] = std::exchange(slots_[at], {});
      slot = at;
    }
  }
}

void BoxGrid::set_lane(std::uint32_t block, std::size_t lane, std::uint32_t leaf, const BoxSides& sides) {
  blocks_[block].set_sides(lane, sides);
  blocks_[block].numbers[lane] = leaf;
  places_[leaf] = block * width + static_cast<std::uint32_t>(lane);
}

void BoxGrid::add(std::uint64_t key, std::uint32_t leaf, const BoxSides& sides) {
  const std::size_t slot = make_slot(key);
  std::uint32_t first = slots_[slot].first;
  if (first == none || links_[first].count == width) {
    std::uint32_t block = free_;
    if (block != none) {
      free_ = links_[block].next;
      blocks_[block] = {};
    } else {
      block = static_cast<std::uint32_t>(blocks_.size());
      blocks_.emplace_back();
      links_.emplace_back();
    }
    links_[block] = {key, first, 0};
    slots_[slot].first = first = block;
  }
  set_lane(first, links_[first].count++, leaf, sides);
  ++sizes_[level_of_key(key)];
}

void BoxGrid::take_out(std::uint32_t leaf) {
  const std::uint32_t block = places_[leaf] / width;
  const std::size_t lane = places_[leaf] % width;
  const std::uint64_t key = links_[block].key;
  const std::size_t slot = make_slot(key);
  const std::uint32_t first = slots_[slot].first;
  const std::size_t last = --links_[first].count;
  if (first != block || lane != last) {
    set_lane(block, lane, blocks_[first].numbers[last], blocks_[first].sides_of_lane(last));
  }
  blocks_[first].set_sides(last, no_sides);
  if (last == 0) {
    slots_[slot].first = links_[first].next;
    links_[first].next = free_;
    free_ = first;
    if (slots_[slot].first == none) {
      free_slot(slot);
    }
  }
  --sizes_[level_of_key(key)];
}

void BoxGrid::insert(std::uint32_t leaf, const CompactAabb& box) {
  if (leaf >= places_.size()) {
    places_.resize(std::size_t{leaf} + 1, 0);
  }
  const std::int32_t exponent = exponent_of(box);
  if (size_ == 0) {
    set_cells(exponent);
  }
  ++size_;
  exponent_sum_ += exponent;
  add(key_of_box(box), leaf, sides_of(box));
}

void BoxGrid::erase(std::uint32_t leaf) {
  const BoxSides s = blocks_[places_[leaf] / width].sides_of_lane(places_[leaf] % width);
  exponent_sum_ -= exponent_of(box_of(s));
  take_out(leaf);
  --size_;
}

bool BoxGrid::moved_in_place(std::uint32_t leaf, const CompactAabb& box) {
  const std::uint32_t block = places_[leaf] / width;
  const BoxSides s = blocks_[block].sides_of_lane(places_[leaf] % width);
  if (links_[block].key != key_of_box(box) || exponent_of(box_of(s)) != exponent_of(box)) {
    return false;
  }
  blocks_[block].set_sides(places_[leaf] % width, sides_of(box));
  return true;
}

void BoxGrid::move(std::uint32_t leaf, const CompactAabb& box) {
  if (!moved_in_place(leaf, box)) {
    erase(leaf);
    insert(leaf, box);
  }
}

void BoxGrid::tidy() {
  if (size_ == 0) {
    return;
  }
  const auto mean = static_cast<std::int32_t>(std::lround(static_cast<Real>(exponent_sum_) / static_cast<Real>(size_)));
  if (std::abs(mean - cell_exponent_) < 2) {
    return;
  }
  set_cells(mean);
  std::vector<EightBoxes> blocks;
  std::vector<Link> links;
  blocks.swap(blocks_);
  links.swap(links_);
  free_ = none;
  sizes_ = {};
  slots_.assign(slots_.size(), {});
  slot_count_ = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block) {
    for (std::size_t lane = 0; lane < links[block].count; ++lane) {
      const BoxSides s = blocks[block].sides_of_lane(lane);
      add(key_of_box(box_of(s)), blocks[block].numbers[lane], s);
    }
  }
}

}  // namespace abut
