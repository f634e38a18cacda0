// SPDX-License-Identifier: Apache-2.0
// How far two cores are apart or in each other, where closed forms know it: boxes, segments and points, and a point
// beside a core that knows its nearest surface point.
export module abut.narrow.convex.closed_cores;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.box_cores;
export import abut.narrow.apart.search_bounds;
export import abut.narrow.convex.overlap;
export import abut.narrow.cores.core_separation;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.sat;
export import abut.narrow.points.witnesses;

export namespace abut {

// Below this many sizes the line between projected points is rounding, and GJK's simplex knows it better.
inline constexpr Real projection_limit = 1e-5;

// Smaller squares have lost digits.
inline constexpr Real least_square = 1e-280;

// Whether closed forms found the distance of two cores that are apart.
[[nodiscard]] [[gnu::always_inline]] inline bool is_settled(const NearPoints& near, Real size, Real error) {
  const Real least = projection_limit * size;
  return is_proven(near, error) && near.square > least * least && near.square > least_square;
}
[[nodiscard]] [[gnu::always_inline]] inline CoreSeparation separation_of(const NearPoints& near, Real size) {
  // The root and the division run side by side.
  const Real distance = std::sqrt(near.square), inverse = distance * (1 / near.square);
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.algorithm = Algorithm::analytic;
  core.iterations = near.rounds;
  core.distance = core.upper = distance;
  core.lower = distance - near.gap * inverse;
  core.normal = vec3_of(near.between * inverse);
  core.point_a = vec3_of(near.on_a);
  core.point_b = vec3_of(near.on_b);
  return core;
}

// Boxes, segments and points, without GJK. False when rounding or too slow progress leaves the answer
// to it; `toward` is then the direction from a to b that was reached.
template <BoxCored A, BoxCored B>
[[nodiscard]] inline bool separate_box_cores(const A& a, const B& b, const Pose& ab, const SearchBounds& bounds,
                                             Vec3& toward, CoreSeparation& core) {
  const auto& [size, error, limit, unproven] = bounds;
  if constexpr (are_boxes<A, B>) {
    // Contacts are mostly asked of boxes that overlap, or that an axis shows to be apart.
    if (limit < infinity) {
      const SatResult found = sat_of_boxes(a.half(), b.half(), ab, noise_of(size), limit);
      core.lower = found.separation;
      core.beyond = found.separation > limit;
      if (core.beyond) {
        return true;
      }
      if (found.separation <= touching_distance(size)) {
        core = separation_along(a, b, ab, found, size);
        if (is_touch(core, size)) {
          // Where the steps end short of the common point the faces have it.
          const NearPoints near = near_points(a, b, ab, error);
          if (near.square <= noise_of(size) * noise_of(size)) {
            touch_at(vec3_of(near.on_a), vec3_of(near.on_b), core);
          }
        }
        return true;
      }
    }
  }
  const NearPoints near = near_points(a, b, ab, error);
  if (near.square == 0) {
    core = separate_by_sat(a, b, ab, size);
    core.iterations += near.rounds;
    if (is_touch(core, size)) {
      touch_at(vec3_of(near.on_a), vec3_of(near.on_b), core);
    }
    return true;
  }
  if (!is_settled(near, size, error)) {
    core.iterations = near.rounds;
    toward = vec3_of(near.between);
    return false;
  }
  core = separation_of(near, size);
  core.beyond = core.lower > limit;
  return true;
}

// A point against a core that knows its nearest surface point: exact, apart or not.
template <class A, class B>
inline constexpr bool are_point_and_field = (PointCored<A> && Field<B>) || (Field<A> && PointCored<B>);

template <Convex A, Convex B>
  requires are_point_and_field<A, B>
[[nodiscard]] [[gnu::always_inline]] inline CoreSeparation separate_point(const A& a, const B& b, const Pose& ab,
                                                                          Real size) {
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.algorithm = Algorithm::analytic;
  core.iterations = 1;
  if constexpr (PointCored<A>) {
    const SurfacePoint near = b.nearest(-ab.rotation.undo(ab.position));
    core.distance = near.distance;
    core.normal = -(ab.rotation * near.normal);
    core.point_a = {0, 0, 0};
    core.point_b = near.distance * core.normal;
  } else {
    const SurfacePoint near = a.nearest(ab.position);
    core.distance = near.distance;
    core.normal = near.normal;
    core.point_a = near.point;
    core.point_b = ab.position;
  }
  core.lower = core.upper = core.distance;
  core.overlap = !(core.distance > 0);
  return core;
}

}  // namespace abut
