// SPDX-License-Identifier: Apache-2.0
// Contacts in the order of their depth. They are large: their numbers are put in order, and each contact moves once.
export module abut.narrow.manifold.depth_order;
import abut.capability;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.narrow.manifold.places_in_order;

export namespace abut {

// Up to so many contacts need no memory of the heap.
inline constexpr std::size_t few_contacts = 256;

// Numbers of contacts, or ranks of theirs.
using Numbers = SmallVector<std::uint32_t, few_contacts>;

[[nodiscard]] inline bool comes_before(const ContactPoint& a, const ContactPoint& b) {
  return a.distance != b.distance ? a.distance < b.distance : a.id < b.id;
}

// Of any contacts.
inline void sort_any(std::span<const ContactPoint> contacts, std::span<std::uint32_t> numbers) {
  struct Keyed {
    std::uint64_t distance, id;
    std::uint32_t number;
  };
  [[clang::uninitialized]] SmallVector<Keyed, few_contacts> keyed;
  for (std::uint32_t number = 0; number < contacts.size(); ++number) {
    keyed.push_back({bits_in_order(contacts[number].distance), contacts[number].id, number});
  }
  std::ranges::sort(keyed.span(), [](const Keyed& a, const Keyed& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.id != b.id ? a.id < b.id : a.number < b.number;
  });
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
  const auto distance_of = [&](std::uint32_t number) { return contacts[number].distance; };
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) { return contacts[a].id < contacts[b].id; };
  if (contacts.size() > few_contacts || !rank_few<few_contacts>(numbers.span(), distance_of, is_before)) {
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
