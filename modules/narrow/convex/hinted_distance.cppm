// SPDX-License-Identifier: Apache-2.0
// The distance of two cores with corners, beginning at the vertices that were nearest the last time. Where these still
// are, one support point of each core proves it. Else GJK goes on toward them.
export module abut.narrow.convex.hinted_distance;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.apart.gjk;
export import abut.narrow.apart.pair_hint;
import abut.narrow.convex;
import abut.narrow.cores.simplex;

export namespace abut {

// Polytopes have corners. Closed forms are as fast as a hint.
template <class A, class B>
inline constexpr bool gains_from_hint = Convex<A> && Convex<B> && !Curved<A> && !Curved<B> && !have_closed_form<A, B>;

// The simplex of the vertices of a hint, under the poses of now. False where the cores have no such vertices.
template <Convex A, Convex B>
[[nodiscard]] inline bool rebuild(const A& a, const B& b, const Pose& ab, const PairHint& hint, Simplex& simplex) {
  simplex.size = 0;
  if (!(hint.vertex_count >= 1 && hint.vertex_count <= hint.vertices_a.size())) {
    return false;
  }
  for (std::size_t i = 0; i < hint.vertex_count; ++i) {
    const std::uint32_t of_a = hint.vertices_a[i], of_b = hint.vertices_b[i];
    if (of_a >= a.corner_count() || of_b >= b.corner_count()) {
      return false;
    }
    const Vec3 on_a = a.corner(of_a);
    simplex.push({on_a - ab * b.corner(of_b), on_a, of_a, of_b});
  }
  return true;
}

// Whether the closest point v of the simplex is that of the cores. With n the unit direction of v, the distance lies
// between the gap of the cores along n and |v|.
template <Convex A, Convex B>
[[nodiscard]] inline bool is_still_nearest(const A& a, const B& b, const Pose& ab, Real error, GjkResult& near) {
  const ClosestPoint closest = closest_to_origin(near.simplex);
  keep(near.simplex, closest.vertices);
  near.closest = closest.point;
  near.upper = norm(near.closest);
  near.normal = normal_of(near.simplex, near.closest, near.upper);
  const Vec3 end_of_a = a.support(near.normal).point, end_of_b = placed_support(b, place(b, ab), -near.normal).point;
  near.lower = dot(near.normal, end_of_b - end_of_a);
  near.overlap = near.beyond = false;
  near.iterations = 1;
  return near.lower > 0 && near.upper - near.lower <= error;
}

inline void keep_vertices(const Simplex& simplex, PairHint& hint) {
  hint.vertex_count = static_cast<std::uint32_t>(simplex.size);
  for (std::size_t i = 0; i < simplex.size; ++i) {
    hint.vertices_a[i] = simplex.vertices[i].index_a;
    hint.vertices_b[i] = simplex.vertices[i].index_b;
  }
}

template <Convex A, Convex B>
[[nodiscard]] inline Outcome search_with_hint(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                              PairHint& hint, Distance& out) {
  const Outcome outcome = convex_distance_by_search(a, b, ab, settings, out);
  hint.vertex_count = 0;
  hint.is_overlapping = outcome == Outcome::ok && out.distance + (a.radius() + b.radius()) > 0 ? 0 : 1;
  return outcome;
}

template <Convex A, Convex B>
  requires gains_from_hint<A, B>
[[nodiscard]] Outcome convex_distance_from_hint(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                PairHint& hint, Distance& out) {
  if (settings.algorithm != Algorithm::automatic) {
    return convex_distance_by_search(a, b, ab, settings, out);
  }
  if (hint.is_overlapping != 0) {
    return search_with_hint(a, b, ab, settings, hint, out);
  }
  const SearchBounds bounds = search_bounds(a, b, ab, settings, infinity);
  [[clang::uninitialized]] GjkResult near;
  const bool is_known = rebuild(a, b, ab, hint, near.simplex);
  bool is_found = is_known && is_still_nearest(a, b, ab, bounds.error, near);
  if (!is_found) {
    const Vec3 toward = is_known && near.upper > 0 ? -near.closest : placed_centre(b, ab) - a.centre();
    near = gjk(a, b, ab, toward, bounds.size, bounds.error, bounds.limit, bounds.unproven);
    is_found = is_proven(a, b, ab, near, bounds);
  }
  const WeightedPoint reached =
      is_found ? point_with(near.simplex, weights_of(near.simplex, near.closest)) : WeightedPoint{};
  if (!is_found || is_missed(near, reached, bounds)) {
    return search_with_hint(a, b, ab, settings, hint, out);
  }
  keep_vertices(near.simplex, hint);
  const CoreSeparation core = separation_of(near, reached.a, reached.a - near.closest, bounds.size, 0);
  out = rounded(core, a.radius(), b.radius());
  return Outcome::ok;
}

}  // namespace abut
