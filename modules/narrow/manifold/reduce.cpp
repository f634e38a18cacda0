// SPDX-License-Identifier: Apache-2.0
module abut.narrow.manifold.reduce;
import abut.capability;
import abut.core.small_vector;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold.choice;
import abut.narrow.manifold.regions;

namespace abut {
namespace {

// Contacts whose normals differ by less than 11.5 degrees hold like one patch.
constexpr Real same_patch_cosine = 0.98;

// Whether a feature holds the point. None holds the deepest point of a rim that rests on its face.
[[nodiscard]] bool is_held(const ContactPoint& contact) {
  const auto is_whole = [](const Feature& feature) { return feature.kind == FeatureKind::whole; };
  const auto is_wide = [](const Feature& feature) {
    return feature.kind == FeatureKind::whole || feature.kind == FeatureKind::face;
  };
  return !((is_whole(contact.feature_a) && is_wide(contact.feature_b)) ||
           (is_wide(contact.feature_a) && is_whole(contact.feature_b)));
}

// Some ids, each at the first free place of a table from where its bits lead. Less than half of the places are taken.
class Ids {
 public:
  explicit Ids(std::span<const std::uint64_t> ids) {
    int bits = 3;
    while ((std::size_t{1} << bits) < 2 * ids.size() + 1) {
      ++bits;
    }
    shift_ = 64 - bits;
    for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
      places_.push_back({0, false});
    }
    for (const std::uint64_t id : ids) {
      places_[place_of(id)] = {id, true};
    }
    is_empty_ = ids.empty();
  }
  [[nodiscard]] bool empty() const { return is_empty_; }
  [[nodiscard]] bool hold(std::uint64_t id) const { return !is_empty_ && places_[place_of(id)].is_taken; }

 private:
  struct Place {
    std::uint64_t id;
    bool is_taken;
  };
  // Where an id is, or may be put.
  [[nodiscard]] std::size_t place_of(std::uint64_t id) const {
    std::size_t place = (id * 0x9e3779b97f4a7c15) >> shift_;
    while (places_[place].is_taken && places_[place].id != id) {
      place = (place + 1) % places_.size();
    }
    return place;
  }

  SmallVector<Place, 256> places_;
  int shift_ = 0;
  bool is_empty_ = true;
};

// Contacts are large, so that one which stays is not moved.
void exchange(ContactPoint& a, ContactPoint& b) {
  if (&a != &b) {
    std::swap(a, b);
  }
}

// The place of the deepest contact. One that was kept before wins ties.
[[nodiscard]] std::uint32_t deepest_of(std::span<const ContactPoint> contacts, Real tie, const Ids& before) {
  std::uint32_t deepest = 0;
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    deepest = comes_before(contacts[i], contacts[deepest]) ? i : deepest;
  }
  if (before.empty()) {
    return deepest;
  }
  const Real tied = contacts[deepest].distance + tie;
  std::optional<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const ContactPoint& contact = contacts[i];
    if (contact.distance <= tied && before.hold(contact.id) && (!kept || comes_before(contact, contacts[*kept]))) {
      kept = i;
    }
  }
  return kept.value_or(deepest);
}

// Places of a patch, in rising order.
using SomePlaces = SmallVector<std::uint32_t, Choice::capacity>;

// The places of the contacts that were kept before. Where these are more than `most`, of the ones that span most.
[[nodiscard]] SomePlaces kept_before(std::span<const ContactPoint> patch, std::span<const Vec2> points,
                                     std::size_t most, Real extent, const Ids& before) {
  SomePlaces all;
  for (std::uint32_t place = 0; place < patch.size(); ++place) {
    if (before.hold(patch[place].id)) {
      all.push_back(place);
    }
  }
  if (all.size() <= most) {
    return all;
  }
  SomePlaces best;
  Real most_area = -1;
  for (const std::uint32_t left_out : all.span()) {
    SomePlaces others;
    for (const std::uint32_t place : all.span()) {
      if (place != left_out) {
        others.push_back(place);
      }
    }
    Choice choice(patch, others[0]);
    choice.grow_among(patch, others.span(), most, extent);
    if (const Real twice_area = choice.twice_area(points); twice_area > most_area) {
      most_area = twice_area;
      best.clear();
      for (const std::uint32_t place : choice.places()) {
        best.push_back(place);
      }
    }
  }
  std::ranges::sort(best.span());
  return best;
}

// The points that were kept before, and the ones that span most with them.
[[nodiscard]] Choice keep_again(std::span<const ContactPoint> patch, std::span<const std::uint32_t> kept,
                                std::size_t most, Real extent) {
  Choice choice(patch, kept.front());
  choice.grow_among(patch, kept, most, extent);
  for (const std::uint32_t place : kept) {
    choice.keep(place, most);
  }
  choice.grow(patch, most, extent);
  return choice;
}

// Brings the chosen contacts of a patch to its front.
std::size_t bring_to_front(std::span<ContactPoint> patch, std::span<const std::uint32_t> places) {
  std::array<std::uint32_t, Choice::capacity> rising{};
  const std::span<std::uint32_t> order = std::span(rising).first(places.size());
  std::ranges::copy(places, order.begin());
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    exchange(patch[i], patch[order[i]]);
  }
  return order.size();
}

// Brings the points that features hold to the front, and leaves out the others where a held one is as deep within
// `slack`.
[[nodiscard]] std::span<ContactPoint> without_running(std::span<ContactPoint> patch, Real slack) {
  const auto end = std::partition(patch.begin(), patch.end(), is_held);
  const std::span<ContactPoint> held = patch.first(static_cast<std::size_t>(end - patch.begin()));
  const Real deepest = std::ranges::min_element(patch, comes_before)->distance;
  const bool is_as_deep =
      std::ranges::any_of(held, [&](const ContactPoint& contact) { return contact.distance <= deepest + slack; });
  return is_as_deep ? held : patch;
}

// Depths that differ by less than this share of the extent are the same: to points kept before, and to points of rims.
struct Ties {
  Real depth, running;
  [[nodiscard]] bool are_exact() const { return depth == 0; }
};

// Brings the points that hold a patch to its front. Those that were kept before stay while one of them is as deep as
// any, and while they span nearly as much as others could.
std::size_t hold_patch(std::span<ContactPoint> patch, std::size_t most, const Ids& before, const Ties& ties) {
  sort_by_depth(patch);
  if (patch.size() <= most) {
    return patch.size();
  }
  const Real extent = extent_of(patch);
  const Flats flats = flattened(patch);
  const std::span<const Vec2> points = flats.span();
  const auto fresh = [&](std::uint32_t first) { return choose(patch, points, first, most, extent); };
  const SomePlaces again = kept_before(patch, points, most, extent, before);
  if (again.empty()) {
    return bring_to_front(patch, fresh(0).places());
  }
  const Choice same = keep_again(patch, again.span(), most, extent);
  const Real as_deep = patch[0].distance + ties.depth * extent, enough = same.twice_area(points) / tied_area;
  // Any of the points that tie in depth could have been the deepest when the others were chosen for it.
  const bool stays = std::ranges::any_of(same.places(), [&](std::uint32_t place) {
    return patch[place].distance <= as_deep && fresh(place).twice_area(points) <= enough;
  });
  return bring_to_front(patch, stays ? same.places() : fresh(0).places());
}

// The deepest contact is always kept. It is one more where it is none of the points that hold the patch.
std::size_t reduce_patch(std::span<ContactPoint> patch, std::size_t most, const Ids& before, const Ties& ties) {
  std::size_t kept = ties.are_exact()
                         ? hold_patch(patch, most, before, ties)
                         : hold_patch(without_running(patch, ties.running * extent_of(patch)), most, before, ties);
  const auto deepest = std::ranges::min_element(patch, comes_before),
             of_kept = std::ranges::min_element(patch.first(kept), comes_before);
  if (deepest->distance < of_kept->distance) {
    std::swap(patch[kept++], *deepest);
  }
  return kept;
}

// Which contacts stand beside each other: their numbers, and where each lot of them ends.
struct Lots {
  SmallVector<std::uint32_t, few_contacts> order;
  SmallVector<std::size_t, 16> ends;

  void add(std::uint32_t number) { order.push_back(number); }
  void end() { ends.push_back(order.size()); }
  // Calls take(contacts of one lot) for each.
  template <class Take>
  void visit(std::span<ContactPoint> contacts, const Take& take) {
    arrange(contacts, [&](std::uint32_t place) -> std::uint32_t& { return order[place]; });
    std::size_t begin = 0;
    for (const std::size_t end : ends.span()) {
      take(contacts.subspan(begin, end - begin));
      begin = end;
    }
  }
};

// Brings contacts of one region beside each other, where there are several, and calls take(contacts of one) for each.
template <class Take>
void visit_regions(std::span<ContactPoint> contacts, SurfaceSides surfaces, const Take& take) {
  const Regions regions(contacts, [&](const ContactPoint& contact) {
    return std::uint64_t{surfaces.a ? contact.feature_a.index : 0} << 32 |
           std::uint64_t{surfaces.b ? contact.feature_b.index : 0};
  });
  if (regions.count() == 1) {
    take(contacts);
    return;
  }
  Lots lots;
  regions.visit([&](std::uint32_t number) { lots.add(number); }, [&] { lots.end(); });
  lots.visit(contacts, take);
}

// Brings contacts beside each other whose normals agree with that of the deepest one. The others follow, by the deepest
// one of what is left. Calls take(those of one patch) for each patch.
template <class Take>
void visit_patches(std::span<ContactPoint> contacts, const Ids& before, const Ties& ties, const Take& take) {
  const Real tie = before.empty() ? 0 : ties.depth * extent_of(contacts);
  const auto agree = [](const Vec3& a, const Vec3& b) { return dot(a, b) >= same_patch_cosine; };
  const Vec3 normal = contacts[deepest_of(contacts, tie, before)].normal;
  if (std::ranges::all_of(contacts, [&](const ContactPoint& contact) { return agree(contact.normal, normal); })) {
    take(contacts);
    return;
  }
  // Contacts are large, so that this much of them is looked at again and again.
  struct Facing {
    Vec3 normal;
    Real distance;
    std::uint32_t number;
    std::uint64_t id;
  };
  sort_by_depth(contacts);
  [[clang::uninitialized]] SmallVector<Facing, few_contacts> all;
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    all.push_back({contacts[i].normal, contacts[i].distance, i, contacts[i].id});
  }
  Lots lots;
  for (std::size_t left = all.size(); left > 0;) {
    const std::span<Facing> rest = all.span().first(left);
    // One that was kept before wins ties.
    const Real tied = rest[0].distance + tie;
    std::size_t first = 0;
    while (first < left && rest[first].distance <= tied && !before.hold(rest[first].id)) {
      ++first;
    }
    const bool wins = first < left && rest[first].distance <= tied;
    const Vec3 facing = rest[wins ? first : 0].normal;
    left = 0;
    for (const Facing& one : rest) {
      if (agree(one.normal, facing)) {
        lots.add(one.number);
      } else {
        rest[left++] = one;
      }
    }
    lots.end();
  }
  lots.visit(contacts, take);
}

std::size_t reduce_patches(std::span<ContactPoint> contacts, std::size_t most, const Ids& before, const Ties& ties,
                           SurfaceSides surfaces) {
  if (most == 0 || contacts.size() <= most) {
    sort_by_depth(contacts);
    return contacts.size();
  }
  std::size_t kept = 0;
  const auto take = [&](std::span<ContactPoint> patch) {
    const std::size_t kept_of_patch = reduce_patch(patch, most, before, ties);
    for (std::size_t i = 0; i < kept_of_patch; ++i) {
      exchange(contacts[kept++], patch[i]);
    }
  };
  visit_patches(contacts, before, ties, [&](std::span<ContactPoint> patch) {
    if ((surfaces.a || surfaces.b) && patch.size() > most) {
      visit_regions(patch, surfaces, take);
    } else {
      take(patch);
    }
  });
  sort_by_depth(contacts.first(kept));
  return kept;
}

}  // namespace

std::size_t reduce(std::span<ContactPoint> contacts, std::size_t most, SurfaceSides surfaces) {
  return reduce_patches(contacts, most, Ids({}), {0, 0}, surfaces);
}
std::size_t reduce(std::span<ContactPoint> contacts, std::size_t most, std::span<const std::uint64_t> before,
                   SurfaceSides surfaces) {
  return reduce_patches(contacts, most, Ids(most == 1 ? std::span<const std::uint64_t>{} : before),
                        most == 1 ? Ties{0, 0} : Ties{tied_depth, running_depth}, surfaces);
}

}  // namespace abut
