// SPDX-License-Identifier: Apache-2.0
// Closed forms of two convex shapes that are both placed in the world. A point looks the same from everywhere, and a
// segment is known by its axis. Such pairs are answered without turning one into the frame of the other and back.
export module abut.narrow.convex.placed_pair;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.apart.segment_cores;
import abut.narrow.convex;
import abut.narrow.points.clip;
import abut.narrow.points.lane_contact;

export namespace abut {

// Pairs of which the first shape is a point and the second a box, a segment or a point.
template <class A, class B>
inline constexpr bool is_point_beside = PointCored<A> && BoxCored<B>;

// The pose of b in a frame around a that is not turned.
[[nodiscard]] [[gnu::always_inline]] inline Pose shifted(const Pose& pose_a, const Pose& pose_b) {
  return {pose_b.rotation, pose_b.position - pose_a.position};
}

// False where closed forms leave the pair to a search. The answer is in the world.
template <Convex A, Convex B>
  requires have_closed_form<A, B>
[[nodiscard]] [[gnu::always_inline]] inline bool distance_of_placed(const A& a, const B& b, const Pose& pose_a,
                                                                    const Pose& pose_b, bool swapped,
                                                                    const QuerySettings& settings, Distance& out) {
  [[clang::uninitialized]] CoreSeparation core;
  const Pose ab = is_point_beside<A, B> ? shifted(pose_a, pose_b) : relative(pose_a, pose_b);
  if (!takes_closed_forms(settings.algorithm) || !separate_in_closed_form(a, b, ab, settings, core)) {
    return false;
  }
  [[clang::uninitialized]] Distance found = rounded(core, a.radius(), b.radius());
  if constexpr (is_point_beside<A, B>) {
    move_by(found, pose_a.position, swapped);
  } else {
    move_by(found, pose_a, swapped);
  }
  out = found;
  return true;
}

// Two segments that are not nearly parallel, and so have one contact.
template <Convex A, Convex B, class Append>
  requires SegmentCored<A> && SegmentCored<B>
[[nodiscard]] [[gnu::always_inline]] inline bool contacts_of_segments(const A& a, const B& b, const Pose& pose_a,
                                                                      const Pose& pose_b, const QuerySettings& settings,
                                                                      Append&& append) {
  const Pose ab = shifted(pose_a, pose_b);
  const Lanes axis_a = lanes_of(pose_a.rotation.z), axis_b = lanes_of(pose_b.rotation.z),
              across = cross(axis_a, axis_b);
  const Real square = dot(across, across);
  if (!takes_closed_forms(settings.algorithm) || !(square > parallel_sine * parallel_sine)) {
    return false;
  }
  const Real size = core_size(a, b, ab), error = error_of(a, b, size, settings);
  const NearPoints near =
      near_points_of_segments({axis_a, a.half().z}, {axis_b, b.half().z}, lanes_of(ab.position), square);
  if (!is_settled(near, size, error)) {
    return false;
  }
  if (near.square > square_beyond(settings.margin, a.radius() + b.radius())) {
    return true;
  }
  const CoreSeparation core = separation_of(near, size);
  contact_under(a, b, core, supporting_feature(a, core.normal), supporting_feature(b, core.normal), settings.margin,
                [&](const LaneContact& contact) { append(moved_by(contact, pose_a.position)); });
  return true;
}

// Hands over the contacts in the world one by one, all or none. False as above.
template <Convex A, Convex B, class Append>
  requires have_closed_contacts<A, B>
[[nodiscard]] [[gnu::always_inline]] inline bool contacts_of_placed(const A& a, const B& b, const Pose& pose_a,
                                                                    const Pose& pose_b, const QuerySettings& settings,
                                                                    Append&& append) {
  if constexpr (SegmentCored<A> && SegmentCored<B>) {
    return contacts_of_segments(a, b, pose_a, pose_b, settings, append);
  } else if constexpr (is_point_beside<A, B>) {
    return contacts_in_closed_form(a, b, shifted(pose_a, pose_b), settings,
                                   [&](const LaneContact& contact) { append(moved_by(contact, pose_a.position)); });
  } else {
    return contacts_in_closed_form(a, b, relative(pose_a, pose_b), settings,
                                   [&](const LaneContact& contact) { append(moved_by(contact, pose_a)); });
  }
}

}  // namespace abut
