// SPDX-License-Identifier: Apache-2.0
// How far two convex cores are apart or in each other, stage by stage: closed forms, GJK, and where the cores overlap
// or rounding stops GJK all separating axes, GJK with more digits, discs or the expanding polytope.
export module abut.narrow.convex.separation;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
export import abut.narrow.convex.closed_cores;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.sat;
import abut.narrow.polytope.polytope_depth;

export namespace abut {

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

// Whether a search has proven its closest points.
template <Convex A, Convex B>
[[nodiscard]] inline bool is_proven(const A& a, const B& b, const Pose& ab, const GjkResult& near,
                                    const SearchBounds& bounds) {
  return !near.overlap && near.lower > 0 && bounds.are_met(near.lower, near.upper) &&
         !is_turned(a, b, ab, near, bounds.size, bounds.error);
}

// Whether the weights of the closest point miss it. That of a sliver is off where its normal is: it lies in the plane
// of the sliver, and not on it.
[[nodiscard]] inline bool is_missed(const GjkResult& near, const WeightedPoint& reached, const SearchBounds& bounds) {
  return largest_magnitude(reached.w - near.closest) > bounds.error + noise_of(bounds.size);
}

// Where rounding stops GJK short of a proof, another simplex may go further from the point that it reached.
template <Convex A, Convex B>
[[nodiscard]] GjkResult nearest_by_gjk(const A& a, const B& b, const Pose& ab, const Vec3& toward,
                                       const SearchBounds& bounds) {
  const auto& [size, error, limit, unproven] = bounds;
  GjkResult near = gjk(a, b, ab, toward, size, error, limit, unproven);
  if (!near.overlap && !near.beyond && !bounds.are_met(near.lower, near.upper)) [[unlikely]] {
    const GjkResult again = gjk(a, b, ab, -near.closest, size, error, limit, unproven);
    near = again.overlap || again.beyond || again.upper - again.lower < near.upper - near.lower ? again : near;
  }
  return near;
}

// Curved cores that touch: there GJK ends on slivers, a polytope on the common point.
template <Convex A, Convex B>
[[nodiscard]] bool separate_by_touch(const A& a, const B& b, const Pose& ab, const GjkResult& near,
                                     const SearchBounds& bounds, CoreSeparation& core) {
  if constexpr (Curved<A> || Curved<B>) {
    if (!near.overlap && !near.beyond && !bounds.are_met(near.lower, near.upper) &&
        near.upper <= projection_limit * bounds.size) [[unlikely]] {
      core.iterations = near.iterations;
      return with_difference(a, b, ab, bounds.size, [&](const Difference& cores) {
        return separate_by_touch(cores, bounds.error, near.simplex, core) ||
               separate_by_touch(cores, bounds.error, Simplex{}, core);
      });
    }
  }
  return false;
}

// Polytopes that overlap, or for which GJK has no proof: the best of all separating axes.
template <Convex A, Convex B>
[[nodiscard]] bool separate_by_axes(const A& a, const B& b, const Pose& ab, const GjkResult& near,
                                    const SearchBounds& bounds, CoreSeparation& along) {
  if (!separate_by_axes(a, b, ab, bounds.size, along)) {
    return false;
  }
  along.iterations += near.iterations;
  if (is_touch(along, bounds.size)) {
    find_touch(near.simplex, bounds.error, along);
  }
  // Axes bound the distance of cores that are apart from below only.
  return near.overlap || (along.distance <= bounds.error && !(near.lower > bounds.error));
}

// GJK with twice the digits, for cores that are apart. False where it finds that they overlap.
template <Convex A, Convex B>
[[nodiscard]] bool separate_by_wide_gjk(const A& a, const B& b, const Pose& ab, const SearchBounds& bounds,
                                        GjkResult& near, CoreSeparation& core) {
  const WideGjkResult wide = with_difference(a, b, ab, bounds.size, [&](const Difference& cores) {
    return wide_gjk(cores, -near.closest, bounds.error, bounds.limit, bounds.unproven);
  });
  if (wide.gjk.overlap) {
    near.overlap = true;
    near.simplex = wide.gjk.simplex;
    near.iterations += wide.gjk.iterations;
    return false;
  }
  core = separation_of(wide.gjk, wide.point_a, wide.point_b, bounds.size, near.iterations);
  return true;
}

// How deep cores overlap: by discs, or by a polytope.
template <Convex A, Convex B>
[[nodiscard]] CoreSeparation separate_overlap(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                              const SearchBounds& bounds, const GjkResult& near) {
  const Real size = bounds.size, error = bounds.error;
  CoreSeparation core{};
  core.iterations = near.iterations;
  if (settings.algorithm == Algorithm::gjk_epa || !separate_by_discs(a, b, ab, size, error, core)) {
    with_difference(a, b, ab, size,
                    [&](const Difference& cores) { separate_by_polytope(cores, error, near.simplex, core); });
  }
  core.overlap = true;
  // Cores that GJK takes for touching, since it proves no gap, may be as far apart as it came near. The polytope has
  // slivers there, of which rounding turns the normals.
  if ((Curved<A> || Curved<B>) && near.simplex.size < 4 && near.upper <= error && core.upper > -near.upper) {
    core.upper = std::max(core.upper, near.upper);
  }
  if (Curved<A> || Curved<B> ? std::fabs(core.distance) <= error : is_touch(core, size)) {
    find_touch(near.simplex, error, core);
  }
  return core;
}

// Any two cores: GJK from the direction `toward` on where they are apart, other searches where it cannot tell.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] CoreSeparation separate_by_gjk(const A& a, const B& b, const Pose& ab,
                                                               const QuerySettings& settings, const Vec3& toward,
                                                               const SearchBounds& bounds) {
  CoreSeparation core{};
  GjkResult near = nearest_by_gjk(a, b, ab, toward, bounds);
  if (separate_by_touch(a, b, ab, near, bounds, core)) {
    return core;
  }
  if (near.beyond) {
    return separation_of(near, {0, 0, 0}, {0, 0, 0}, bounds.size, 0);
  }
  if (!near.overlap) {
    const WeightedPoint reached = point_with(near.simplex, weights_of(near.simplex, near.closest));
    near.upper = is_missed(near, reached, bounds) ? infinity : near.upper;
    if (is_proven(a, b, ab, near, bounds)) {
      return separation_of(near, reached.a, reached.a - near.closest, bounds.size, 0);
    }
  }
  if (settings.algorithm != Algorithm::gjk_epa && separate_by_axes(a, b, ab, near, bounds, core)) {
    return core;
  }
  if (!near.overlap && separate_by_wide_gjk(a, b, ab, bounds, near, core)) {
    return core;
  }
  return separate_overlap(a, b, ab, settings, bounds, near);
}

// `limit`: the caller only wants to know how near the cores are when they are nearer than this.
template <Convex A, Convex B>
[[nodiscard]] inline CoreSeparation separate_cores(const A& a, const B& b, const Pose& ab,
                                                   const QuerySettings& settings, Real limit) {
  const SearchBounds bounds = search_bounds(a, b, ab, settings, limit);
  if constexpr (are_point_and_field<A, B>) {
    if (takes_closed_forms(settings.algorithm)) {
      CoreSeparation core = separate_point(a, b, ab, bounds.size);
      core.beyond = core.lower > limit;
      return core;
    }
  }
  Vec3 toward = placed_centre(b, ab) - a.centre();
  std::uint32_t iterations_before = 0;
  if constexpr (BoxCored<A> && BoxCored<B>) {
    CoreSeparation core{};
    core.rounding = rounding_of(bounds.size);
    if (takes_closed_forms(settings.algorithm) && separate_box_cores(a, b, ab, bounds, toward, core)) {
      return core;
    }
    iterations_before = core.iterations;
  }
  CoreSeparation core = separate_by_gjk(a, b, ab, settings, toward, bounds);
  core.iterations += iterations_before;
  return core;
}

}  // namespace abut
