// SPDX-License-Identifier: Apache-2.0
// Closest points of two cores that are boxes, segments or points, without a simplex.
//
// - Two boxes: each is projected on the other in turn (von Neumann's alternating projections). Between a corner and a
//   face the points stand still after one step. Between two edges the steps shrink by a constant factor, which the step
//   before tells. All steps to come are taken at once.
// - A box and a segment: Newton's method on the derivative of the distance along the segment, which is piecewise
// linear.
//
// Both end as GJK does, by the duality gap: the distance of the points less the gap of the cores along the line between
// them. Where that stays open after a few rounds, the caller goes on with GJK.
export module abut.narrow.apart.box_cores;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// Two points in the frame of the first core; the distance of the cores lies between
// (square - gap) / sqrt(square) and sqrt(square).
struct NearPoints {
  Lanes on_a, on_b;
  Lanes between;  // from a to b
  Real square;    // of their distance
  Real gap;
  std::uint32_t rounds;
};

// Within `error` of the distance? Then the points are the answer.
[[nodiscard]] [[gnu::always_inline]] inline bool is_proven(const NearPoints& near, Real error) {
  return near.gap * near.gap <= error * error * near.square;
}

// Three in four random pairs of boxes are proven in the first round, one in a hundred after the third.
inline constexpr std::uint32_t projection_rounds = 6;

// Two boxes, the second one placed in the frame of the first.
struct BoxPair {
  Lanes a, b;    // half extents
  Lanes centre;  // of b
  Lanes back;    // centre of a in the frame of b
  LaneMatrix columns, rows;

  [[gnu::always_inline]] inline BoxPair(const Vec3& half_a, const Vec3& half_b, const Pose& ab)
      : a(lanes_of(half_a)),
        b(lanes_of(half_b)),
        centre(lanes_of(ab.position)),
        columns(LaneMatrix::columns_of(ab.rotation)),
        rows(LaneMatrix::rows_of(ab.rotation)) {
    back = -(rows * centre);
  }

  // The point of b nearest to one of the frame of a, in the frame of b; and from there to a.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes on_b(Lanes p) const { return clamp(rows.apply(p, back), b); }
  [[nodiscard]] [[gnu::always_inline]] inline Lanes from_b(Lanes p) const { return columns.apply(p, centre); }

  // How many steps of a point within +-half there is room for in the directions that it is free in.
  [[nodiscard]] [[gnu::always_inline]] static inline Real room(Lanes half, Lanes point, Lanes step) {
    const Lanes room = (half - (step > 0 ? point : -point)) / absolute(step);
    const Lanes moving = absolute(point) < half && step != Lanes(0) ? room : all_lanes(infinity);
    return -largest(-moving);
  }

  // One round from a point of a. Where it is `careful`, neither point goes on beyond the end of what it
  // moves along: going further is faster mostly, and for ever to and fro sometimes.
  template <bool careful>
  [[gnu::always_inline]] inline void project(Lanes start, NearPoints& near) const {
    const Lanes first = clamp(from_b(on_b(start)), a);
    const Lanes local = on_b(first);
    const Lanes second = clamp(from_b(local), a);
    // A step along b loses what leaves its free directions: the next one is that much shorter, and so
    // on. The steps from `first` add up to the first of them over the lost share.
    const Lanes step = first - start, step_in_b = rows * step;
    const Lanes leaving = absolute(local) < b ? Lanes(0) : step_in_b;
    const Real square = dot(step, step), lost = dot(leaving, leaving);
    Real times = lost > 0 ? square / lost : 0;
    const Lanes next = second - first;
    if constexpr (careful) {
      const Real on_a = room(a, second, next), on_b = room(b, local, rows * next);
      times = on_a < times ? on_a : times;
      times = on_b < times ? on_b : times;
    }
    const Lanes nearest = on_b(clamp(multiply_add(next, all_lanes(times), first), a));
    near.on_b = from_b(nearest);
    near.on_a = clamp(near.on_b, a);
    near.between = near.on_b - near.on_a;
    near.square = dot(near.between, near.between);
    // The point on a is the nearest to the one on b, so that only b may reach further.
    const Lanes along = rows * near.between;
    near.gap = sum(multiply_add(b, absolute(along), along * nearest));
  }
};

// A box of half extents `half_a` and one of `half_b` placed by ab. Points that are nearer than `least` will do.
[[nodiscard]] [[gnu::always_inline]] inline NearPoints near_points_of_boxes(const Vec3& half_a, const Vec3& half_b,
                                                                            const Pose& ab, Real error, Real least) {
  const BoxPair boxes(half_a, half_b, ab);
  [[clang::uninitialized]] NearPoints near;
  boxes.project<false>(clamp(boxes.centre, boxes.a), near);
  for (near.rounds = 1; !is_proven(near, error) && near.square >= least * least && near.rounds < projection_rounds;
       ++near.rounds) {
    boxes.project<true>(near.on_a, near);
  }
  return near;
}

// Newton ends in the piece of the minimum after one round in each piece on the way, mostly one or two.
inline constexpr std::uint32_t newton_rounds = 3;

// A box of half extents `half` and the segment centre +- half_length * axis, the axis of length one.
[[nodiscard]] [[gnu::always_inline]] inline NearPoints near_points_of_segment(const Vec3& half, Lanes centre,
                                                                              Lanes axis, Real half_length,
                                                                              Real error) {
  const Lanes box = lanes_of(half);
  const auto limited = [&](Real s) { return s < -half_length ? -half_length : s > half_length ? half_length : s; };

  [[clang::uninitialized]] NearPoints near;
  Real s = half_length > 0 ? limited(-dot(centre, axis)) : 0;
  for (near.rounds = 1;; ++near.rounds) {
    near.on_b = multiply_add(axis, all_lanes(s), centre);
    near.on_a = clamp(near.on_b, box);
    near.between = near.on_b - near.on_a;
    near.square = dot(near.between, near.between);
    const Real slope = dot(axis, near.between);
    // As above: what the end of the segment would reach beyond the point.
    near.gap = half_length * std::fabs(slope) + slope * s;
    if (is_proven(near, error) || near.rounds > newton_rounds) {
      return near;
    }
    const Lanes outside = near.between != Lanes(0) ? axis : Lanes(0);
    s = limited(s - slope / dot(outside, outside));
  }
}

// A box of half extents `half` and a point.
[[nodiscard]] [[gnu::always_inline]] inline NearPoints near_points_of_point(const Vec3& half, Lanes point) {
  const Lanes on_box = clamp(point, lanes_of(half)), between = point - on_box;
  return {on_box, point, between, dot(between, between), 0, 1};
}

// The nearest points of a point or a segment placed by ab and of a box of half extents `half` in its frame.
template <BoxCored B>
[[nodiscard]] [[gnu::always_inline]] inline NearPoints near_points_in_box(const Vec3& half, const B& b, Lanes position,
                                                                          Lanes axis, Real error) {
  if constexpr (PointCored<B>) {
    return near_points_of_point(half, position);
  } else {
    return near_points_of_segment(half, position, axis, b.half().z, error);
  }
}

// `least`: who cannot use points that are nearer to each other does not need the nearest.
template <BoxCored A, BoxCored B>
[[nodiscard]] [[gnu::always_inline]] inline NearPoints near_points(const A& a, const B& b, const Pose& ab, Real error,
                                                                   Real least = 0) {
  if constexpr (PointCored<A> && PointCored<B>) {
    const Lanes between = lanes_of(ab.position);
    return {Lanes(0), between, between, dot(between, between), 0, 1};
  } else if constexpr (A::core_axes == 3 && B::core_axes == 3) {
    return near_points_of_boxes(a.half(), b.half(), ab, error, least);
  } else if constexpr (B::core_axes < 3) {
    return near_points_in_box(a.half(), b, lanes_of(ab.position), lanes_of(ab.rotation.z), error);
  } else {
    // The same in the frame of the box, and back.
    const LaneMatrix columns = LaneMatrix::columns_of(ab.rotation), rows = LaneMatrix::rows_of(ab.rotation);
    const Lanes position = lanes_of(ab.position);
    NearPoints near = near_points_in_box(b.half(), a, -(rows * position), rows.z, error);
    near.on_b = columns.apply(near.on_a, position);
    near.between = -(columns * near.between);
    near.on_a = near.on_b - near.between;
    return near;
  }
}

}  // namespace abut
