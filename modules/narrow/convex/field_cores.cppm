// SPDX-License-Identifier: Apache-2.0
// Closest points of two cores that are apart, where each knows its point nearest to any other and one is curved,
// without a simplex.
//
// A point is projected on one core and back (von Neumann's alternating projections). The moves end up shrinking by
// constant factors, which the last of them tell, so that all to come are taken at once. Ends as GJK does, by the
// duality gap; cores that overlap, and pairs that creep, are left to the caller.
export module abut.narrow.convex.field_cores;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.convex.separation;

export namespace abut {

// Known in closed form: boxes, segments and bodies of revolution. Of an ellipsoid it is searched for.
template <class S>
inline constexpr bool is_closed_field = BoxCored<S> || (Field<S> && Rimmed<S>);
template <class A, class B>
inline constexpr bool are_curved_fields =
    (Field<A> || BoxCored<A>) && (Field<B> || BoxCored<B>) && (is_closed_field<A> || is_closed_field<B>) &&
    (Curved<A> || Curved<B>) && !PointCored<A> && !PointCored<B>;

// The point of a core nearest to one of its frame.
template <Convex S>
[[nodiscard]] [[gnu::always_inline]] inline Vec3 nearest_in(const S& shape, const Vec3& p) {
  if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    return minimum(maximum(p, -half), half);
  } else {
    const SurfacePoint near = shape.nearest(p);
    return near.distance > 0 ? near.point : p;
  }
}

// Where a point of a came out of being projected on b and back, and how far that is from it.
struct ProjectionStep {
  Vec3 point, move;
};
// Where the moves end, told from the last three, the latest first: what combination of them moves least (Anderson,
// "Iterative procedures for nonlinear integral equations", 1965).
[[nodiscard]] inline Vec3 end_of_moves(const std::array<ProjectionStep, 3>& last, std::uint32_t count) {
  const auto& [one, two, three] = last;
  const Vec3 later = one.move - two.move, earlier = two.move - three.move;
  const Real square = squared_norm(later);
  if (count < 2 || !(square > 0)) {
    return one.point;
  }
  const Real along = dot(later, one.move), square_earlier = squared_norm(earlier), common = dot(later, earlier);
  const Real area = square * square_earlier - common * common;
  constexpr Real parallel_moves = 1e-10;  // square of a sine: nearer to parallel, both moves tell one direction only
  if (count < 3 || !(area > parallel_moves * square * square_earlier)) {
    return one.point - (along / square) * (one.point - two.point);
  }
  const Real along_earlier = dot(earlier, one.move);
  return one.point - ((along * square_earlier - along_earlier * common) / area) * (one.point - two.point) -
         ((along_earlier * square - along * common) / area) * (two.point - three.point);
}

// Nine in ten random pairs of cylinders are proven by then, half of them in five.
inline constexpr std::uint32_t field_rounds = 10;
// Of cores that are apart the second round nearly always proves it.
inline constexpr std::uint32_t overlap_rounds = 2;

// Nothing where that leaves the pair open.
template <Convex A, Convex B>
  requires are_curved_fields<A, B>
[[nodiscard]] std::optional<CoreSeparation> separate_fields(const A& a, const B& b, const Pose& ab,
                                                            const QuerySettings& settings) {
  const Real size = core_size(a, b, ab), error = error_of(a, b, size, settings), least = projection_limit * size;
  const auto placement = place(b, ab);
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.algorithm = Algorithm::gjk_epa;  // a search, proven by support points

  std::array<ProjectionStep, 3> last{};
  Vec3 start = nearest_in(a, placed_centre(b, ab));
  for (core.iterations = 1; core.iterations <= field_rounds; ++core.iterations) {
    core.point_b = ab * nearest_in(b, ab.undo(start));
    core.point_a = nearest_in(a, core.point_b);
    const Vec3 between = core.point_b - core.point_a, move = core.point_a - start;
    const Real square = squared_norm(between);
    if (!(square > least * least)) {
      return std::nullopt;
    }
    core.distance = core.upper = std::sqrt(square);
    // The gap is about the square of what is left to move over the distance: not yet worth a look where that is far
    // more.
    if (core.iterations == overlap_rounds || squared_norm(move) <= 1e4 * error * core.distance) {
      core.normal = (1 / core.distance) * between;
      const Vec3 end_of_a = a.support(core.normal).point, end_of_b = placed_support(b, placement, -core.normal).point;
      core.lower = dot(core.normal, end_of_b - end_of_a);
      if (core.upper - core.lower <= error) {
        return core;
      }
      if (!(core.lower > 0)) {
        return std::nullopt;
      }
    }
    last = {ProjectionStep{core.point_a, move}, last[0], last[1]};
    start = nearest_in(a, end_of_moves(last, core.iterations));
  }
  return std::nullopt;
}

}  // namespace abut
