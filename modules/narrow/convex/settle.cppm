// SPDX-License-Identifier: Apache-2.0
// An expanding polytope comes near the normal of two features within its bound. What the features themselves give is
// exact, and the same whatever the search went through.
export module abut.narrow.convex.settle;
import abut.capability;
import abut.core.standard;
import abut.math.four_vec3;
import abut.math;
import abut.narrow.convex.separation;
import abut.narrow.fan.facets;
import abut.narrow.fan.features;
import abut.narrow.points.clip;
import abut.narrow.points.common_region;

export namespace abut {

// Pairs whose least overlap mostly has features that can be named. Closed forms answer for two boxes.
template <class S>
inline constexpr bool is_edged = is_numbered<S> && !PointCored<S> && !Triangular<S>;
template <class A, class B>
inline constexpr bool are_featured = is_edged<A> && is_edged<B> && !(BoxCored<A> && BoxCored<B>);

// Whether all features of a core are what they are named for: numbers fit, and nothing is flat.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline bool has_features(const S& shape, Real noise) {
  if constexpr (Faceted<S>) {
    const auto& facets = shape.facets();
    return facets.is_closed && facets.flatness <= noise && facets.inner > 0 && facets.lines.size() < 0xffff;
  } else if constexpr (BoxCored<S>) {
    const Vec3 half = shape.half();
    return SegmentCored<S> ? half.z > 0 : half.x > 0 && half.y > 0 && half.z > 0;
  } else {
    return shape.discs().bottom > 0;
  }
}

// Whether a core has a face or an edge of a number.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline bool has_feature(const S& shape, const CoreFeature& feature) {
  const bool is_face = feature.kind == CoreFeature::Kind::face;
  if constexpr (Faceted<S>) {
    return feature.index < (is_face ? shape.facets().faces.size() : shape.facets().lines.size());
  } else if constexpr (BoxCored<S> && !SegmentCored<S>) {
    return feature.index < (is_face ? 6 : 3);
  } else {
    return is_face ? Rimmed<S> && (feature.index == 4 || feature.index == 5) : feature.index == 2;
  }
}
// Whether features of two cores give a normal, which features that come from a caller need not.
template <Convex A, Convex B>
  requires are_featured<A, B>
[[nodiscard]] inline bool have_features(const A& a, const B& b, const CoreFeatures& features, Real noise) {
  using Kind = CoreFeature::Kind;
  if (!has_features(a, noise) || !has_features(b, noise)) {
    return false;
  }
  if (features.are_edges()) {
    return has_feature(a, features.a) && has_feature(b, features.b) && has_straight_edges(a) && has_straight_edges(b);
  }
  return features.a.kind == Kind::face
             ? features.b.kind == Kind::none && has_feature(a, features.a)
             : features.a.kind == Kind::none && features.b.kind == Kind::face && has_feature(b, features.b);
}

// The place of a hull's face that looks along a direction best.
template <Faceted S>
[[nodiscard]] inline std::size_t facet_along(const S& hull, const Vec3& direction) {
  const Columns n = Columns::all(direction);
  LeastDepths faces;
  std::size_t group = 0;
  for (const auto& planes : hull.facets().planes) {
    faces.consider(-dot(n, {planes.x, planes.y, planes.z}), group++);
  }
  const std::size_t lane = faces.lane();
  return 4 * static_cast<std::size_t>(faces.which[lane]) + lane;
}
// The place of a hull's edge that leads from the vertex furthest along a direction to the next one of its neighbours.
template <Faceted S>
[[nodiscard]] inline std::size_t line_along(const S& hull, const Vec3& direction) {
  const auto& points = hull.facets().points;
  const auto& ends = hull.facets().ends;
  const Lanes n = lanes_of(direction);
  std::size_t top = 0;
  Real highest = -infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Real height = dot(n, points[i]);
    top = height > highest ? i : top;
    highest = height > highest ? height : highest;
  }
  std::size_t found = 0;
  Real next = -infinity;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const auto [from, to] = ends[i];
    if (from == top || to == top) {
      const Real height = dot(n, points[from == top ? to : from]);
      found = height > next ? i : found;
      next = height > next ? height : next;
    }
  }
  return found;
}

// The face of a core that looks along a direction best, everything in the frame of the core.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline CoreFeature face_along(const S& shape, const Vec3& direction) {
  if constexpr (Faceted<S>) {
    return core_face(facet_along(shape, direction));
  } else if constexpr (SegmentCored<S>) {
    return {};
  } else {
    const Vec3 size = absolute(direction);
    const int axis = Rimmed<S> ? 2 : size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return core_face(static_cast<std::size_t>(2 * axis) + (direction[axis] >= 0 ? 1 : 0));
  }
}
// The edge that is furthest out along a direction; of a box the axis that is most across it.
template <Convex S>
  requires is_numbered<S>
[[nodiscard]] inline CoreFeature edge_along(const S& shape, const Vec3& direction) {
  if constexpr (Faceted<S>) {
    return core_edge(line_along(shape, direction));
  } else if constexpr (BoxCored<S> && !SegmentCored<S>) {
    const Vec3 size = absolute(direction);
    return core_edge(size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2);
  } else {
    return core_edge(2);
  }
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

// Turns a depth to the normal of the features that the search told, or of some near its normal that are as good.
template <Convex A, Convex B>
  requires are_featured<A, B>
[[gnu::noinline]] void settle_on_features(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                          CoreSeparation& core) {
  const Real noise = noise_of(size);
  if (!has_features(a, noise) || !has_features(b, noise)) {
    return;
  }
  const CoreSeparation found = core;
  const auto along = [&](const CoreFeatures& features) {
    return separation_along(a, b, ab, normal_of(a, b, ab, features), features, size);
  };
  const auto take = [&](const CoreSeparation& taken) {
    core = taken;
    core.algorithm = found.algorithm;
    core.iterations = found.iterations;
    core.lower = std::min(found.lower, taken.distance);
    core.upper = std::max(found.upper, taken.distance);
  };
  if (found.features.are_known()) {
    if (!found.features.are_edges() || (has_straight_edges(a) && has_straight_edges(b))) {
      take(along(found.features));
    }
    return;
  }
  Real needed = found.distance - error - noise;
  const auto offer = [&](const CoreSeparation& offered) {
    bool is_taken = offered.distance >= needed;
    if (offered.features.are_edges()) {
      is_taken = is_taken && !offered.points_open;  // edges that do not meet are not what is furthest out
    } else if constexpr (Curved<A> || Curved<B>) {
      is_taken = is_taken && meets_on_face(a, b, ab, offered);
    }
    if (is_taken) {
      needed = offered.distance + noise;
      take(offered);
    }
  };
  const Vec3 local = ab.rotation.undo(-found.normal);
  const CoreFeatures face_of_a{face_along(a, found.normal), {}}, face_of_b{{}, face_along(b, local)};
  for (const CoreFeatures& face : {face_of_a, face_of_b}) {
    if (face.are_known()) {
      offer(along(face));
    }
  }
  if (!core.features.are_known()) {
    CoreFeatures edges{edge_along(a, found.normal), edge_along(b, local)};
    direct_edges(a, b, ab, found.normal, edges);
    offer(along(edges));
  }
}

// The normal of the side of a cylinder or a cone that leads toward a point, in its frame; nothing where it has no side.
template <Rimmed S>
[[nodiscard]] std::optional<UnitVec3> side_toward(const S& shape, const Vec3& point) {
  const Discs discs = shape.discs();
  const Sideways out = sideways_of(point);
  const Real length = 2 * discs.half_height;
  return length > 0 && out.length > 0 ? UnitVec3::make(Vec3{length * out.x, length * out.y, discs.bottom - discs.top})
                                      : std::nullopt;
}

// Pairs of a round side and of a polytope.
template <class A, class B>
inline constexpr bool are_side_and_polytope =
    (Rimmed<A> && !Curved<B> && !PointCored<B>) || (Rimmed<B> && !Curved<A> && !PointCored<A>);

// Turns a normal to that of a side that meets a vertex, or an edge along it, where that is as good. What is proven to a
// share of the size leaves a normal around a curve free by its root: so far the line of the side may lie beside an edge
// that it touches all along.
template <Convex A, Convex B>
  requires are_side_and_polytope<A, B>
[[gnu::noinline]] void settle_on_side(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                      CoreSeparation& core) {
  constexpr Real furthest = 1e-3;  // from the normal: beyond the root of any error
  std::optional<UnitVec3> side;
  if constexpr (Rimmed<A>) {
    side = side_toward(a, placed_support(b, place(b, ab), -core.normal).point);
  } else {
    side = side_toward(b, ab.undo(a.support(core.normal).point));
  }
  if (!side) {
    return;
  }
  const Vec3 normal = Rimmed<A> ? side->vec() : -(ab.rotation * side->vec());
  const Real off = norm(normal - core.normal), noise = noise_of(size);
  if (!(off > rounding_of(1) && off < furthest)) {
    return;
  }
  CoreSeparation along = separation_along(a, b, ab, normal, {}, size);
  if (along.distance >= core.distance - error - noise && meets_on_face(a, b, ab, along)) {
    along.overlap = core.overlap;
    along.algorithm = core.algorithm;
    along.iterations = core.iterations;
    along.lower = std::min(core.lower, along.distance);
    along.upper = std::max(core.upper, along.distance);
    core = along;
  }
}

}  // namespace abut
