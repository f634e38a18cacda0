// SPDX-License-Identifier: Apache-2.0
module abut.narrow.manifold.reduce;
import abut.capability;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.manifold.by_depth;
import abut.narrow.manifold.choice;
import abut.narrow.manifold.depth_order;
import abut.narrow.manifold.four_points;
import abut.narrow.manifold.regions;

namespace abut {
namespace {

// Contacts whose normals differ by less than 11.5 degrees hold like one patch.
constexpr Real same_patch_cosine = 0.98;

// Where the contacts of a patch lie in the plane across the normal of the deepest one, which comes first.
struct Flat {
  SmallVector<Vec2, few_contacts> all;
  Real extent = 0;

  [[nodiscard]] std::span<const Vec2> points() const { return all.span(); }
};
[[nodiscard]] Flat flattened(const ByDepth& contacts, std::span<const std::uint32_t> patch) {
  const Tangents tangents = tangents_of(contacts.normal(patch[0]));
  const Vec3& base = contacts.middle(patch[0]);
  [[clang::uninitialized]] Flat flat;
  for (const std::uint32_t rank : patch) {
    const Vec3 d = contacts.middle(rank) - base;
    flat.all.push_back({dot(d, tangents.first), dot(d, tangents.second)});
  }
  flat.extent = contacts.extent_of(patch);
  return flat;
}

// Places of a patch, in rising order.
using SomePlaces = SmallVector<std::uint32_t, Choice::capacity>;

// The places of the contacts that were kept before.
[[nodiscard]] SomePlaces kept_before(const ByDepth& contacts, std::span<const std::uint32_t> patch) {
  SomePlaces places;
  for (std::uint32_t place = 0; place < patch.size(); ++place) {
    if (contacts.was_kept(patch[place])) {
      places.push_back(place);
    }
  }
  return places;
}

// Where there are more places than `most`, the ones that span most.
[[nodiscard]] SomePlaces widest(const Flat& flat, const SomePlaces& all, std::size_t most) {
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
    Choice choice(flat.points(), others[0]);
    choice.grow(flat.points(), others.span(), most, flat.extent);
    if (const Real twice_area = choice.twice_area(flat.points()); twice_area > most_area) {
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
[[nodiscard]] Choice keep_again(const Flat& flat, std::span<const std::uint32_t> kept,
                                std::span<const std::uint32_t> outside, std::size_t most) {
  Choice choice(flat.points(), kept.front());
  choice.grow(flat.points(), kept, most, flat.extent);
  for (const std::uint32_t place : kept) {
    choice.keep(place, most);
  }
  choice.grow(flat.points(), outside, most, flat.extent);
  return choice;
}

// Depths that differ by less than this share of the extent are the same: to points kept before, and to points of rims.
struct Ties {
  Real depth, running;
  [[nodiscard]] bool are_exact() const { return depth == 0; }
};

// The points that hold a patch. Those that were kept before stay while one of them is as deep as any, and while they
// span nearly as much as others could.
[[nodiscard]] Choice hold(const ByDepth& contacts, std::span<const std::uint32_t> patch, std::size_t most,
                          const Ties& ties) {
  [[clang::uninitialized]] const Flat flat = flattened(contacts, patch);
  [[clang::uninitialized]] const Places outside = places_outside(flat.points());
  const auto fresh = [&](std::uint32_t first) {
    return choose(flat.points(), outside.span(), first, most, flat.extent);
  };
  const SomePlaces before = kept_before(contacts, patch);
  if (before.empty()) {
    return fresh(0);
  }
  const Choice same = keep_again(flat, widest(flat, before, most).span(), outside.span(), most);
  const Real as_deep = contacts.distance(patch[0]) + ties.depth * flat.extent,
             enough = same.twice_area(flat.points()) / tied_area;
  // Any of the points that tie in depth could have been the deepest when the others were chosen for it.
  const bool stays = std::ranges::any_of(same.places(), [&](std::uint32_t place) {
    return contacts.distance(patch[place]) <= as_deep && fresh(place).twice_area(flat.points()) <= enough;
  });
  return stays ? same : fresh(0);
}

// Adds the ranks of the points that hold a patch to those that are kept.
void hold_patch(const ByDepth& contacts, std::span<const std::uint32_t> patch, std::size_t most, const Ties& ties,
                Numbers& kept) {
  if (patch.size() <= most) {
    for (const std::uint32_t rank : patch) {
      kept.push_back(rank);
    }
    return;
  }
  const Choice held = hold(contacts, patch, most, ties);
  for (const std::uint32_t place : held.places()) {
    kept.push_back(patch[place]);
  }
}

// The points that features hold, and whether one of them is as deep as any within a slack.
struct Held {
  Numbers ranks;
  bool are_as_deep = false;
};
[[nodiscard]] Held held_points(const ByDepth& contacts, std::span<const std::uint32_t> patch, Real slack) {
  [[clang::uninitialized]] Held held;
  for (const std::uint32_t rank : patch) {
    if (contacts.is_held_by_features(rank)) {
      held.ranks.push_back(rank);
    }
  }
  held.are_as_deep = !held.ranks.empty() && contacts.distance(held.ranks[0]) <= contacts.distance(patch[0]) + slack;
  return held;
}

// The deepest contact is always kept. It is one more where it is none of the points that hold the patch.
void reduce_patch(const ByDepth& contacts, std::span<const std::uint32_t> patch, std::size_t most, const Ties& ties,
                  Numbers& kept) {
  const std::size_t before = kept.size();
  if (ties.are_exact()) {
    hold_patch(contacts, patch, most, ties, kept);
  } else {
    [[clang::uninitialized]] const Held held = held_points(contacts, patch, ties.running * contacts.extent_of(patch));
    hold_patch(contacts, held.are_as_deep ? held.ranks.span() : patch, most, ties, kept);
  }
  const std::uint32_t deepest_kept = *std::ranges::min_element(kept.span().subspan(before));
  if (contacts.distance(patch[0]) < contacts.distance(deepest_kept)) {
    kept.push_back(patch[0]);
  }
}

// Calls take(ranks of one region) for each region of a patch. part_of(rank) tells a triangle, or a pair of them.
template <class PartOf, class Take>
void visit_regions(const ByDepth& contacts, std::span<const std::uint32_t> patch, const PartOf& part_of,
                   const Take& take) {
  [[clang::uninitialized]] SmallVector<Vec3, few_contacts> points;
  for (const std::uint32_t rank : patch) {
    points.push_back(contacts.middle(rank));
  }
  [[clang::uninitialized]] const Regions regions(points.span(),
                                                 [&](std::uint32_t place) { return part_of(patch[place]); });
  if (regions.count() == 1) {
    take(patch);
    return;
  }
  [[clang::uninitialized]] Numbers region;
  regions.visit([&](std::uint32_t place) { region.push_back(patch[place]); },
                [&] {
                  take(region.span());
                  region.clear();
                });
}

// Calls take(ranks of one patch) for each: those whose normals agree with that of the deepest one. The others follow,
// by the deepest one of what is left. One that was kept before wins ties.
template <class Take>
void visit_patches(const ByDepth& contacts, Real tie, const Take& take) {
  [[clang::uninitialized]] Numbers left;  // a bit for each rank of four
  for (std::uint32_t rank = 0; rank < contacts.size(); rank += 4) {
    left.push_back(contacts.size() - rank < 4 ? (1u << (contacts.size() - rank)) - 1 : 15u);
  }
  const std::span<std::uint32_t> groups = left.span();
  const std::span<const Columns> normals = contacts.normals();
  const auto is_left = [&](std::uint32_t rank) { return (groups[rank / 4] >> rank % 4 & 1) != 0; };
  [[clang::uninitialized]] Numbers patch;
  for (std::uint32_t rank = 0; rank < contacts.size(); ++rank) {
    if (!is_left(rank)) {
      continue;
    }
    std::uint32_t first = rank;
    const Real tied = contacts.distance(rank) + tie;
    while (first < contacts.size() && contacts.distance(first) <= tied &&
           !(is_left(first) && contacts.was_kept(first))) {
      ++first;
    }
    const bool wins = first < contacts.size() && contacts.distance(first) <= tied;
    const Columns facing = Columns::all(contacts.normal(wins ? first : rank));
    patch.clear();
    for (std::uint32_t group = rank / 4; group < groups.size(); ++group) {
      if (groups[group] == 0) {
        continue;
      }
      const std::uint64_t agree = groups[group] & bits_of(dot(normals[group], facing) >= all_lanes(same_patch_cosine));
      groups[group] &= ~static_cast<std::uint32_t>(agree);
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        patch.push_back_if(4 * group + lane, (agree >> lane & 1) != 0);
      }
    }
    take(patch.span());
  }
}

std::size_t reduce_patches(std::span<ContactPoint> contacts, std::size_t most, const Ids& before, const Ties& ties,
                           SurfaceSides surfaces) {
  if (most == 0 || contacts.size() <= most) {
    sort_by_depth(contacts);
    return contacts.size();
  }
  [[clang::uninitialized]] const ByDepth by_depth(contacts, before);
  [[clang::uninitialized]] Numbers kept;
  const auto part_of = [&](std::uint32_t rank) {
    const ContactPoint& contact = contacts[by_depth.number(rank)];
    return std::uint64_t{surfaces.a ? contact.feature_a.index : 0} << 32 |
           std::uint64_t{surfaces.b ? contact.feature_b.index : 0};
  };
  const auto take = [&](std::span<const std::uint32_t> patch) { reduce_patch(by_depth, patch, most, ties, kept); };
  const Real tie = ties.are_exact() ? 0 : ties.depth * by_depth.extent();
  visit_patches(by_depth, tie, [&](std::span<const std::uint32_t> patch) {
    if ((surfaces.a || surfaces.b) && patch.size() > most) {
      visit_regions(by_depth, patch, part_of, take);
    } else {
      take(patch);
    }
  });
  std::ranges::sort(kept.span());
  for (std::uint32_t& one : kept.span()) {
    one = by_depth.number(one);
  }
  bring_to_front(contacts, kept.span());
  return kept.size();
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
