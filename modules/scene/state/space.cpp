// SPDX-License-Identifier: Apache-2.0
module abut.scene.state.space;
import abut.broadphase;
import abut.core.standard;
import abut.core.workers;
import abut.math;
import abut.scene.state.places;

namespace abut {
namespace {

AnyBroadPhase make_broadphase(BroadphaseKind kind) {
  switch (kind) {
    case BroadphaseKind::tree: return Tree();
    case BroadphaseKind::sweep_and_prune: return SweepAndPrune();
    case BroadphaseKind::hash_grid: return Grid();
    case BroadphaseKind::automatic:
    case BroadphaseKind::brute: break;
  }
  return Brute();
}

}  // namespace

void Space::join(const Places& places, std::uint32_t place) {
  const PlaceInfo& info = places.infos[place];
  seats_[place].is_moving = info.is_dynamic;
  moving_count_ += info.is_dynamic ? 1 : 0;
  const Mobility mobility = info.is_dynamic ? Mobility::moving : Mobility::still;
  std::visit([&](auto& its) { its.insert(place, places.boxes[place], mobility, info.part.slot); }, broadphase_);
}

void Space::leave(std::uint32_t place) {
  if (place < seats_.size() && seats_[place].presence != Presence::absent) {
    std::visit([&](auto& its) { its.erase(place); }, broadphase_);
    moving_count_ -= seats_[place].is_moving ? 1 : 0;
    seats_[place] = {};
    has_changed_ = true;
  }
}

void Space::hide(std::uint32_t place) {
  if (seats_[place].presence == Presence::shown) {
    std::visit([&](auto& its) { its.hide(place); }, broadphase_);
    seats_[place].presence = Presence::hidden;
    has_changed_ = true;
  }
}

// Makes another broad phase when the scene asks for it, with what the present one holds.
void Space::choose(const Places& places, BroadphaseKind wanted, std::span<const std::uint32_t> queue) {
  reason_ = "as asked for";
  if (wanted == BroadphaseKind::automatic) {
    const auto is_joining = [&](std::uint32_t at) { return seats_[at].presence == Presence::absent; };
    const auto joining = static_cast<std::size_t>(std::ranges::count_if(queue, is_joining));
    const auto present = std::visit([](const auto& its) { return its.size(); }, broadphase_) + joining;
    const BroadphaseChoice choice = choose_broadphase({.present = present, .moving = moving_count_ + joining}, kind_);
    wanted = choice.kind;
    reason_ = text_of(choice.reason);
  }
  if (std::exchange(kind_, wanted) == wanted) {
    return;
  }
  broadphase_ = make_broadphase(kind_);
  join_all(places);
}

// Into a broad phase that is empty.
void Space::join_all(const Places& places) {
  has_changed_ = true;
  moving_count_ = 0;
  for (std::uint32_t at = 0; at < seats_.size(); ++at) {
    if (seats_[at].presence != Presence::absent) {
      join(places, at);
      if (seats_[at].presence == Presence::hidden) {
        std::visit([&](auto& its) { its.hide(at); }, broadphase_);
      }
    }
  }
}

std::vector<std::uint8_t> Space::presences() const {
  std::vector<std::uint8_t> numbers(seats_.size());
  for (std::size_t at = 0; at < seats_.size(); ++at) {
    numbers[at] = static_cast<std::uint8_t>(seats_[at].presence);
  }
  return numbers;
}

void Space::restore(const Workers& workers, const Places& places, BroadphaseKind kind,
                    std::span<const std::uint8_t> presences) {
  kind_ = kind;
  reason_ = "as it was saved";
  broadphase_ = make_broadphase(kind);
  seats_.assign(presences.size(), {});
  for (std::size_t at = 0; at < presences.size(); ++at) {
    seats_[at].presence = static_cast<Presence>(presences[at]);
  }
  join_all(places);
  std::visit([&](auto& its) { its.update_all(workers, std::span<const std::uint32_t>(), places.boxes); }, broadphase_);
}

void Space::update(const Workers& workers, const Places& places, BroadphaseKind wanted,
                   std::span<const std::uint32_t> rejoining, std::span<const std::uint32_t> queue) {
  for (const std::uint32_t at : rejoining) {
    leave(at);
  }
  if (queue.empty() && !has_changed_) {
    return;
  }
  choose(places, wanted, queue);
  updates_.clear();
  for (const std::uint32_t at : queue) {
    const Presence before = std::exchange(seats_[at].presence, Presence::shown);
    if (before == Presence::shown) {
      updates_.push_back(at);
    } else if (before == Presence::hidden) {
      std::visit([&](auto& its) { its.show(at, places.boxes[at]); }, broadphase_);
    } else {
      join(places, at);
    }
  }
  std::visit([&](auto& its) { its.update_all(workers, updates_, places.boxes); }, broadphase_);
  has_changed_ = true;
}

void Space::find_pairs(const Workers& workers, std::vector<ProxyPair>& out) {
  std::visit([&](auto& its) { its.find_pairs(workers, out); }, broadphase_);
}

std::size_t Space::bytes() const {
  return std::visit([](const auto& its) { return its.bytes(); }, broadphase_) + seats_.capacity() * sizeof(Seat) +
         updates_.capacity() * sizeof(std::uint32_t);
}

}  // namespace abut
