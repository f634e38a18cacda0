// SPDX-License-Identifier: Apache-2.0
// The first touch of two boxes: separating axes tell when, and the axes at that time tell where.
export module abut.narrow.cast.box_cast;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cast.cast_parts;
import abut.narrow.cast.cast_search;
import abut.narrow.cast.linear_cast;
import abut.narrow.cast.swept_boxes;
import abut.narrow.convex;

export namespace abut {

// The contact of two boxes that touch at a pose. Nothing where they are apart or overlap by more than `touching`.
template <Convex A, Convex B>
[[nodiscard]] std::optional<Distance> contact_of_boxes(const A& a, const B& b, const Pose& ab,
                                                       const QuerySettings& settings, Real touching) {
  CoreSeparation core{};
  Vec3 toward{0, 0, 0};
  // A limit makes it try the axes first.
  const SearchBounds bounds = search_bounds(a, b, ab, settings, touching);
  if (!separate_box_cores(a, b, ab, bounds, toward, core) || core.beyond || !(std::fabs(core.distance) <= touching)) {
    return std::nullopt;
  }
  find_points(a, b, ab, core);
  return rounded(core, a.radius(), b.radius());
}

// As cast_part does for any convex shapes, which it falls back to: for boxes that overlap at the start, for those that
// come no nearer than a margin, and where rounding leaves the touch in doubt.
template <Convex A, Convex B>
  requires are_boxes<A, B>
void cast_boxes(CastSearch& search, const A& a, const B& b, const Pose& ab, const LinearMotion& motion,
                const Pose& frame, bool swapped, const CastNames& names) {
  const Real touching = touching_after(search.size(), motion.length);
  if (search.settings().margin == 0 && a.radius() + b.radius() == 0) {
    const Passage passage = passage_of_boxes(a.half(), b.half(), ab, motion, 0.5 * touching);
    if (passage.enter > passage.leave || passage.enter > motion.length || passage.leave < 0) {
      search.add(Outcome::ok, std::nullopt, frame, swapped, names);
      return;
    }
    if (passage.enter > 0) {
      const Pose there = moved(ab, motion, passage.enter);
      if (const auto contact = contact_of_boxes(a, b, there, search.settings(), touching)) {
        search.add(Outcome::ok,
                   FirstTouch{passage.enter, turned_against(motion.direction, *contact, touching), contact->normal},
                   frame, swapped, names);
        return;
      }
    }
  }
  cast_part(search, a, b, ab, motion, frame, swapped, names);
}

}  // namespace abut
