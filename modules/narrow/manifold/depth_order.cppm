// SPDX-License-Identifier: Apache-2.0
// Contacts in the order of their depth. They are large: their numbers are put in order, and each contact moves once.
export module abut.narrow.manifold.depth_order;
import abut.capability;
import abut.core.small_vector;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.places_in_order;

export namespace abut {

// Up to so many contacts need no memory of the heap.
inline constexpr std::size_t few_contacts = 256;

// Numbers of contacts, or ranks of theirs.
using Numbers = SmallVector<std::uint32_t, few_contacts>;

[[nodiscard]] inline bool comes_before(const ContactPoint& a, const ContactPoint& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

// How many distances are less tells the place of each, of a few. Equal ones are put in order afterwards. False, with
// nothing to keep, where a distance is no number.
[[nodiscard]] inline bool rank_few(std::span<const ContactPoint> contacts, std::span<std::uint32_t> numbers) {
  [[clang::uninitialized]] std::array<Lanes, few_contacts / 4> distances;
  const std::size_t groups = (contacts.size() + 3) / 4;
  for (std::size_t i = 0; i < 4 * groups; ++i) {
    distances[i / 4][i % 4] = i < contacts.size() ? contacts[i].distance : infinity;
  }
  [[clang::uninitialized]] std::array<std::uint16_t, few_contacts> equal;
  for (std::uint16_t& count : std::span(equal).first(contacts.size())) {
    count = 0;
  }
  for (std::uint32_t number = 0; number < contacts.size(); ++number) {
    LaneNumbers less = 0;
    for (std::size_t group = 0; group < groups; ++group) {
      less -= distances[group] < all_lanes(contacts[number].distance);
    }
    const auto rank = static_cast<std::size_t>(less[0] + less[1] + less[2] + less[3]);
    numbers[rank + equal[rank]++] = number;
  }
  for (std::size_t begin = 0; begin < numbers.size();) {
    const std::size_t count = equal[begin];
    if (count == 0) {
      return false;
    }
    for (std::size_t i = begin + 1; i < begin + count; ++i) {
      for (std::size_t j = i; j > begin && contacts[numbers[j]].id < contacts[numbers[j - 1]].id; --j) {
        std::swap(numbers[j], numbers[j - 1]);
      }
    }
    begin += count;
  }
  return true;
}

// A number with two keys, of which the first counts more.
struct Keyed {
  std::uint64_t first, second;
  std::uint32_t number;
};
using KeyedNumbers = SmallVector<Keyed, few_contacts>;

// By keys; where these agree, by numbers.
inline void sort_keyed(std::span<Keyed> keyed) {
  std::ranges::sort(keyed, [](const Keyed& a, const Keyed& b) {
    return a.first != b.first ? a.first < b.first : a.second != b.second ? a.second < b.second : a.number < b.number;
  });
}

// As rank_few does, of any contacts.
inline void sort_any(std::span<const ContactPoint> contacts, std::span<std::uint32_t> numbers) {
  [[clang::uninitialized]] KeyedNumbers keyed;
  for (std::uint32_t number = 0; number < contacts.size(); ++number) {
    keyed.push_back({bits_in_order(contacts[number].distance), contacts[number].id, number});
  }
  sort_keyed(keyed.span());
  for (std::size_t rank = 0; rank < numbers.size(); ++rank) {
    numbers[rank] = keyed[rank].number;
  }
}

// The numbers of contacts in the order of `comes_before`.
[[nodiscard]] inline Numbers depth_order(std::span<const ContactPoint> contacts) {
  [[clang::uninitialized]] Numbers numbers;
  for (std::uint32_t number = 0; number < contacts.size(); ++number) {
    numbers.push_back(number);
  }
  if (std::ranges::is_sorted(contacts, comes_before)) {
    return numbers;
  }
  if (contacts.size() > few_contacts || !rank_few(contacts, numbers.span())) {
    sort_any(contacts, numbers.span());
  }
  return numbers;
}

// Brings some contacts to the front, in the order of their numbers. The others follow in any order.
inline void bring_to_front(std::span<ContactPoint> contacts, std::span<std::uint32_t> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    // What stood at a place before i went to where the contact of that place came from.
    while (numbers[i] < i) {
      numbers[i] = numbers[numbers[i]];
    }
    if (numbers[i] != i) {
      std::swap(contacts[i], contacts[numbers[i]]);
    }
  }
}

inline void sort_by_depth(std::span<ContactPoint> contacts) {
  Numbers numbers = depth_order(contacts);
  bring_to_front(contacts, numbers.span());
}

}  // namespace abut
