// SPDX-License-Identifier: Apache-2.0
// The points of two cores that are closest or deepest, under a separation that is known.
export module abut.narrow.points.witnesses;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.cores.simplex;
import abut.narrow.fan.discs.disc_depth_of_pair;
import abut.narrow.fan.disc_pairs;
import abut.narrow.fan.features;
import abut.narrow.fan.hull_sat;
import abut.narrow.points.clip;
import abut.narrow.points.closest_of_faces;

export namespace abut {

// What rounding leaves between points and the distance is shared by both.
inline void set_points(const Vec3& point_a, const Vec3& point_b, CoreSeparation& core) {
  const Vec3 half = (0.5 * (core.distance - dot(point_b - point_a, core.normal))) * core.normal;
  core.point_a = point_a - half;
  core.point_b = point_b + half;
  core.points_open = false;
}

// Closest points of edges nearer to parallel than this run along them with rounding.
inline constexpr Real least_sine_of_edges = 1e-4;
// The deepest pair of points under a normal across two edges: where these cross. False where rounding may take the
// points beyond the ends of the edges.
template <Convex A, Convex B>
  requires are_numbered<A, B>
[[nodiscard]] inline bool find_edge_witnesses(const A& a, const B& b, const Pose& ab, Real size, CoreSeparation& core) {
  const CoreEdge edge_a = edge_of(a, core.features.a.index, core.normal);
  const CoreEdge placed = edge_of(b, core.features.b.index, ab.rotation.undo(-core.normal));
  const CoreEdge edge_b{ab * placed.from, ab.rotation * placed.along};
  const Vec3 across = cross(edge_a.along, edge_b.along), between = edge_b.from - edge_a.from;
  const Real square = squared_norm(across), square_a = squared_norm(edge_a.along),
             square_b = squared_norm(edge_b.along);
  if (!(square > least_sine_of_edges * least_sine_of_edges * square_a * square_b)) [[unlikely]] {
    return false;
  }
  const Real at_a = dot(across, cross(between, edge_b.along)) / square;
  const Real at_b = dot(across, cross(between, edge_a.along)) / square;
  const Real slack = noise_of(size);
  const auto is_within = [&](Real at, Real square_of_edge) {
    const Real beyond = std::fmax(std::fabs(at - 0.5) - 0.5, Real{0});
    return beyond * beyond * square_of_edge <= slack * slack;
  };
  const Vec3 point_a = edge_a.from + at_a * edge_a.along, point_b = edge_b.from + at_b * edge_b.along;
  if (!(is_within(at_a, square_a) && is_within(at_b, square_b) &&
        largest_magnitude(point_b - point_a - core.distance * core.normal) <= slack)) [[unlikely]] {
    return false;
  }
  core.point_a = point_a;
  core.point_b = point_b;
  core.points_open = false;
  return true;
}

// The deepest pair of points under the normal of a face: from the common region of the supporting faces,
// or else from what is outermost of them.
inline void find_points_of_faces(const Face& face_a, const Face& face_b, const ClipPoints& region, Real size,
                                 CoreSeparation& core) {
  AcrossPair pair{core.point_a, core.point_b};
  // Nearly parallel faces are equally far in many points; one of their common region will do.
  constexpr Real same_depth = 1e-12;  // of the size
  const Real deepest = core.distance + same_depth * size;
  Real least = deepest;
  for (const ClipPoint& point : region.span()) {
    const Real distance = dot(point.point_b - point.point_a, core.normal);
    if (distance <= least) {
      least = distance;
      pair = {point.point_a, point.point_b};
    }
  }
  if (!(least < deepest)) {
    pair = points_across(face_a, face_b, core.normal, noise_of(size));
  }
  set_points(pair.point_a, pair.point_b, core);
}

// Cores that know whether a point lies in them at little cost.
template <class A, class B>
inline constexpr bool do_both_hold = has_hull<A, B> || (BoxCored<A> && BoxCored<B>) || has_discs<A, B>;

// Mostly a vertex lies under the inside of a face. False where neither support point does, up to some slack.
template <Convex A, Convex B>
  requires do_both_hold<A, B>
[[nodiscard]] inline bool find_vertex_witness(const A& a, const B& b, const Pose& ab, Real slack,
                                              CoreSeparation& core) {
  const Vec3 on_a = core.point_b - core.distance * core.normal, on_b = core.point_a + core.distance * core.normal;
  if (holds(a, on_a, slack)) {
    core.point_a = on_a;
  } else if (holds(b, ab.undo(on_b), slack)) {
    core.point_b = on_b;
  } else {
    return false;
  }
  core.points_open = false;
  return true;
}

// The points of a depth with discs. False where they lie on edges of a hull, or where faces rest on each other.
template <Convex A, Convex B>
  requires has_discs<A, B>
[[nodiscard]] inline bool find_disc_witnesses(const A& a, const B& b, const Pose& ab, CoreSeparation& core) {
  if (find_vertex_witness(a, b, ab, rounding_of(core_size(a, b, ab)), core)) {
    return true;
  }
  return core.features.are_edges() && find_edge_witnesses(a, b, ab, core_size(a, b, ab), core);
}

// How far a point of its own frame lies outside of a core, negative inside; infinite where the core cannot tell.
template <Convex S>
[[nodiscard]] inline Real outside_by(const S& shape, const Vec3& point) {
  if constexpr (Field<S>) {
    return shape.nearest(point).distance;
  } else if constexpr (BoxCored<S>) {
    const Vec3 out = absolute(point) - shape.half();
    return std::fmax(out.x, std::fmax(out.y, out.z));
  } else if constexpr (Faceted<S>) {
    return outside_facets(shape, point);
  } else {
    return infinity;
  }
}

// A round core that leans on a face touches it under one point, which the polygon of its rim misses. False where
// neither support point lies over the other core.
template <Convex A, Convex B>
[[nodiscard]] inline bool find_round_witness(const A& a, const B& b, const Pose& ab, CoreSeparation& core) {
  const Vec3 on_a = core.point_b - core.distance * core.normal, on_b = core.point_a + core.distance * core.normal;
  const Real off_a = outside_by(a, on_a), off_b = outside_by(b, ab.undo(on_b));
  if (!(std::fmin(off_a, off_b) <= usual_error_of_curves * core_size(a, b, ab))) {
    return false;
  }
  (off_b <= off_a ? core.point_b : core.point_a) = off_b <= off_a ? on_b : on_a;
  core.points_open = false;
  return true;
}

// Whether a point lies over the inside of a face, seen along a normal.
[[nodiscard]] inline bool lies_over(const Face& face, const Vec3& point, const Vec3& normal) {
  const std::span<const FaceVertex> vertices = face.vertices.span();
  bool is_left = vertices.size() > 2, is_right = is_left;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3 &from = vertices[i].point, &to = vertices[i + 1 < vertices.size() ? i + 1 : 0].point;
    const Real side = dot(cross(to - from, point - from), normal);
    is_left = is_left && side > 0;
    is_right = is_right && side < 0;
  }
  return is_left || is_right;
}
// The same by the supporting faces alone: of a core that is thin, the planes around its face are rounding.
[[nodiscard]] inline bool find_witness_over_face(const Face& face_a, const Face& face_b, CoreSeparation& core) {
  const Vec3 on_a = core.point_b - core.distance * core.normal, on_b = core.point_a + core.distance * core.normal;
  if (lies_over(face_a, on_a, core.normal)) {
    core.point_a = on_a;
  } else if (lies_over(face_b, on_b, core.normal)) {
    core.point_b = on_b;
  } else {
    return false;
  }
  core.points_open = false;
  return true;
}

// Whoever asks for contacts rarely needs the points, so they are looked for on demand.
template <Convex A, Convex B>
void find_points(const A& a, const B& b, const Pose& ab, CoreSeparation& core) {
  if (!core.points_open) {
    return;
  }
  if constexpr (PointCored<A>) {
    core.point_b = core.point_a + core.distance * core.normal;
    core.points_open = false;
  } else if constexpr (PointCored<B>) {
    core.point_a = core.point_b - core.distance * core.normal;
    core.points_open = false;
  } else {
    if constexpr (do_both_hold<A, B>) {
      if (core.overlap && find_vertex_witness(a, b, ab, rounding_of(core_size(a, b, ab)), core)) {
        return;
      }
    }
    [[clang::uninitialized]] const Face face_a = a.supporting_face(core.normal);
    [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal);
    [[clang::uninitialized]] ClipPoints region;
    clip_faces(face_a, face_b, core.normal, region);
    find_points_of_faces(face_a, face_b, region, core_size(a, b, ab), core);
  }
}

// Cores that touch have a point in common, which the search for their overlap went through: it says
// more than their faces, where many points are equally near.
[[nodiscard]] inline bool is_touch(const CoreSeparation& core, Real size) {
  return core.points_open && std::fabs(core.distance) <= noise_of(size);
}
inline void touch_at(const Vec3& point_a, const Vec3& point_b, CoreSeparation& core) {
  core.points_open = false;
  const Vec3 middle = 0.5 * (point_a + point_b), half = (0.5 * core.distance) * core.normal;
  core.point_a = middle - half;
  core.point_b = middle + half;
}
// Unless the search came no nearer to it than `slack`.
void find_touch(const Simplex& simplex, Real slack, CoreSeparation& core) {
  Simplex face = simplex;
  ClosestPoint closest = closest_to_origin(face);
  if (closest.vertices == all_of_tetrahedron) {
    closest = closest_on_faces(face);
  }
  if (norm(closest.point) > slack) {
    return;
  }
  keep(face, closest.vertices);
  // The weights of slivers may be rounding. Points of both cores have them, which then are apart.
  const WeightedPoint common = point_with(face, weights_of(face, closest.point));
  if (norm(common.w) <= slack) {
    touch_at(common.a, common.a - common.w, core);
  }
}

}  // namespace abut
