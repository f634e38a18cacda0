// SPDX-License-Identifier: Apache-2.0
module abut.detect.lists.islands;
import abut.core;
import abut.core.standard;
import abut.scene.state.options;

namespace abut {

void IslandLinks::start(std::uint32_t highest) {
  for (const std::uint32_t slot : joined_) {
    parents_[slot - 1] = slot;
  }
  joined_.clear();
  for (auto slot = static_cast<std::uint32_t>(parents_.size()); slot < highest; ++slot) {
    parents_.push_back(slot + 1);
  }
}

void IslandLinks::join(std::uint32_t slot_a, std::uint32_t slot_b) {
  const auto [low, high] = std::minmax({root_of(slot_a), root_of(slot_b)});
  if (low != high) {
    parents_[high - 1] = low;
    joined_.push_back(high);
  }
}

std::uint32_t IslandLinks::root_of(std::uint32_t slot) {
  while (parents_[slot - 1] != slot) {
    parents_[slot - 1] = parents_[parents_[slot - 1] - 1];
    slot = parents_[slot - 1];
  }
  return slot;
}

// A parent is lower than its child, so that its own root is known when the child is looked at.
std::span<const std::uint32_t> IslandLinks::lowest_slots() {
  for (std::uint32_t& parent : parents_) {
    parent = parents_[parent - 1];
  }
  return parents_;
}

void IslandList::number(std::span<const PartId> parts, IslandLinks& links) {
  islands_.swap(islands_before_);
  seats_.swap(seats_before_);
  group(parts, links);
  inherit();
}

// A root is the lowest slot of its island, so that it comes before the other parts.
void IslandList::group(std::span<const PartId> parts, IslandLinks& links) {
  islands_.clear();
  seats_.assign(parts.empty() ? 0 : parts.back().slot, Seat{});
  for (const PartId& part : parts) {
    const std::uint32_t root = links.root_of(part.slot);
    if (root == part.slot) {
      seats_[root - 1].island = static_cast<std::uint32_t>(islands_.size());
      islands_.push_back({0, 0, 0});
    }
    const std::uint32_t island = seats_[root - 1].island;
    seats_[part.slot - 1] = {part.generation, island};
    ++islands_[island].count;
  }
  std::uint32_t first = 0;
  for (Island& island : islands_) {
    island.first = std::exchange(first, first + std::exchange(island.count, 0));
  }
  parts_.resize(parts.size());
  for (const PartId& part : parts) {
    Island& island = islands_[seats_[part.slot - 1].island];
    parts_[island.first + island.count++] = part;
  }
}

void IslandList::inherit() {
  is_inherited_.assign(islands_before_.size(), false);
  const std::size_t slots = std::min(seats_.size(), seats_before_.size());
  for (std::size_t i = 0; i < slots; ++i) {
    const Seat &seat = seats_[i], &before = seats_before_[i];
    const bool is_same_part = seat.island != none && before.island != none && seat.generation == before.generation;
    if (!is_same_part || is_inherited_[before.island]) {
      continue;
    }
    is_inherited_[before.island] = true;
    const std::uint64_t heritage = islands_before_[before.island].id;
    std::uint64_t& id = islands_[seat.island].id;
    id = id == 0 ? heritage : std::min(id, heritage);
  }
  for (Island& island : islands_) {
    island.id = island.id == 0 ? next_id_++ : island.id;
  }
}

void IslandList::clear() {
  islands_.clear();
  parts_.clear();
  seats_.clear();
}

bool IslandList::is_whole() const {
  const auto is_island = [&](const Island& its) {
    return its.id != 0 && its.id < next_id_ && its.first <= parts_.size() && its.count <= parts_.size() - its.first;
  };
  return std::ranges::all_of(islands_, is_island) && std::ranges::all_of(seats_, [&](const Seat& seat) {
           return seat.island == none || seat.island < islands_.size();
         });
}

std::optional<Island> IslandList::of(PartId part) const {
  if (part.slot == 0 || part.slot > seats_.size()) {
    return std::nullopt;
  }
  const Seat& seat = seats_[part.slot - 1];
  return seat.island != none && seat.generation == part.generation ? std::optional(islands_[seat.island])
                                                                   : std::nullopt;
}

std::size_t IslandList::bytes() const {
  return (islands_.capacity() + islands_before_.capacity()) * sizeof(Island) + parts_.capacity() * sizeof(PartId) +
         (seats_.capacity() + seats_before_.capacity()) * sizeof(Seat) + is_inherited_.capacity() / 8;
}

}  // namespace abut
