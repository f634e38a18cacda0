// SPDX-License-Identifier: Apache-2.0
module abut.narrow.manifold.reduce_children;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.reduce;

namespace abut {
namespace {

bool have_same_children(const ContactPoint& a, const ContactPoint& b) {
  return a.child_a == b.child_a && a.child_b == b.child_b;
}

template <class Reduce>
std::size_t reduce_each_pair(std::span<ContactPoint> contacts, Reduce&& reduce_pair) {
  const bool are_of_one_pair = std::ranges::all_of(
      contacts, [&](const ContactPoint& contact) { return have_same_children(contact, contacts.front()); });
  if (are_of_one_pair) {
    return reduce_pair(contacts);
  }
  std::ranges::sort(contacts, [](const ContactPoint& a, const ContactPoint& b) {
    return std::tie(a.child_a, a.child_b, a.distance, a.id) < std::tie(b.child_a, b.child_b, b.distance, b.id);
  });
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < contacts.size();) {
    std::size_t end = begin + 1;
    while (end < contacts.size() && have_same_children(contacts[begin], contacts[end])) {
      ++end;
    }
    const std::size_t count = reduce_pair(contacts.subspan(begin, end - begin));
    std::swap_ranges(contacts.begin() + static_cast<std::ptrdiff_t>(begin),
                     contacts.begin() + static_cast<std::ptrdiff_t>(begin + count),
                     contacts.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += count;
    begin = end;
  }
  std::ranges::sort(contacts.first(kept), [](const ContactPoint& a, const ContactPoint& b) {
    return std::tie(a.distance, a.child_a, a.child_b, a.id) < std::tie(b.distance, b.child_a, b.child_b, b.id);
  });
  return kept;
}

}  // namespace

std::size_t reduce_children(std::span<ContactPoint> contacts, std::size_t most) {
  return reduce_each_pair(contacts, [&](std::span<ContactPoint> pair) { return reduce(pair, most); });
}
std::size_t reduce_children(std::span<ContactPoint> contacts, std::size_t most, std::span<const std::uint64_t> before) {
  return reduce_each_pair(contacts, [&](std::span<ContactPoint> pair) { return reduce(pair, most, before); });
}

}  // namespace abut
