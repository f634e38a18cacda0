// Whether what is kept of a pair still proves its answer, and keeping it.
export module abut.narrow.warm.proof;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.hull_vs_hull;
import abut.narrow.points.clip;
import abut.narrow.points.common_region;
import abut.narrow.warm.clearance;
export import abut.narrow.warm.features;
import abut.capability;
import abut.narrow.convex.separation;
import abut.narrow.fan.sat;

export namespace abut {

// No point of the core is further from its centre.
template <Convex S>
[[nodiscard]] inline Real core_reach(const S& shape) {
  if constexpr (BoxCored<S>) {
    return norm(shape.half());
  } else if constexpr (!Curved<S>) {
    Real square = 0;
    for (std::uint32_t i = 0; i < shape.corner_count(); ++i) {
      square = std::max(square, squared_norm(shape.corner(i) - shape.centre()));
    }
    return std::sqrt(square) * (1 + 4 * epsilon);
  } else {
    return 2 * shape.extent();
  }
}

// Below this distance or depth searches may take a touch for an overlap, or the other way round.
[[nodiscard]] inline Real doubt_of(Real size, Real error) {
  return 2 * (error + unproven_limit * touching_distance(size));
}

// Whether the direction that is kept shows that the cores are further apart than `limit`.
template <Convex A, Convex B>
[[nodiscard]] inline bool is_still_apart(const A& a, const B& b, const Pose& ab, Real size, Real error, Real limit,
                                         PairMemory& memory) {
  const Real needed = std::max(limit, Real{0}) + doubt_of(size, error);
  const Vec3 pivot = placed_centre(b, ab);
  if (gap_kept(memory, ab.rotation, pivot) > needed) {
    return true;
  }
  const Vec3 direction = vec3_of(memory.vector);
  const Vec3 between = placed_support(b, place(b, ab), -direction).point - a.support(direction).point;
  const Real gap = dot(direction, between) - rounding_of(size);
  if (!(gap * (1 - 4 * single_rounding) > needed)) {
    return false;
  }
  keep_gap(gap, ab.rotation, pivot, static_cast<Real>(memory.reach), memory);
  return true;
}

// Further than needed cores are looked at up to this part of their size, so that what is found lasts.
inline constexpr Real gap_share = 0.1;

// Looks for a direction that shows cores to be apart, and keeps it.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] bool find_apart(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                                Real limit, PairMemory& memory) {
  const Vec3 pivot = placed_centre(b, ab);
  const Real wanted = std::max(limit, Real{0}) + gap_share * (a.extent() + b.extent());
  const GjkResult near = gjk(a, b, ab, pivot - a.centre(), size, gap_share * wanted, wanted);
  const auto direction = UnitVec3::make(-near.closest);
  memory = {};
  if (near.overlap || !direction) {
    return false;
  }
  memory.vector = singles_of(*direction);
  memory.length = -std::numeric_limits<float>::infinity();
  memory.reach = static_cast<float>(core_reach(b));
  if (is_still_apart(a, b, ab, size, error, limit, memory)) {
    return true;
  }
  memory = {};
  return false;
}

// A ball inside a core.
template <Edged S>
[[nodiscard]] inline InnerBall inner_ball(const S& shape) {
  if constexpr (Faceted<S>) {
    return {shape.facets().middle, 0.999 * shape.facets().inner};
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    return {{0, 0, 0}, SegmentCored<S> ? 0 : std::min({half.x, half.y, half.z})};
  } else {
    return {shape.centre(), std::max(-shape.nearest(shape.centre()).distance, Real{0})};
  }
}

// What answers of searches may be off by: those on polytopes that list their axes by rounding, others by their bound.
template <Convex A, Convex B>
[[nodiscard]] inline Real blur_of(const A& a, const B& b, Real size, Real error) {
  const Real noise = noise_of(size);
  if constexpr (Faceted<A> && Faceted<B>) {
    return has_few_vertices(a) && has_few_vertices(b) ? noise : noise + error;
  } else if constexpr (Faceted<A> && BoxCored<B>) {
    return has_facets(a, noise) ? noise : noise + error;
  } else if constexpr (BoxCored<A> && Faceted<B>) {
    return has_facets(b, noise) ? noise : noise + error;
  } else {
    return noise + error;
  }
}

// The overlap along the normal of features. False where there is none to speak of.
template <Edged A, Edged B>
  requires Featured<A, B>
[[nodiscard]] inline bool overlap_along(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                        const PairFeatures& features, CoreSeparation& core) {
  const CrossedEdges crossed = normal_of(a, b, ab, features);
  const Vec3 point_a = a.support(crossed.normal).point;
  const Vec3 point_b = placed_support(b, place(b, ab), -crossed.normal).point;
  const Real separation = dot(crossed.normal, point_b - point_a);
  if (!(-separation > doubt_of(size, error))) {
    return false;
  }
  const bool of_edges = features.kind == PairFeatures::Kind::edges;
  core = separation_under({separation, crossed.normal, 0, of_edges, crossed.edge_a, crossed.edge_b}, point_a, point_b,
                          size);
  return true;
}

// The room in the facet that the features make of the Minkowski difference, around its point nearest to the origin;
// both supporting faces in the frame of a. Nothing where another face of nearly the same normal is as deep within
// rounding, so that the search may prefer it.
template <Edged A, Edged B>
  requires Featured<A, B>
[[nodiscard]] inline Real clearance_of(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                       const PairFeatures& features, const CoreSeparation& core, const Face& face_a,
                                       const Face& face_b) {
  using Kind = PairFeatures::Kind;
  constexpr Real same_normal = 1e-12;
  const Real off_a = largest_magnitude(face_a.normal - core.normal);
  const Real off_b = largest_magnitude(face_b.normal + core.normal);
  Real clearance = 0, least_angle = 0;
  if (features.kind == Kind::face_of_a) {
    clearance = off_a < same_normal ? clearance_within(face_a, core.point_b) : 0;
    least_angle = off_b;
  } else if (features.kind == Kind::face_of_b) {
    clearance = off_b < same_normal ? clearance_within(face_b, core.point_a) : 0;
    least_angle = off_a;
  } else {
    const CrossedEdges crossed = normal_of(a, b, ab, features);
    const Real squares = squared_norm(crossed.edge_a) * squared_norm(crossed.edge_b);
    const Real sine = std::sqrt(squared_norm(cross(crossed.edge_a, crossed.edge_b)) / squares);
    clearance = sine * room_on_edges(a, b, ab, features, core.normal, core.point_a, core.point_b, noise_of(size));
    least_angle = std::fmin(off_a, off_b);
  }
  return clearance * least_angle > 64 * blur_of(a, b, size, error) ? clearance : 0;
}

// Whether an overlap is the least of all, by more than what searches are off by.
template <Edged A, Edged B>
  requires Featured<A, B>
[[nodiscard]] inline bool is_still_least(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                         const CoreSeparation& core, const Face& face_a, const Face& face_b,
                                         PairMemory& memory) {
  const Real clearance = clearance_of(a, b, ab, size, error, memory.features, core, face_a, face_b);
  const Real margin = 4 * blur_of(a, b, size, error), depth = -core.distance;
  bool is_least =
      memory.state == PairMemory::State::touching_with_ball &&
      is_least_depth(depth, core.normal, clearance, ball_kept(memory, ab.rotation, placed_centre(b, ab)), margin);
  if (!is_least) {
    const InnerBall of_a = inner_ball(a), of_b = inner_ball(b);
    is_least = is_least_depth(depth, core.normal, clearance,
                              {of_a.centre - ab * of_b.centre, of_a.radius + of_b.radius}, margin);
  }
  memory.debts = is_least && memory.debts > 0 ? static_cast<std::uint8_t>(memory.debts - 1) : memory.debts;
  return is_least;
}

// Whether a face has a point that is as deep as the cores are along its normal. One that a round core leans beyond has
// none, and another normal is as good within the bound.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] bool meets_on_face(const A& a, const B& b, const Pose& ab,
                                                   const CoreSeparation& along) {
  CoreSeparation core = along;
  if (find_round_witness(a, b, ab, core)) {
    return true;
  }
  [[clang::uninitialized]] const Face face_a = a.supporting_face(along.normal);
  [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -along.normal);
  [[clang::uninitialized]] ClipPoints region;
  find_common_region(a, b, ab, face_a, face_b, along.normal, region);
  const Real deepest = along.distance + curve_blur(core_size(a, b, ab));
  return std::ranges::any_of(region.span(), [&](const ClipPoint& point) {
    return dot(point.point_b - point.point_a, along.normal) <= deepest;
  });
}

// An expanding polytope comes near the normal of features, within its bound; what the features themselves give is
// exact, and the same whatever the search went through.
template <Convex A, Convex B>
  requires Featured<A, B>
[[gnu::noinline]] void settle_on_features(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                          CoreSeparation& core) {
  const Real noise = noise_of(size);
  if (!has_features(a, noise) || !has_features(b, noise)) {
    return;
  }
  const CoreSeparation found = core;
  Real needed = found.distance - error - noise;
  bool is_settled = false;
  const auto take = [&](const PairFeatures& features) {
    const CrossedEdges crossed = normal_of(a, b, ab, features);
    const Vec3 point_a = a.support(crossed.normal).point;
    const Vec3 point_b = placed_support(b, place(b, ab), -crossed.normal).point;
    const Real separation = dot(crossed.normal, point_b - point_a);
    if (!(separation >= needed)) {
      return false;
    }
    const bool of_edges = features.kind == PairFeatures::Kind::edges;
    const SatResult axis{separation, crossed.normal, found.iterations, of_edges, crossed.edge_a, crossed.edge_b};
    const CoreSeparation along = separation_under(axis, point_a, point_b, size);
    // Edges that do not meet are not what is furthest out.
    if (of_edges && !(room_on_edges(a, b, ab, features, crossed.normal, along.point_a, along.point_b, noise) >= 0)) {
      return false;
    }
    if constexpr (Curved<A> || Curved<B>) {
      if (!of_edges && !meets_on_face(a, b, ab, along)) {
        return false;
      }
    }
    needed = separation + noise;
    core = along;
    core.algorithm = found.algorithm;
    core.lower = std::min(found.lower, separation);
    core.upper = std::max(found.upper, separation);
    is_settled = true;
    return of_edges;
  };
  offer_faces(a, b, ab, found.normal, take);
  if (!is_settled) {
    offer_edges(a, b, ab, found.normal, take);
  }
}

// How far beyond the facet the centre of a ball is looked for: in part of the cores' own balls and of the depth
// (measured).
inline constexpr Real ball_share_of_cores = 0.1, ball_share_of_depth = 0.5;
// A ball costs about as much as two searches that are spared pay back. Each one that is owed doubles the number of
// searches that the next ball waits for.
inline constexpr std::uint8_t debts_of_a_ball = 2, most_debts = 7;

// Keeps the features of an overlap that a search has found. Where they are the same as before, the proof has failed for
// want of a ball: the depth of a point deeper inside the difference is the radius of one.
template <Edged A, Edged B>
  requires Featured<A, B>
[[gnu::noinline]] void keep_overlap(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Real size,
                                    Real error, const CoreSeparation& core, PairMemory& memory) {
  const bool have_features = has_features(a, noise_of(size)) && has_features(b, noise_of(size));
  const PairFeatures features = have_features ? features_of(a, b, ab, core.normal) : PairFeatures{};
  if (features.kind == PairFeatures::Kind::none) {
    memory = {};
    return;
  }
  const bool is_known = memory.state >= PairMemory::State::touching && memory.features == features;
  memory.state = PairMemory::State::touching;
  memory.features = features;
  if (memory.waits > 0) {
    --memory.waits;
    return;
  }
  if (!is_known) {
    return;
  }
  memory.waits = static_cast<std::uint8_t>((1u << memory.debts) - 1);
  memory.debts = std::min(static_cast<std::uint8_t>(memory.debts + debts_of_a_ball), most_debts);
  [[clang::uninitialized]] const Face face_a = a.supporting_face(core.normal);
  [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal);
  const Real depth = -core.distance;
  CoreSeparation overlap{};
  if (!overlap_along(a, b, ab, size, error, features, overlap)) {
    return;
  }
  const Real clearance = clearance_of(a, b, ab, size, error, features, overlap, face_a, face_b);
  const Real beyond = ball_share_of_cores * (inner_ball(a).radius + inner_ball(b).radius) + ball_share_of_depth * depth;
  if (!(clearance > 0)) {
    return;
  }
  const CoreSeparation deeper =
      separate_cores(a, b, {ab.rotation, ab.position - beyond * core.normal}, settings, infinity);
  const InnerBall ball{-beyond * core.normal, -deeper.upper - deeper.rounding - noise_of(size)};
  if (is_least_depth(depth, core.normal, clearance, ball, 4 * blur_of(a, b, size, error))) {
    keep_ball(ball, ab.rotation, placed_centre(b, ab), core_reach(b), memory);
  }
}

}  // namespace abut
