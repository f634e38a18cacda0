// How far two convex cores are apart or in each other: closed forms or GJK, and where the cores overlap
// all separating axes or the expanding polytope.
export module abut.narrow.convex.separation;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.box_cores;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.simplex;
export import abut.narrow.convex.overlap;
export import abut.narrow.cores.core_separation;
import abut.narrow.cores.difference;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.sat;
export import abut.narrow.points.witnesses;
import abut.narrow.polytope.polytope_depth;

export namespace abut {

// Below this many sizes the line between projected points is rounding, and GJK's simplex knows it better.
inline constexpr Real projection_limit = 1e-5;

// Whether closed forms found the distance of two cores that are apart, and no square on the way lost digits
// by being tiny.
[[nodiscard]] [[gnu::always_inline]] inline bool is_settled(const NearPoints& near, Real size, Real error) {
  const Real least = projection_limit * size;
  return is_proven(near, error) && near.square > least * least && near.square > 1e-280;
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
[[nodiscard]] inline bool separate_box_cores(const A& a, const B& b, const Pose& ab, Real size, Real error, Real limit,
                                             Vec3& toward, CoreSeparation& core) {
  if constexpr (are_boxes<A, B>) {
    // Whoever wants contacts mostly asks about boxes that overlap, or are known apart by an axis.
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

// Whether the normal of cores that nearly touch is rounding, although their distance was proven on the way.
template <Convex A, Convex B>
[[nodiscard]] inline bool is_turned(const A& a, const B& b, const Pose& ab, const GjkResult& near, Real size,
                                    Real error) {
  constexpr Real near_share = 1e-2;  // of the size, beyond which normals lose too few digits to tell
  if (!(near.upper <= near_share * size)) {
    return false;
  }
  const Vec3 between = placed_support(b, place(b, ab), -near.normal).point - a.support(near.normal).point;
  return dot(near.normal, between) < near.lower - error - noise_of(size);
}

// The closest points and the bounds that a search has found, of cores that are apart.
[[nodiscard]] inline CoreSeparation separation_of(const GjkResult& found, const Vec3& point_a, const Vec3& point_b,
                                                  Real size, std::uint32_t iterations_before) {
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.algorithm = Algorithm::gjk_epa;
  core.iterations = iterations_before + found.iterations;
  core.beyond = found.beyond;
  core.lower = found.lower;
  if (!found.beyond) {
    core.distance = core.upper = found.upper;
    core.normal = found.normal;
    core.point_a = point_a;
    core.point_b = point_b;
  }
  return core;
}

// Of cores that are apart axes bound the distance from below, and points of both from above.
// The points are those under the normal. Between slivers GJK knows better ones.
template <Convex A, Convex B>
[[nodiscard]] bool is_apart_along(const A& a, const B& b, const Pose& ab, const GjkResult& near,
                                  const WeightedPoint& reached, Real size, Real error, CoreSeparation& along) {
  find_points(a, b, ab, along);
  const Real slack = noise_of(size), farthest = along.distance + error + slack;
  const Real apart = norm(along.point_b - along.point_a);
  Real upper = std::fmin(near.upper, apart);
  if (!(apart <= farthest && holds(a, along.point_a, slack) && holds(b, ab.undo(along.point_b), slack))) {
    upper = near.upper;
    if (!(upper <= along.distance + slack)) {
      return false;
    }
    set_points(reached.a, reached.a - near.closest, along);
  }
  along.upper = std::fmax(along.upper, upper);
  along.overlap = false;
  return true;
}

// GJK for any cores, whatever they are, from the direction `toward` on, and where they overlap the best
// way to the depth.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] CoreSeparation separate_by_gjk(const A& a, const B& b, const Pose& ab,
                                                               const QuerySettings& settings, const Vec3& toward,
                                                               Real size, Real error, Real limit) {
  // What the searches for overlaps say of cores that are apart bounds their distance from below only: a coarse bound
  // must not send any there.
  const Real unproven = error_of(a, b, size, QuerySettings{});
  GjkResult near = gjk(a, b, ab, toward, size, error, limit, unproven);
  const auto is_open = [&] {
    return !near.overlap && !near.beyond && near.upper - near.lower > error + noise_of(size);
  };
  if (is_open()) [[unlikely]] {
    // Rounding stopped it short of a proof; from the point that it reached another simplex may go further.
    const GjkResult again = gjk(a, b, ab, -near.closest, size, error, limit, unproven);
    near = again.overlap || again.beyond || again.upper - again.lower < near.upper - near.lower ? again : near;
  }
  if constexpr (Curved<A> || Curved<B>) {
    if (is_open() && near.upper <= projection_limit * size) [[unlikely]] {
      CoreSeparation touch{};
      touch.iterations = near.iterations;
      const bool touches = with_difference(a, b, ab, size, [&](const Difference& cores) {
        return separate_by_touch(cores, error, near.simplex, touch) ||
               separate_by_touch(cores, error, Simplex{}, touch);
      });
      if (touches) {
        return touch;
      }
    }
  }
  if (near.beyond) {
    return separation_of(near, {0, 0, 0}, {0, 0, 0}, size, 0);
  }
  // The foot on a sliver is off where its normal is: it lies in the plane of the sliver, and not on it.
  const WeightedPoint reached =
      near.overlap ? WeightedPoint{} : point_with(near.simplex, weights_of(near.simplex, near.closest));
  if (!near.overlap && largest_magnitude(reached.w - near.closest) > error + noise_of(size)) [[unlikely]] {
    near.upper = infinity;
  }
  const bool is_off = !near.overlap && is_turned(a, b, ab, near, size, error);
  const bool is_unproven = !near.overlap && (!(near.lower > 0) || near.upper - near.lower > error + noise_of(size) ||
                                             (is_off && !Curved<A> && !Curved<B>));
  if (near.overlap || is_unproven) {
    CoreSeparation along{};
    if (settings.algorithm != Algorithm::gjk_epa && separate_by_axes(a, b, ab, size, along)) {
      along.iterations += near.iterations;
      if (is_touch(along, size)) {
        find_touch(near.simplex, error, along);
      }
      if (near.overlap || (along.distance <= error && !(near.lower > error))) {
        return along;
      }
      if constexpr ((FewFaced<A> && FewFaced<B>) || has_hull<A, B>) {
        if (is_apart_along(a, b, ab, near, reached, size, error, along)) {
          return along;
        }
      }
    }
  }
  if (!near.overlap && (is_unproven || is_off)) [[unlikely]] {
    const WideGjkResult wide = with_difference(a, b, ab, size, [&](const Difference& cores) {
      return wide_gjk(cores, -near.closest, error, limit, unproven);
    });
    if (!wide.gjk.overlap) {
      return separation_of(wide.gjk, wide.point_a, wide.point_b, size, near.iterations);
    }
    near.overlap = true;
    near.simplex = wide.gjk.simplex;
    near.iterations += wide.gjk.iterations;
  }
  if (!near.overlap) {
    return separation_of(near, reached.a, reached.a - near.closest, size, 0);
  }
  CoreSeparation core{};
  core.iterations = near.iterations;
  const bool is_proven = settings.algorithm != Algorithm::gjk_epa && separate_by_discs(a, b, ab, size, error, core);
  const auto is_wide = [&] { return core.upper - core.lower > error + noise_of(size); };
  if (!is_proven || is_wide()) {
    WideGjkResult wide{};
    const bool is_apart = with_difference(a, b, ab, size, [&](const Difference& cores) {
      if (!is_proven) {
        separate_by_polytope(cores, error, near.simplex, core);
      }
      if (!is_wide()) {
        return false;
      }
      // Rounding may have taken slivers that are apart for ones that overlap.
      wide = wide_gjk(cores, core.normal, error, limit, unproven);
      return !wide.gjk.overlap && (wide.gjk.beyond || wide.gjk.upper - wide.gjk.lower <= error + noise_of(size));
    });
    if (is_apart) {
      return separation_of(wide.gjk, wide.point_a, wide.point_b, size, core.iterations);
    }
  }
  core.overlap = true;
  if (Curved<A> || Curved<B> ? std::fabs(core.distance) <= error : is_touch(core, size)) {
    find_touch(near.simplex, error, core);
  }
  return core;
}

// `limit`: the caller only wants to know how near the cores are when they are nearer than this.
template <Convex A, Convex B>
[[nodiscard]] inline CoreSeparation separate_cores(const A& a, const B& b, const Pose& ab,
                                                   const QuerySettings& settings, Real limit) {
  const Real size = core_size(a, b, ab);
  const Real error = error_of(a, b, size, settings);
  if constexpr (are_point_and_field<A, B>) {
    if (takes_closed_forms(settings.algorithm)) {
      CoreSeparation core = separate_point(a, b, ab, size);
      core.beyond = core.lower > limit;
      return core;
    }
  }
  Vec3 toward = placed_centre(b, ab) - a.centre();
  if constexpr (BoxCored<A> && BoxCored<B>) {
    CoreSeparation core{};
    core.rounding = rounding_of(size);
    if (takes_closed_forms(settings.algorithm) && separate_box_cores(a, b, ab, size, error, limit, toward, core)) {
      return core;
    }
    const std::uint32_t iterations = core.iterations;
    core = separate_by_gjk(a, b, ab, settings, toward, size, error, limit);
    core.iterations += iterations;
    return core;
  } else {
    return separate_by_gjk(a, b, ab, settings, toward, size, error, limit);
  }
}

}  // namespace abut
