// SPDX-License-Identifier: Apache-2.0
module abut.narrow.manifold.cap;
import abut.capability;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

constexpr Real same_cluster_cosine = 0.98;

bool comes_before(const ContactPoint& a, const ContactPoint& b) {
  const auto key = [](const ContactPoint& c) {
    return std::tie(c.distance, c.child_a, c.child_b, c.id, c.point_a.x, c.point_a.y, c.point_a.z, c.point_b.x,
                    c.point_b.y, c.point_b.z);
  };
  return key(a) < key(b);
}

// Moves an item to an earlier place; those between keep their order.
template <class T>
void bring(std::span<T> items, std::size_t from, std::size_t to) {
  const T item = items[from];
  const std::span<T> between = items.subspan(to, from - to + 1);
  std::move_backward(between.begin(), between.end() - 1, between.end());
  between[0] = item;
}

// Brings the first contact of each cluster of normals to the front, and returns how many.
std::size_t bring_heads(std::span<ContactPoint> contacts) {
  std::size_t heads = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto agrees = [&](const ContactPoint& head) {
      return dot(head.normal, contacts[i].normal) >= same_cluster_cosine;
    };
    if (std::ranges::none_of(contacts.first(heads), agrees)) {
      bring(contacts, i, heads++);
    }
  }
  return heads;
}

// The first `kept` contacts stay. The one furthest from all kept ones joins them, until there are `most`.
template <class Gap>
void bring_furthest(std::span<ContactPoint> contacts, std::size_t kept, std::size_t most, Gap&& gap) {
  std::vector<Real> gaps(contacts.size(), infinity);
  const auto come_nearer = [&](const ContactPoint& other) {
    for (std::size_t i = kept; i < contacts.size(); ++i) {
      gaps[i] = std::min(gaps[i], gap(contacts[i], other));
    }
  };
  for (const ContactPoint& other : contacts.first(kept)) {
    come_nearer(other);
  }
  for (; kept < most; ++kept) {
    std::size_t furthest = kept;
    for (std::size_t i = kept; i < contacts.size(); ++i) {
      furthest = gaps[i] > gaps[furthest] ? i : furthest;
    }
    bring(contacts, furthest, kept);
    bring(std::span(gaps), furthest, kept);
    come_nearer(contacts[kept]);
  }
}

Real between_normals(const ContactPoint& a, const ContactPoint& b) { return 1 - dot(a.normal, b.normal); }
Real between_places(const ContactPoint& a, const ContactPoint& b) {
  return squared_norm((a.point_a + a.point_b) - (b.point_a + b.point_b));
}

}  // namespace

std::size_t cap(std::span<ContactPoint> contacts, std::size_t most) {
  std::ranges::sort(contacts, comes_before);
  if (most == 0 || contacts.size() <= most) {
    return contacts.size();
  }
  const std::size_t heads = bring_heads(contacts);
  if (heads > most) {
    bring_furthest(contacts.first(heads), 1, most, between_normals);
  } else {
    bring_furthest(contacts, heads, most, between_places);
  }
  std::ranges::sort(contacts.first(most), comes_before);
  return most;
}

}  // namespace abut
