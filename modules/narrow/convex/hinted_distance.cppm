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

// Whether the closest point of the simplex is that of the cores. Like GJK: with v that point and w the support point
// against it, dot(v, w) / |v| <= distance <= |v|.
template <Convex A, Convex B>
[[nodiscard]] inline bool is_still_nearest(const A& a, const B& b, const Pose& ab, Real error, GjkResult& near) {
  const ClosestPoint closest = closest_to_origin(near.simplex);
  keep(near.simplex, closest.vertices);
  const Vec3 v = near.closest = closest.point;
  const Vec3 newest = a.support(-v).point - placed_support(b, place(b, ab), v).point;
  near.upper = norm(v);
  near.lower = dot(v, newest) / near.upper;
  near.normal = normal_of(near.simplex, v, near.upper);
  near.overlap = near.beyond = false;
  near.iterations = 1;
  return near.lower > 0 && near.upper - near.lower <= error;
}

// The separation under a closest point. False where only the other searches can tell it: the cores overlap or nearly
// touch, or rounding has spoilt the simplex.
template <Convex A, Convex B>
[[nodiscard]] inline bool separate_at(const A& a, const B& b, const Pose& ab, const GjkResult& near, Real size,
                                      Real error, CoreSeparation& core) {
  if (near.overlap || !(near.lower > 0) || near.upper - near.lower > error + noise_of(size) ||
      is_turned(a, b, ab, near, size, error)) {
    return false;
  }
  const WeightedPoint reached = point_with(near.simplex, weights_of(near.simplex, near.closest));
  core = separation_of(near, reached.a, reached.a - near.closest, size, 0);
  return largest_magnitude(reached.w - near.closest) <= error + noise_of(size);
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
  const Real size = core_size(a, b, ab), error = error_of(a, b, size, settings);
  [[clang::uninitialized]] GjkResult near;
  const bool is_known = rebuild(a, b, ab, hint, near.simplex);
  if (!(is_known && is_still_nearest(a, b, ab, error, near))) {
    const Vec3 toward = is_known && near.upper > 0 ? -near.closest : placed_centre(b, ab) - a.centre();
    near = gjk(a, b, ab, toward, size, error, infinity, error_of(a, b, size, QuerySettings{}));
  }
  CoreSeparation core{};
  if (!separate_at(a, b, ab, near, size, error, core)) {
    return search_with_hint(a, b, ab, settings, hint, out);
  }
  keep_vertices(near.simplex, hint);
  out = rounded(core, a.radius(), b.radius());
  return Outcome::ok;
}

}  // namespace abut
