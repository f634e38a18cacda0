// SPDX-License-Identifier: Apache-2.0
module;
#include "../core/check.hpp"
module abut.broadphase.brute;
import abut.broadphase.proxy;
import abut.core.standard;
import abut.core.workers;
import abut.core;
import abut.math;
import abut.trees.volumes.eight_boxes;

namespace abut {

// Of the first box whose number is not less.
std::size_t Brute::place_of(std::uint32_t proxy) const {
  std::size_t low = 0, high = size_;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (proxy_at(middle) < proxy) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

Brute::Entry Brute::entry_at(std::size_t place) const {
  const Block& block = blocks_[place / width];
  const std::size_t lane = place % width;
  const auto has = [&](std::uint32_t mask) { return (mask >> lane & 1) != 0; };
  return {block.boxes.sides_of_lane(lane), block.boxes.numbers[lane], std::bit_cast<std::uint32_t>(block.groups[lane]),
          has(block.moving), has(block.shown)};
}

void Brute::set_shown(std::size_t place, bool is_shown, const BoxSides& sides) {
  Block& block = blocks_[place / width];
  const std::size_t lane = place % width;
  block.boxes.set_sides(lane, is_shown ? sides : no_sides);
  block.shown = (block.shown & ~(1u << lane)) | (is_shown ? 1u << lane : 0);
}

void Brute::set_entry(std::size_t place, const Entry& entry) {
  Block& block = blocks_[place / width];
  const std::size_t lane = place % width;
  block.boxes.numbers[lane] = entry.proxy;
  block.groups[lane] = std::bit_cast<std::int32_t>(entry.group);
  block.moving = (block.moving & ~(1u << lane)) | (entry.is_moving ? 1u << lane : 0);
  set_shown(place, entry.is_shown, entry.sides);
}

void Brute::insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place == size_ || proxy_at(place) != proxy);
  if (size_ == blocks_.size() * width) {
    blocks_.emplace_back();
  }
  for (std::size_t i = size_++; i > place; --i) {
    set_entry(i, entry_at(i - 1));
  }
  set_entry(place, {sides_of(box), proxy, group, mobility == Mobility::moving, true});
}

void Brute::erase(std::uint32_t proxy) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place < size_ && proxy_at(place) == proxy);
  hidden_ -= entry_at(place).is_shown ? 0 : 1;
  --size_;
  for (std::size_t i = place; i < size_; ++i) {
    set_entry(i, entry_at(i + 1));
  }
  set_entry(size_, {no_sides, 0, 0, false, false});
  if (size_ % width == 0) {
    blocks_.pop_back();
  }
}

void Brute::update(std::uint32_t proxy, const CompactAabb& box) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place < size_ && proxy_at(place) == proxy);
  blocks_[place / width].boxes.set_sides(place % width, sides_of(box));
}

void Brute::update_all(const Workers&, std::span<const std::uint32_t> proxies,
                       std::span<const CompactAabb> boxes_by_proxy) {
  for (const std::uint32_t proxy : proxies) {
    update(proxy, boxes_by_proxy[proxy]);
  }
}

void Brute::hide(std::uint32_t proxy) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place < size_ && proxy_at(place) == proxy);
  set_shown(place, false, no_sides);
  ++hidden_;
}

void Brute::show(std::uint32_t proxy, const CompactAabb& box) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place < size_ && proxy_at(place) == proxy);
  set_shown(place, true, sides_of(box));
  --hidden_;
}

// Each box of a block against those after it.
void Brute::find_pairs_of(std::size_t first_block, std::vector<ProxyPair>& out) const {
  const Block& first = blocks_[first_block];
  for (std::uint32_t shown = first.shown; shown != 0; shown &= shown - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(shown));
    const bool is_moving = (first.moving >> lane & 1) != 0;
    const BoxSides s = first.boxes.sides_of_lane(lane);
    const BoxSides limits = limits_of({{s[0], s[1], s[2]}, {-s[3], -s[4], -s[5]}});
    const EightBoxes::Numbers group(first.groups[lane]);
    std::uint32_t after = 0xfeu << lane;
    for (std::size_t b = first_block; b < blocks_.size(); ++b) {
      const Block& block = blocks_[b];
      std::uint32_t met = block.boxes.overlapping(limits) & after & (is_moving ? 0xffu : block.moving);
      after = 0xff;
      if (met != 0) {
        met &= ~EightBoxes::mask_of(block.groups == group);
        for (; met != 0; met &= met - 1) {
          out.push_back(
              {first.boxes.numbers[lane], block.boxes.numbers[static_cast<std::size_t>(std::countr_zero(met))]});
        }
      }
    }
  }
}

void Brute::find_pairs(std::vector<ProxyPair>& out) {
  out.clear();
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    find_pairs_of(block, out);
  }
}

void Brute::find_pairs(const Workers& workers, std::vector<ProxyPair>& out) {
  // Eight boxes against as many as make a task worth its start.
  constexpr std::size_t least_blocks = 32;
  if (workers.threads() == 1 || blocks_.size() < least_blocks) {
    find_pairs(out);
    return;
  }
  if (parts_.size() < blocks_.size()) {
    parts_.resize(blocks_.size());
  }
  workers.for_each(blocks_.size(), [&](std::size_t block) {
    parts_[block].clear();
    find_pairs_of(block, parts_[block]);
  });
  out.clear();
  for (const std::vector<ProxyPair>& part : std::span(parts_).first(blocks_.size())) {
    out.insert(out.end(), part.begin(), part.end());
  }
}

std::size_t Brute::bytes() const {
  std::size_t sum = blocks_.capacity() * sizeof(Block);
  for (const std::vector<ProxyPair>& part : parts_) {
    sum += sizeof part + part.capacity() * sizeof(ProxyPair);
  }
  return sum;
}

}  // namespace abut
