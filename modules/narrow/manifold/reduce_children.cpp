// SPDX-License-Identifier: Apache-2.0
module abut.narrow.manifold.reduce_children;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.places_in_order;
import abut.narrow.manifold.reduce;

namespace abut {
namespace {

bool have_same_children(const ContactPoint& a, const ContactPoint& b) {
  return a.child_a == b.child_a && a.child_b == b.child_b;
}
std::uint64_t children_of(const ContactPoint& contact) {
  return std::uint64_t{contact.child_a} << 32 | contact.child_b;
}

// Replaces the places of the contacts of one pair of children by those of the ones that are kept.
template <class Reduce>
std::size_t keep_of_pair(std::span<ContactPoint> contacts, std::span<std::uint32_t> places, Manifold& spare,
                         Reduce&& reduce_pair) {
  spare.clear();
  for (const std::uint32_t place : places) {
    spare.push_back(contacts[place]);
  }
  const std::size_t count = reduce_pair(std::span(spare));
  for (std::size_t i = 0; i < count; ++i) {
    contacts[places[i]] = spare[i];
  }
  return count;
}

// Keeps of each pair of children what holds it. One of no more than `most` contacts keeps them all.
template <class Reduce>
void keep_of_each_pair(std::span<ContactPoint> contacts, std::size_t most, ReduceScratch& scratch,
                       Reduce&& reduce_pair) {
  scratch.order.sort([&](std::uint32_t place) { return children_of(contacts[place]); });
  const std::span<std::uint32_t> places = scratch.order.all();
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < places.size();) {
    std::size_t end = begin + 1;
    while (end < places.size() && have_same_children(contacts[places[begin]], contacts[places[end]])) {
      ++end;
    }
    const std::span<std::uint32_t> of_pair = places.subspan(begin, end - begin);
    const std::size_t count =
        of_pair.size() <= most ? of_pair.size() : keep_of_pair(contacts, of_pair, scratch.spare, reduce_pair);
    std::ranges::copy(of_pair.first(count), places.subspan(kept).begin());
    kept += count;
    begin = end;
  }
  scratch.order.keep(kept);
}

// Contacts are large, and those of particles may be a million. So their places are sorted, and each contact moves once.
template <class Reduce>
std::size_t reduce_each_pair(std::span<ContactPoint> contacts, std::size_t most, ReduceScratch& scratch,
                             Reduce&& reduce_pair) {
  const bool are_of_one_pair = std::ranges::all_of(
      contacts, [&](const ContactPoint& contact) { return have_same_children(contact, contacts.front()); });
  if (are_of_one_pair) {
    return reduce_pair(contacts);
  }
  scratch.order.fill(contacts.size());
  if (most != 0) {
    keep_of_each_pair(contacts, most, scratch, reduce_pair);
  }
  scratch.order.sort([&](std::uint32_t place) { return bits_in_order(contacts[place].distance); },
                     [&](std::uint32_t a, std::uint32_t b) {
                       const auto key = [&](const ContactPoint& contact) {
                         return std::tie(contact.child_a, contact.child_b, contact.id);
                       };
                       return key(contacts[a]) < key(contacts[b]);
                     });
  const std::span<const std::uint32_t> places = scratch.order.all();
  scratch.spare.clear();
  for (const std::uint32_t place : places) {
    scratch.spare.push_back(contacts[place]);
  }
  std::ranges::copy(scratch.spare, contacts.begin());
  return places.size();
}

}  // namespace

std::size_t reduce_children(std::span<ContactPoint> contacts, std::size_t most, const SurfacesOf& surfaces_of) {
  ReduceScratch scratch;
  return reduce_each_pair(contacts, most, scratch, [&](std::span<ContactPoint> pair) {
    return pair.size() > most ? reduce(pair, most, surfaces_of(pair.front())) : reduce(pair, most);
  });
}
std::size_t reduce_children(std::span<ContactPoint> contacts, std::size_t most, std::span<const std::uint64_t> before,
                            ReduceScratch& scratch, const SurfacesOf& surfaces_of) {
  return reduce_each_pair(contacts, most, scratch, [&](std::span<ContactPoint> pair) {
    return pair.size() > most ? reduce(pair, most, before, surfaces_of(pair.front())) : reduce(pair, most);
  });
}

}  // namespace abut
