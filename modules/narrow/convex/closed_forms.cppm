// SPDX-License-Identifier: Apache-2.0
// Closed forms of the separation and the contacts of two convex shapes, from cores that have them.
export module abut.narrow.convex.closed_forms;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.apart.gjk;
import abut.narrow.convex.separation;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;
import abut.narrow.points.box_contacts;
import abut.narrow.points.clip;
import abut.narrow.points.lane_contact;

export namespace abut {

template <class A, class B>
inline constexpr bool have_closed_form = are_point_and_field<A, B> || (BoxCored<A> && BoxCored<B>);

// False where closed forms leave the pair to a search. Those of cores that are too near for them end as soon as that
// shows.
template <Convex A, Convex B>
  requires have_closed_form<A, B>
[[nodiscard]] [[gnu::always_inline]] inline bool separate_in_closed_form(const A& a, const B& b, const Pose& ab,
                                                                         const QuerySettings& settings,
                                                                         CoreSeparation& core) {
  const Real size = core_size(a, b, ab);
  if constexpr (are_point_and_field<A, B>) {
    core = separate_point(a, b, ab, size);
    return true;
  } else {
    const Real error = error_of(a, b, size, settings);
    const NearPoints near = near_points(a, b, ab, error, projection_limit * size);
    if (!is_settled(near, size, error)) [[unlikely]] {
      return false;
    }
    core = separation_of(near, size);
    return true;
  }
}

// Whether two cores cannot have more than a point in common.
template <Convex A, Convex B>
[[nodiscard]] inline bool meet_in_a_point(const Pose& ab) {
  if constexpr (PointCored<A> || PointCored<B>) {
    return true;
  } else if constexpr (SegmentCored<A> && SegmentCored<B>) {
    const Vec3& axis = ab.rotation.z;
    return axis.x * axis.x + axis.y * axis.y > parallel_sine * parallel_sine;
  } else {
    return false;
  }
}

// Pairs of shapes that mostly touch in one point, which a closed form finds.
template <class A, class B>
inline constexpr bool touch_in_a_point =
    have_closed_form<A, B> && (PointCored<A> || PointCored<B> || (SegmentCored<A> && SegmentCored<B>));
template <class A, class B>
inline constexpr bool have_closed_contacts = touch_in_a_point<A, B> || are_boxes<A, B>;

// What the square of the distance of two cores exceeds only where they are beyond the margin in spite of all rounding.
// It tells most pairs that do not touch: the root that would say how far they are takes as long as all the rest.
[[nodiscard]] [[gnu::always_inline]] inline Real square_beyond(Real margin, Real radii) {
  const Real reach = margin + radii + rounding_of(std::fabs(margin) + radii);
  return reach * std::fabs(reach);
}

// Hands over the one contact under a separation, if it is within the margin.
template <Convex A, Convex B, class Append>
[[gnu::always_inline]] inline void contact_under(const A& a, const B& b, const CoreSeparation& core,
                                                 const Feature& feature_a, const Feature& feature_b, Real margin,
                                                 Append&& append) {
  const Real distance = core.distance - (a.radius() + b.radius());
  if (distance <= margin) {
    append(LaneContact{lanes_of(core.point_a + a.radius() * core.normal),
                       lanes_of(core.point_b - b.radius() * core.normal), lanes_of(core.normal), distance, feature_a,
                       feature_b, contact_id(feature_a, feature_b)});
  }
}

// Whether a point and a field are beyond the margin, as far as comparisons tell. Some fields know without a root that a
// point is further from them than a reach; where rounding matters they say no.
template <Convex A, Convex B>
  requires are_point_and_field<A, B>
[[nodiscard]] [[gnu::always_inline]] inline bool is_point_beyond(const A& a, const B& b, const Pose& ab, Real margin) {
  const Real radii = a.radius() + b.radius(), reach = margin + radii + rounding_of(std::fabs(margin) + radii);
  if constexpr (PointCored<A> && requires { b.is_beyond(ab.position, reach); }) {
    return b.is_beyond(-ab.rotation.undo(ab.position), reach);
  } else if constexpr (PointCored<B> && requires { a.is_beyond(ab.position, reach); }) {
    return a.is_beyond(ab.position, reach);
  } else {
    return false;
  }
}

// Hands over the contacts one by one, all or none. False where closed forms leave the pair to a search.
template <Convex A, Convex B, class Append>
  requires touch_in_a_point<A, B>
[[nodiscard]] [[gnu::always_inline]] inline bool contacts_in_closed_form(const A& a, const B& b, const Pose& ab,
                                                                         const QuerySettings& settings,
                                                                         Append&& append) {
  if (!takes_closed_forms(settings.algorithm) || !meet_in_a_point<A, B>(ab)) {
    return false;
  }
  const Real size = core_size(a, b, ab);
  [[clang::uninitialized]] CoreSeparation core;
  if constexpr (are_point_and_field<A, B>) {
    if (is_point_beyond(a, b, ab, settings.margin)) {
      return true;
    }
    core = separate_point(a, b, ab, size);
  } else {
    const Real error = error_of(a, b, size, settings);
    const NearPoints near = near_points(a, b, ab, error);
    if (!is_settled(near, size, error)) {
      return false;
    }
    if (near.square > square_beyond(settings.margin, a.radius() + b.radius())) {
      return true;
    }
    core = separation_of(near, size);
  }
  contact_under(a, b, core, supporting_feature(a, core.normal), supporting_feature(b, ab.rotation.undo(-core.normal)),
                settings.margin, append);
  return true;
}

// Boxes that overlap. Those that are apart within the margin seldom face each other along one of the axes.
template <Convex A, Convex B, class Append>
  requires are_boxes<A, B>
[[nodiscard]] [[gnu::always_inline]] inline bool contacts_in_closed_form(const A& a, const B& b, const Pose& ab,
                                                                         const QuerySettings& settings,
                                                                         Append&& append) {
  if (settings.algorithm != Algorithm::automatic) {
    return false;
  }
  const Real size = core_size(a, b, ab), limit = settings.margin + (a.radius() + b.radius());
  const SatResult found = sat_of_boxes(a.half(), b.half(), ab, noise_of(size), limit);
  if (found.separation > limit) {
    return true;
  }
  [[clang::uninitialized]] BoxRegion region;
  if (found.separation > touching_distance(size) ||
      !clip_boxes(a.half(), b.half(), ab, found.normal, found.separation, limit, size, region)) {
    return false;
  }
  contacts_of_region(region, found.normal, a.radius(), b.radius(), append);
  return true;
}

}  // namespace abut
