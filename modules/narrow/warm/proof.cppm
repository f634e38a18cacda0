// SPDX-License-Identifier: Apache-2.0
// Whether what is kept of a pair still proves its answer, and keeping it.
export module abut.narrow.warm.proof;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.fan.features;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.hull_vs_polytope;
export import abut.narrow.warm.pair_memory;
import abut.capability;
import abut.narrow.convex.separation;
export import abut.narrow.convex.settle;

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
    return std::sqrt(square) * (1 + touching_distance(1));
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
template <Convex S>
  requires is_numbered<S>
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
template <Convex A, Convex B>
  requires are_featured<A, B>
[[nodiscard]] inline bool overlap_along(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                        const CoreFeatures& features, CoreSeparation& core) {
  core = separation_along(a, b, ab, normal_of(a, b, ab, features), features, size);
  return -core.distance > doubt_of(size, error);
}

// How far a point beside a face is inside its edges, seen along its normal; of a disc one of its corners decides.
[[nodiscard]] inline Real room_in_face(const Face& face, const Vec3& point) {
  const auto vertices = face.vertices.span();
  Real least = vertices.size() > 2 ? infinity : -infinity;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3& from = vertices[i].point;
    const Vec3 along = vertices[i + 1 < vertices.size() ? i + 1 : 0].point - from;
    const Real side = dot(cross(face.normal, along), point - from),
               square = side * std::fabs(side) / squared_norm(along);
    least = square < least ? square : least;
  }
  return least > 0 ? std::sqrt(least) : least;
}

// How far a point of an edge is from its ends.
[[nodiscard]] inline Real room_on_edge(const CoreEdge& edge, const Vec3& point) {
  const Real length = norm(edge.along);
  return 0.5 * length - std::fabs(dot(point - edge.from, edge.along) / length - 0.5 * length);
}

// The room in the facet that the features make of the Minkowski difference, around its point nearest to the origin;
// both supporting faces in the frame of a. Nothing where another face of nearly the same normal is as deep within
// rounding, so that the search may prefer it.
template <Convex A, Convex B>
  requires are_featured<A, B>
[[nodiscard]] inline Real clearance_of(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                       const CoreSeparation& core, const Face& face_a, const Face& face_b) {
  const CoreFeatures& features = core.features;
  const Real off_a = largest_magnitude(face_a.normal - core.normal);
  const Real off_b = largest_magnitude(face_b.normal + core.normal);
  Real clearance = 0, least_angle = 0;
  if (!features.are_edges()) {
    const bool is_of_a = features.a.kind == CoreFeature::Kind::face;
    const Real off = is_of_a ? off_a : off_b;
    const Real room = is_of_a ? room_in_face(face_a, core.point_b) : room_in_face(face_b, core.point_a);
    clearance = off <= noise_of(1) ? room : 0;
    least_angle = is_of_a ? off_b : off_a;
  } else if (!core.points_open) {
    const Vec3 local = ab.rotation.undo(-core.normal);
    const CoreEdge edge_a = edge_of(a, features.a.index, core.normal), edge_b = edge_of(b, features.b.index, local);
    const Vec3 across = cross(edge_a.along, ab.rotation * edge_b.along);
    const Real squares = squared_norm(edge_a.along) * squared_norm(edge_b.along);
    const Real room = std::fmin(room_on_edge(edge_a, core.point_a), room_on_edge(edge_b, ab.undo(core.point_b)));
    clearance = room * std::sqrt(squared_norm(across) / squares);
    least_angle = std::fmin(off_a, off_b);
  }
  return clearance * least_angle > 64 * blur_of(a, b, size, error) ? clearance : 0;
}

// Whether an overlap is the least of all, by more than what searches are off by.
template <Convex A, Convex B>
  requires are_featured<A, B>
[[nodiscard]] inline bool is_still_least(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                         const CoreSeparation& core, const Face& face_a, const Face& face_b,
                                         PairMemory& memory) {
  const Real clearance = clearance_of(a, b, ab, size, error, core, face_a, face_b);
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

// How far beyond the facet the centre of a ball is looked for: in part of the cores' own balls and of the depth
// (measured).
inline constexpr Real ball_share_of_cores = 0.1, ball_share_of_depth = 0.5;
// A ball costs about as much as two searches that are spared pay back. Each one that is owed doubles the number of
// searches that the next ball waits for.
inline constexpr std::uint8_t debts_of_a_ball = 2, most_debts = 7;

// Keeps the features of an overlap that a search has found. Where they are the same as before, the proof has failed for
// want of a ball: the depth of a point deeper inside the difference is the radius of one.
template <Convex A, Convex B>
  requires are_featured<A, B>
[[gnu::noinline]] void keep_overlap(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Real size,
                                    Real error, const CoreSeparation& core, PairMemory& memory) {
  const CoreFeatures& features = core.features;
  if (!have_features(a, b, features, noise_of(size))) {
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
  [[clang::uninitialized]] const Face face_a = supporting_face(a, core.normal, core.features.a);
  [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal, core.features.b);
  const Real depth = -core.distance;
  const Real clearance = clearance_of(a, b, ab, size, error, core, face_a, face_b);
  const Real beyond = ball_share_of_cores * (inner_ball(a).radius + inner_ball(b).radius) + ball_share_of_depth * depth;
  if (!(clearance > 0 && depth > doubt_of(size, error))) {
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
