// SPDX-License-Identifier: Apache-2.0
// The casts that can be told from the types of two shapes: of convex ones and of those that are made of convex parts.
// The parts of the latter are cast in the order in which their boxes are met: the normal of one part says nothing of
// the others.
export module abut.narrow.cast.cast_parts;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cast.cast_search;
import abut.narrow.cast.front_touch;
import abut.narrow.cast.linear_cast;
import abut.narrow.cast.parts_in_order;
import abut.narrow.convex;
import abut.trees.boxes.two_trees;

export namespace abut {

[[nodiscard]] inline LinearMotion seen_from_b(const LinearMotion& motion, const Pose& ab) {
  return {UnitVec3::from_unit_unchecked(ab.rotation.undo(-motion.direction)), motion.length};
}

// The side from which a part stops what touches it, as a direction from the first part to the second; nothing where
// all sides stop. `turned`: how the part is turned.
template <class Part>
[[nodiscard]] std::optional<Vec3> front_of([[maybe_unused]] const Part& part, [[maybe_unused]] const Rotation& turned,
                                           [[maybe_unused]] Real sign) {
  if constexpr (requires { part.is_one_sided(); }) {
    return part.is_one_sided() ? std::optional(sign * (turned * part.normal())) : std::nullopt;
  } else {
    return std::nullopt;
  }
}

// How far two parts that touch may reach beyond the plane between them.
template <Convex A, Convex B>
[[nodiscard]] Real slack_of_planes(const A& a, const B& b, const Pose& ab, const CastSearch& search) {
  constexpr Real bounds = Curved<A> || Curved<B> ? 8 : 0;
  return rounding_of(search.size()) + bounds * bound_of_curves(search.settings()) * core_size(a, b, ab);
}

template <Convex A, Convex B>
void cast_part(CastSearch& search, const A& part, const B& b, const Pose& ab, const LinearMotion& motion,
               const Pose& frame, bool swapped, const CastNames& names) {
  std::optional<FirstTouch> touch;
  const Real margin = search.settings().margin;
  const auto gap_along = [&](const Vec3& normal) {
    return -reach(b, ab, -normal) - reach(part, Pose::identity(), normal);
  };
  const Outcome outcome = first_touch(
      {motion.direction, search.limit()}, search.size(), margin,
      [&](Real way, Distance& out) { return convex_distance(part, b, moved(ab, motion, way), search.settings(), out); },
      gap_along, touch);
  const auto is_stopped_by = [&](const std::optional<Vec3>& front) {
    if (!front) {
      return true;
    }
    const bool is_later = touch->travelled > 0;
    const Vec3& normal = is_later ? touch->normal_before : touch->contact.normal;
    return stops({*front, normal, gap_along(*front) - margin, gap_along(normal) - margin, is_later}, motion.direction,
                 slack_of_planes(part, b, ab, search));
  };
  if (touch &&
      !(is_stopped_by(front_of(part, Rotation::identity(), 1)) && is_stopped_by(front_of(b, ab.rotation, -1)))) {
    touch.reset();
  }
  search.add(outcome, touch, frame, swapped, names);
}

// Two surfaces: their parts in the order in which the boxes of both trees meet.
template <Surface A, Surface B>
void cast_surfaces(CastSearch& search, const A& a, const B& b, const Pose& ab, const LinearMotion& motion,
                   const Pose& frame, bool swapped, const CastNames& names) {
  const PassageOrder order(a.origin(), b.origin(), ab, motion.direction, search.slack());
  visit_two(a, b, order, search.limit(), [&](std::uint32_t of_a, std::uint32_t of_b) {
    CastNames of_parts = names;
    (swapped ? of_parts.feature_b : of_parts.feature_a) = {FeatureKind::face, of_a};
    (swapped ? of_parts.feature_a : of_parts.feature_b) = {FeatureKind::face, of_b};
    cast_part(search, a.part(of_a), b.part(of_b), ab, motion, frame, swapped, of_parts);
    return search.limit();
  });
}

// a is made of parts and placed by `frame`; b, which is so too or convex, moves in it from ab on.
template <class A, class B>
  requires has_parts<A>
void cast_parts(CastSearch& search, const A& a, const B& b, const Pose& ab, const LinearMotion& motion,
                const Pose& frame, bool swapped, const CastNames& names) {
  const auto cast_one = [&](const PartMet<typename A::Part>& met) {
    CastNames of_part = names;
    Feature& feature = swapped ? of_part.feature_b : of_part.feature_a;
    std::uint32_t& child = swapped ? of_part.child_b : of_part.child_a;
    if constexpr (Surface<A>) {
      feature = {FeatureKind::face, met.index};
    } else {
      feature = {FeatureKind::particle, met.index};
      child = met.index;
    }
    const Pose at{frame.rotation, frame * met.place};
    const Pose from_part{ab.rotation, ab.position - met.place};
    if constexpr (Convex<B>) {
      cast_part(search, core_of(met.part), b, from_part, motion, at, swapped, of_part);
    } else {
      cast_parts(search, b, core_of(met.part), from_part.inverse(), seen_from_b(motion, ab), at * from_part, !swapped,
                 of_part);
    }
  };
  // One reference fits into a function itself: no memory is asked for.
  visit_in_order(a, b.aabb(ab), motion, search.slack(), search.limit(),
                 PartVisitor<A>([&cast_one](const PartMet<typename A::Part>& met) { cast_one(met); }));
}

}  // namespace abut
