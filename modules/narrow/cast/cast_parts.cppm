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
import abut.narrow.cast.linear_cast;
import abut.narrow.cast.parts_in_order;
import abut.narrow.convex;
import abut.trees.two_trees;

export namespace abut {

[[nodiscard]] inline LinearMotion seen_from_b(const LinearMotion& motion, const Pose& ab) {
  return {UnitVec3::from_unit_unchecked(ab.rotation.undo(-motion.direction)), motion.length};
}

// Whether a touch is on a side that stops. Of one-sided triangles in which a shape starts, the contacts have told
// already whether it came from the front. `outward`: the normal before the touch, from the part.
template <class Part>
[[nodiscard]] bool stops(const Part& part, const FirstTouch& touch, const Vec3& outward) {
  if constexpr (requires { part.is_one_sided(); }) {
    // Rounding must not open edges of triangles that stand upright.
    return !part.is_one_sided() || (touch.travelled > 0 && dot(part.normal(), outward) > -noise_of(1));
  } else {
    return true;
  }
}

template <Convex A, Convex B>
void cast_part(CastSearch& search, const A& part, const B& b, const Pose& ab, const LinearMotion& motion,
               const Pose& frame, bool swapped, const CastNames& names) {
  std::optional<FirstTouch> touch;
  const Outcome outcome = first_touch(
      {motion.direction, search.limit()}, search.size(), search.settings().margin,
      [&](Real way, Distance& out) { return convex_distance(part, b, moved(ab, motion, way), search.settings(), out); },
      [&](const Vec3& normal) { return -reach(b, ab, -normal) - reach(part, Pose::identity(), normal); }, touch);
  if (touch &&
      !(stops(part, *touch, touch->normal_before) && stops(b, *touch, ab.rotation.undo(-touch->normal_before)))) {
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
