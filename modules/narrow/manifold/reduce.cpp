// SPDX-License-Identifier: Apache-2.0
module abut.narrow.manifold.reduce;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.manifold.choice;
import abut.narrow.manifold.depth_order;

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

// Some ids, of which most that are asked for are none: a bit for what is left of each tells so.
class Ids {
 public:
  explicit Ids(std::span<const std::uint64_t> ids) : ids_(ids) {
    for (const std::uint64_t id : ids) {
      bits_[word_of(id)] |= bit_of(id);
    }
  }
  [[nodiscard]] bool empty() const { return ids_.empty(); }
  [[nodiscard]] bool hold(std::uint64_t id) const {
    return (bits_[word_of(id)] & bit_of(id)) != 0 && std::ranges::find(ids_, id) != ids_.end();
  }

 private:
  [[nodiscard]] static std::uint64_t mixed_up(std::uint64_t id) { return id * 0x9e3779b97f4a7c15; }
  [[nodiscard]] static std::size_t word_of(std::uint64_t id) { return mixed_up(id) >> 60; }
  [[nodiscard]] static std::uint64_t bit_of(std::uint64_t id) { return std::uint64_t{1} << (mixed_up(id) >> 54 & 63); }

  std::span<const std::uint64_t> ids_;
  std::array<std::uint64_t, 16> bits_{};
};

// Which contact of a patch counts as the deepest. One that was kept before wins ties.
[[nodiscard]] std::uint32_t deepest_of(const ContactPatch& patch, Real tie, const Ids& before) {
  for (std::uint32_t i = 0; i < patch.size() && patch[i].distance <= patch[0].distance + tie; ++i) {
    if (before.hold(patch[i].id)) {
      return i;
    }
  }
  return 0;
}

// The first contact of a patch that meets a condition. There is one.
template <class Condition>
[[nodiscard]] std::uint32_t first_of(const ContactPatch& patch, Condition&& is_one) {
  std::uint32_t i = 0;
  while (!is_one(patch[i])) {
    ++i;
  }
  return i;
}

using SomeIds = SmallVector<std::uint64_t, Choice::capacity>;

// The ids of a patch that were kept before. Where these are more than `most`, the ones that span most.
[[nodiscard]] SomeIds kept_before(const ContactPatch& patch, std::span<const Vec2> points, std::size_t most,
                                  Real extent, const Ids& before) {
  SomeIds all;
  for (std::size_t i = 0; i < patch.size() && !before.empty(); ++i) {
    if (before.hold(patch[i].id)) {
      all.push_back(patch[i].id);
    }
  }
  if (all.size() <= most) {
    return all;
  }
  const Ids ids(all.span());
  SomeIds best;
  Real most_area = -1;
  for (const std::uint64_t left_out : all.span()) {
    const auto stays = [&](const ContactPoint& contact) { return contact.id != left_out && ids.hold(contact.id); };
    Choice others(patch, first_of(patch, stays));
    others.grow(patch, most, extent, stays);
    if (const Real twice_area = others.twice_area(points); twice_area > most_area) {
      most_area = twice_area;
      best.clear();
      for (const std::uint32_t i : others.places()) {
        best.push_back(patch[i].id);
      }
    }
  }
  return best;
}

// The points that were kept before, and the ones that span most with them.
[[nodiscard]] Choice keep_again(const ContactPatch& patch, std::size_t most, Real extent, const Ids& before) {
  const auto was_kept = [&](const ContactPoint& contact) { return before.hold(contact.id); };
  Choice choice(patch, first_of(patch, was_kept));
  choice.grow(patch, most, extent, was_kept);
  for (std::uint32_t i = 0; i < patch.size(); ++i) {
    if (was_kept(patch[i])) {
      choice.keep(i, most);
    }
  }
  choice.grow(patch, most, extent, AnyContact{});
  return choice;
}

// The points that features hold, where one of them is as deep within `slack`. Else all.
[[nodiscard]] PlaceList without_running(const ContactPatch& patch, Real slack) {
  [[clang::uninitialized]] PlaceList held, all;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    all.push_back(patch.place(i));
    if (is_held(patch[i])) {
      held.push_back(patch.place(i));
    }
  }
  return !held.empty() && patch.of(held.span())[0].distance <= patch[0].distance + slack ? held : all;
}

// Depths that differ by less than this share of the extent are the same: to points kept before, and to points of rims.
struct Ties {
  Real depth, running;
  [[nodiscard]] bool are_exact() const { return depth == 0; }
};

// Adds the places of the points that hold a patch. Those that were kept before stay while one of them is as deep as
// any, and while they span nearly as much as others could.
void hold_patch(const ContactPatch& patch, std::size_t most, const Ids& before, const Ties& ties, PlaceList& kept) {
  const auto keep = [&](std::span<const std::uint32_t> indices) {
    for (const std::uint32_t i : indices) {
      kept.push_back(patch.place(i));
    }
  };
  if (patch.size() <= most) {
    for (std::size_t i = 0; i < patch.size(); ++i) {
      kept.push_back(patch.place(i));
    }
    return;
  }
  const Real extent = patch.extent();
  const Flats flats = flattened(patch);
  const std::span<const Vec2> points = flats.span();
  const auto fresh = [&](std::uint32_t first) { return choose(patch, points, first, most, extent); };
  const SomeIds again = kept_before(patch, points, most, extent, before);
  if (again.empty()) {
    keep(fresh(0).places());
    return;
  }
  const Choice same = keep_again(patch, most, extent, Ids(again.span()));
  const Real as_deep = patch[0].distance + ties.depth * extent, enough = same.twice_area(points) / tied_area;
  // Any of the points that tie in depth could have been the deepest when the others were chosen for it.
  const bool stays = std::ranges::any_of(same.places(), [&](std::uint32_t i) {
    return patch[i].distance <= as_deep && fresh(i).twice_area(points) <= enough;
  });
  keep(stays ? same.places() : fresh(0).places());
}

// The deepest contact is always kept. It is one more where it is none of the points that hold the patch.
void reduce_patch(const ContactPatch& patch, std::size_t most, const Ids& before, const Ties& ties, PlaceList& kept) {
  const std::size_t first = kept.size();
  if (ties.are_exact()) {
    hold_patch(patch, most, before, ties, kept);
  } else {
    const PlaceList held = without_running(patch, ties.running * patch.extent());
    hold_patch(patch.of(held.span()), most, before, ties, kept);
  }
  const ContactPatch holding = patch.of(kept.span().subspan(first));
  bool has_deepest = false;
  for (std::size_t i = 0; i < holding.size(); ++i) {
    has_deepest = has_deepest || holding[i].distance <= patch[0].distance;
  }
  if (!has_deepest) {
    kept.push_back(patch.place(0));
  }
}

// The places of those whose normals agree with that of the first; the others are left.
[[nodiscard]] PlaceList take_patch(std::span<const ContactPoint> contacts, const Vec3& normal, PlaceList& left) {
  [[clang::uninitialized]] PlaceList agreeing, others;
  for (const std::uint32_t place : left.span()) {
    (dot(contacts[place].normal, normal) >= same_patch_cosine ? agreeing : others).push_back(place);
  }
  left = others;
  return agreeing;
}

std::size_t reduce_patches(std::span<ContactPoint> contacts, std::size_t most, const Ids& before, const Ties& ties,
                           SurfaceSides surfaces) {
  if (most == 0 || contacts.size() <= most) {
    sort_by_depth(contacts);
    return contacts.size();
  }
  [[clang::uninitialized]] PlaceList kept, left = places_by_depth(contacts);
  while (!left.empty()) {
    const ContactPatch rest(contacts, left.span());
    const std::uint32_t head = before.empty() ? 0 : deepest_of(rest, ties.depth * rest.extent(), before);
    const PlaceList places = take_patch(contacts, rest[head].normal, left);
    const ContactPatch patch(contacts, places.span());
    if (!(surfaces.a || surfaces.b) || patch.size() <= most) {
      reduce_patch(patch, most, before, ties, kept);
      continue;
    }
    Regions regions(patch, surfaces, gap_share);
    for (PlaceList region = regions.next(); !region.empty(); region = regions.next()) {
      reduce_patch(patch.of(region.span()), most, before, ties, kept);
    }
  }
  std::ranges::sort(kept.span(),
                    [&](std::uint32_t a, std::uint32_t b) { return comes_before(contacts[a], contacts[b]); });
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
