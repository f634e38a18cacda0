// SPDX-License-Identifier: Apache-2.0
// Convex shapes are cast as they are, those that are made of parts by the kernel of the pair, composites child by child
// in the order in which the boxes are met, and what holes leave of solids in strides.
module abut.pairs.any_shape.casts.shape_cast;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cast.cast_search;
import abut.narrow.cast.linear_cast;
import abut.narrow.cast.parts_in_order;
import abut.pairs.any_shape;
import abut.pairs.any_shape.casts.starting_touch;
import abut.pairs.registry;

namespace abut {
namespace {

const AnyShape::Variant& variant_of(const AnyShape& shape) { return shape; }

// Bound of the coordinates of a shape in its own frame; nothing is added by shapes without bounds.
Real coordinates_of(const Aabb& box) {
  return box.is_bounded() ? std::max(largest_magnitude(box.low), largest_magnitude(box.high)) : 0;
}
Real size_of(const Aabb& a, const Aabb& b, const Pose& ab) {
  return coordinates_of(a) + coordinates_of(b) + largest_magnitude(ab.position);
}

// What a kind is, by its place in the registry: read without a call for the shape.
struct KindTraits {
  bool is_convex, is_assembly, is_hole, is_sampled, has_parts;
};
constexpr auto kind_traits = []<std::size_t... Places>(std::index_sequence<Places...>) {
  return std::array{KindTraits{Convex<Shapes::At<Places>>, Assembly<Shapes::At<Places>>, Hole<Shapes::At<Places>>,
                               SampledSolid<Shapes::At<Places>>, has_parts<Shapes::At<Places>>}...};
}(std::make_index_sequence<Shapes::count>{});

const KindTraits& traits_of(const AnyShape& shape) { return kind_traits[shape.index()]; }

// Of a convex shape.
Real reach(const AnyShape& shape, const Pose& pose, const Vec3& direction) {
  return std::visit(
      [&]<class S>(const S& s) -> Real {
        if constexpr (Convex<S>) {
          return reach(s, pose, direction);
        } else {
          return infinity;
        }
      },
      variant_of(shape));
}

// Two convex shapes, or one and a half-space, along whose normal everything is as far as the whole.
void cast_whole(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, const CastNames& names,
                CastSearch& search) {
  const Pose ab = relative(pose_a, pose_b);
  const LinearMotion motion = search.motion_in(pose_a, false);
  const bool are_convex = traits_of(a).is_convex && traits_of(b).is_convex;
  Real start = 0;
  const auto distance_at = [&](Real way, Distance& out) {
    const Outcome outcome = pair_distance(a, b, moved(ab, motion, way), search.settings(), out);
    start = way == 0 ? out.lower : start;
    return outcome;
  };
  const auto gap_along = [&](const Vec3& normal) {
    return are_convex ? -reach(b, ab, -normal) - reach(a, Pose::identity(), normal) : start;
  };
  std::optional<FirstTouch> touch;
  const Outcome outcome = first_touch(motion, search.size(), search.settings().margin, distance_at, gap_along, touch);
  search.add(outcome, touch, pose_a, false, names);
}

// Whatever has a distance: what holes leave, holes by themselves, and sampled solids.
void cast_in_strides(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b,
                     const CastNames& names, CastSearch& search) {
  constexpr Real strides_of_shape = 64, most_strides = 1024;
  const Pose ab = relative(pose_a, pose_b);
  const LinearMotion motion = search.motion_in(pose_a, false);
  const Aabb still = aabb_of(a, Pose::identity()).inflated(search.slack()), moving = aabb_of(b, ab);
  const bool are_bounded = still.is_bounded() && moving.is_bounded();
  const std::optional<Passage> passage = are_bounded ? passage_of(still, moving, motion) : Passage{0, motion.length};
  if (!passage) {
    search.add(Outcome::ok, std::nullopt, pose_a, false, names);
    return;
  }
  const Real extent = std::min(largest_magnitude(still.high - still.low), largest_magnitude(moving.high - moving.low));
  const Real stride =
      std::max(extent < infinity ? extent / strides_of_shape : 0, (passage->leave - passage->enter) / most_strides);
  std::optional<FirstTouch> touch;
  const Outcome outcome = first_touch_by_strides(
      *passage, search.size(), search.settings().margin, stride,
      [&](Real way, Distance& out) { return pair_distance(a, b, moved(ab, motion, way), search.settings(), out); },
      touch);
  search.add(outcome, touch, pose_a, false, names);
}

// The pose of b is that before the motion.
void cast(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, const CastNames& names,
          CastSearch& search);

// Of solids that no hole cuts.
template <Assembly A>
void cast_children_of(const A& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, bool swapped,
                      const CastNames& names, CastSearch& search) {
  const Pose ab = relative(pose_a, pose_b);
  const LinearMotion motion = search.motion_in(pose_a, swapped);
  const Aabb moving = aabb_of(b, ab);
  const Real near = search.slack();
  std::vector<std::pair<Real, std::uint32_t>> met;
  a.visit_children(swept(moving, motion, 0, motion.length).inflated(near), [&](std::uint32_t child) {
    const Aabb still = aabb_of(*a.children()[child].shape, a.children()[child].pose).inflated(near);
    const bool are_bounded = still.is_bounded() && moving.is_bounded();
    if (const auto passage = are_bounded ? passage_of(still, moving, motion) : Passage{0, motion.length}) {
      met.emplace_back(passage->enter, child);
    }
  });
  std::ranges::sort(met);
  for (const auto& [enter, child] : met) {
    if (enter > search.limit()) {
      return;
    }
    CastNames of_child = names;
    (swapped ? of_child.child_b : of_child.child_a) = child;
    const AnyShape& shape = *a.children()[child].shape;
    const Pose pose = pose_a * a.children()[child].pose;
    swapped ? cast(b, pose_b, shape, pose, of_child, search) : cast(shape, pose, b, pose_b, of_child, search);
  }
}

// Whether a has children, all of which are then cast.
bool cast_children(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, bool swapped,
                   const CastNames& names, CastSearch& search) {
  if (!traits_of(a).is_assembly) {
    return false;
  }
  std::visit(
      [&]<class A>(const A& assembly) {
        if constexpr (Assembly<A>) {
          cast_children_of(assembly, pose_a, b, pose_b, swapped, names, search);
        }
      },
      variant_of(a));
  return true;
}

void cast(const AnyShape& a, const Pose& pose_a, const AnyShape& b, const Pose& pose_b, const CastNames& names,
          CastSearch& search) {
  if (a.has_holes() || b.has_holes()) {
    cast_in_strides(a, pose_a, b, pose_b, names, search);
    return;
  }
  if (cast_children(a, pose_a, b, pose_b, false, names, search) ||
      cast_children(b, pose_b, a, pose_a, true, names, search)) {
    return;
  }
  const auto has_only_distances = [](const AnyShape& shape) {
    return traits_of(shape).is_hole || traits_of(shape).is_sampled;
  };
  if (has_only_distances(a) || has_only_distances(b)) {
    cast_in_strides(a, pose_a, b, pose_b, names, search);
    return;
  }
  const bool from_b = b.index() < a.index();
  const auto cast_parts = pair_kernels(std::min(a.index(), b.index()), std::max(a.index(), b.index())).cast_parts;
  if (cast_parts == nullptr) {
    cast_whole(a, pose_a, b, pose_b, names, search);
  } else if (from_b) {
    cast_parts(b, a, pose_b, pose_a, true, names, search);
  } else {
    cast_parts(a, b, pose_a, pose_b, false, names, search);
  }
}

// Shapes whose contacts at the start say more than a distance: which of their parts overlap, and on which side.
bool is_made_of_parts(const AnyShape& shape) { return traits_of(shape).has_parts || traits_of(shape).is_assembly; }

ShapeCastHit hit_of(const ContactPoint& found, Algorithm algorithm) {
  const Distance contact{found.distance, found.distance, found.distance, found.point_a,
                         found.point_b,  found.normal,   algorithm,      0};
  return {0, contact, found.feature_a, found.feature_b, found.child_a, found.child_b};
}

}  // namespace

Outcome cast_shapes(const AnyShape& a, const Pose& pose_a, const Vec3& displacement_a, const AnyShape& b,
                    const Pose& pose_b, const Vec3& displacement_b, const QuerySettings& settings, Real most,
                    std::optional<ShapeCastHit>& out) {
  if (!is_supported(a.index(), b.index())) {
    return Outcome::unsupported;
  }
  const Pose ab = relative(pose_a, pose_b);
  const Vec3 displacement = pose_a.rotation.undo(displacement_b - displacement_a);
  const Real length = norm(displacement);
  const LinearMotion motion{UnitVec3::make(displacement).value_or(UnitVec3::axis_z()), most * length};
  const Aabb box_a = aabb_of(a, Pose::identity());
  const Real size = size_of(box_a, aabb_of(b, Pose::identity()), ab);
  const Real near = std::max(settings.margin, Real{0}) + rounding_of(size);
  StartingTouch start;
  if ((is_made_of_parts(a) || is_made_of_parts(b)) && box_a.overlaps(aabb_of(b, ab).inflated(near))) {
    const StartSettings its{settings, rounding_of(size), touching_distance(size), length == 0};
    const auto speed_along = [&](const ContactPoint& contact) { return dot(motion.direction, contact.normal); };
    const Outcome outcome = find_starting_touch(a, b, Pose::identity(), ab, its, speed_along, start);
    if (outcome != Outcome::ok) {
      return outcome;
    }
  }
  std::optional<ShapeCastHit> hit;
  if (start.contact) {
    hit = hit_of(*start.contact, settings.algorithm);
  }
  if (!start.stops) {
    CastSearch search(settings, motion, size);
    cast(a, Pose::identity(), b, ab, {}, search);
    if (search.outcome() != Outcome::ok || !search.best()) {
      return search.outcome();
    }
    const CastNames& names = search.names();
    const Real travelled = search.best()->travelled;
    if (travelled > 0 || !hit) {
      hit = ShapeCastHit{travelled > 0 ? std::min(travelled / length, most) : 0,
                         search.best()->contact,
                         names.feature_a,
                         names.feature_b,
                         names.child_a,
                         names.child_b};
    }
  }
  move_by(hit->contact, {pose_a.rotation, pose_a.position + hit->fraction * displacement_a});
  out = hit;
  return Outcome::ok;
}

}  // namespace abut
