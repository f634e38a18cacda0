// SPDX-License-Identifier: Apache-2.0
// Contacts in the order of their depths, the deepest one first.
export module abut.narrow.manifold.depth_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

[[nodiscard]] inline bool comes_before(const ContactPoint& a, const ContactPoint& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

// The places of some contacts, or of some points of a patch.
using PlaceList = SmallVector<std::uint32_t, 256>;

// What contacts are put in order by.
struct DepthKey {
  Real distance;
  std::uint64_t id;
  std::uint32_t place;
};

// Puts a few keys in the order of their distances: how many are less tells the place of each. False, with nothing done,
// where there are many, or where two tie.
[[nodiscard]] inline bool sort_by_rank(std::span<DepthKey> keys) {
  constexpr std::size_t most = 128;
  if (keys.size() > most) {
    return false;
  }
  [[clang::uninitialized]] std::array<Lanes, most / 4> distances;
  const std::size_t groups = (keys.size() + 3) / 4;
  for (std::size_t i = 0; i < 4 * groups; ++i) {
    distances[i / 4][i % 4] = i < keys.size() ? keys[i].distance : infinity;
  }
  [[clang::uninitialized]] std::array<DepthKey, most> sorted;
  std::array<bool, most> taken{};
  for (const DepthKey& key : keys) {
    LaneNumbers less = 0;
    for (std::size_t group = 0; group < groups; ++group) {
      less -= distances[group] < all_lanes(key.distance);
    }
    const auto rank = static_cast<std::size_t>(less[0] + less[1] + less[2] + less[3]);
    if (taken[rank]) {
      return false;
    }
    taken[rank] = true;
    sorted[rank] = key;
  }
  std::ranges::copy(std::span(sorted).first(keys.size()), keys.begin());
  return true;
}

// The places of all contacts in the order of `comes_before`. Contacts are large: small keys are sorted.
[[nodiscard]] inline PlaceList places_by_depth(std::span<const ContactPoint> contacts) {
  [[clang::uninitialized]] SmallVector<DepthKey, 256> keys;
  for (std::uint32_t place = 0; place < contacts.size(); ++place) {
    keys.push_back({contacts[place].distance, contacts[place].id, place});
  }
  if (!sort_by_rank(keys.span())) {
    std::ranges::sort(keys.span(), [](const DepthKey& a, const DepthKey& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.id != b.id ? a.id < b.id : a.place < b.place;
    });
  }
  [[clang::uninitialized]] PlaceList places;
  for (const DepthKey& key : keys.span()) {
    places.push_back(key.place);
  }
  return places;
}

// Brings the contacts at some places to the front, in the order of the places, which are used up. Each contact moves
// once.
inline void bring_to_front(std::span<ContactPoint> contacts, std::span<std::uint32_t> places) {
  for (std::uint32_t to = 0; to < places.size(); ++to) {
    const std::uint32_t from = places[to];
    if (from == to) {
      continue;
    }
    std::swap(contacts[to], contacts[from]);
    // What was here may be wanted later.
    for (std::uint32_t& place : places.subspan(to + 1)) {
      place = place == to ? from : place;
    }
  }
}

// Puts contacts into the order of `comes_before`. Of very many, which are rare, no list of keys is made: that would
// take memory from step to step.
inline void sort_by_depth(std::span<ContactPoint> contacts) {
  constexpr std::size_t most_keys = 256;
  if (contacts.size() > most_keys) {
    std::ranges::sort(contacts, comes_before);
    return;
  }
  [[clang::uninitialized]] PlaceList places = places_by_depth(contacts);
  bring_to_front(contacts, places.span());
}

}  // namespace abut
