// How far two convex cores are apart or in each other: closed forms or GJK, and where the cores overlap
// all separating axes or the expanding polytope.
export module abut.narrowphase.separation;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.narrowphase.across;
import abut.narrowphase.box_cores;
import abut.narrowphase.box_sat;
import abut.narrowphase.capped_epa;
import abut.narrowphase.clip;
import abut.narrowphase.epa;
import abut.narrowphase.gjk;
import abut.narrowphase.hull_sat;
import abut.narrowphase.sat;
import abut.narrowphase.simplex;
import abut.shape;

export namespace abut {

// The separation of two cores and how it was found, in the frame of a.
struct CoreSeparation {
  Real distance, lower, upper;
  Real rounding;  // of the coordinates, by which the bounds may be off
  Vec3 normal;    // unit, from a to b
  Vec3 point_a, point_b;
  bool points_open;  // the points are any support points so far: find_points has to look for them
  bool beyond;   // only `lower` was found, and exceeds the limit asked for
  bool overlap;  // the cores overlap or touch
  Algorithm algorithm;
  std::uint32_t iterations;
};

// Bound of the coordinates of both cores in the frame of a: rounding is relative to it.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Real core_size(const A& a, const B& b, const Pose& ab) {
  return 2 * (a.extent() + b.extent()) + largest_magnitude(a.centre()) + largest_magnitude(placed_centre(b, ab));
}

// The usual bounds of errors, relative to the size of the shapes: searches on curved surfaces come nearer step
// by step, those on polytopes end.
inline constexpr Real usual_error = 1e-12, usual_error_of_curves = 2e-10;

// Depths of curved cores that differ by less are the same to the corners of a contact.
[[nodiscard]] [[gnu::always_inline]] inline Real curve_blur(Real size) { return 0.5 * usual_error_of_curves * size; }

// The bound asked for, on shapes of their own size, and no finer than coordinates are.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::always_inline]] inline Real error_of(const A& a, const B& b, Real size, const QuerySettings& settings) {
  const Real shape_size = 2 * (a.extent() + b.extent()) + a.radius() + b.radius();
  constexpr Real usual = Curved<A> || Curved<B> ? usual_error_of_curves : usual_error;
  return (settings.error_bound > 0 ? settings.error_bound : usual) * shape_size + 4 * epsilon * size;
}

// What the coordinates of cores of this size may be off by, and with them all bounds.
[[nodiscard]] [[gnu::always_inline]] inline Real rounding_of(Real size) { return 16 * epsilon * size; }
// Depths along two axes that differ by less are the same.
[[nodiscard]] [[gnu::always_inline]] inline Real noise_of(Real size) { return 64 * epsilon * size; }

// Any direction across two cores that touch without an axis of their own: across the first edge that
// there is, toward the other centre where that says something.
template <FewFaced A, FewFaced B>
[[nodiscard]] Vec3 direction_across(const A& a, const B& b, const Pose& ab) {
  const Vec3 apart = placed_centre(b, ab) - a.centre();
  Vec3 along{0, 0, 0};
  for (const Vec3& edge : b.edge_directions()) {
    along = ab.rotation * edge;
  }
  for (const Vec3& edge : a.edge_directions()) {
    along = edge;
  }
  const auto axis = UnitVec3::make(along);
  if (!axis) {
    return UnitVec3::make(apart).value_or(UnitVec3::axis_z());
  }
  const Vec3 sideways = apart - dot(apart, axis->vec()) * axis->vec();
  const Real noise = 16 * epsilon * (largest_magnitude(apart) + a.extent() + b.extent());
  return largest_magnitude(sideways) > noise ? UnitVec3::make(sideways)->vec() : tangents_of(*axis).first;
}

// The deepest pair of points under a normal across an edge of each: the closest points of the lines
// along both edges through the support points.
inline void find_edge_witnesses(const Vec3& edge_a, const Vec3& edge_b, CoreSeparation& core) {
  const Vec3 across = cross(edge_a, edge_b), between = core.point_b - core.point_a;
  const Real square = squared_norm(across);
  core.point_a += (dot(across, cross(between, edge_b)) / square) * edge_a;
  core.point_b += (dot(across, cross(between, edge_a)) / square) * edge_b;
}

// The deepest pair of points under the normal of a face: from the common region of the supporting faces,
// or else from what is outermost of them.
inline void find_points_of_faces(const Face& face_a, const Face& face_b, const ClipPoints& region, Real size, CoreSeparation& core) {
  AcrossPair pair{core.point_a, core.point_b};
  // Nearly parallel faces are equally far in many points; one of their common region will do.
  const Real deepest = core.distance + 1e-12 * size;
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
  // What rounding leaves between the points and the distance is shared by both.
  const Vec3 half = (0.5 * (core.distance - dot(pair.point_b - pair.point_a, core.normal))) * core.normal;
  core.point_a = pair.point_a - half;
  core.point_b = pair.point_b + half;
  core.points_open = false;
}

// Mostly a vertex lies under the inside of a face. False where neither support point does.
template <Convex A, Convex B>
  requires HullAndSeen<A, B>
[[nodiscard]] inline bool find_vertex_witness(const A& a, const B& b, const Pose& ab, CoreSeparation& core) {
  const Real slack = rounding_of(core_size(a, b, ab));
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

// A round core that leans on a face touches it under one point, which the polygon of its rim misses. False where neither
// support point lies over the other core.
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
    if constexpr (HullAndSeen<A, B>) {
      if (core.overlap && find_vertex_witness(a, b, ab, core)) {
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

// By how much cores are rounded off whose distance is hard to tell from none, relative to their size.
inline constexpr Real rounding_share = 1e-3;

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
inline void find_touch(const Simplex& simplex, Real slack, CoreSeparation& core) {
  Simplex face = simplex;
  ClosestPoint closest = closest_to_origin(face);
  if (closest.vertices == all_of_tetrahedron) {
    closest = closest_on_faces(face);
  }
  if (norm(closest.point) > slack) {
    return;
  }
  keep(face, closest.vertices);
  const Vec3 on_a = witness_on_a(face, closest.point);
  touch_at(on_a, on_a - closest.point, core);
}

// Boxes have a way of their own to try all axes.
template <class A, class B>
concept TwoBoxes = BoxCored<A> && BoxCored<B> && A::core_axes == 3 && B::core_axes == 3;

// Under the normal found, with the support points along it.
[[nodiscard]] inline CoreSeparation separation_under(const SatResult& found, const Vec3& point_a, const Vec3& point_b, Real size) {
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.overlap = true;
  core.algorithm = Algorithm::sat;
  core.iterations = found.axes;
  core.normal = found.normal;
  core.distance = core.lower = core.upper = found.separation;
  core.point_a = point_a;
  core.point_b = point_b;
  core.points_open = !found.of_edges;
  if (found.of_edges) {
    find_edge_witnesses(found.edge_a, found.edge_b, core);
  }
  return core;
}
template <Convex A, Convex B>
[[nodiscard]] CoreSeparation separate_along(const A& a, const B& b, const Pose& ab, const SatResult& found, Real size) {
  return separation_under(found, a.support(found.normal).point, placed_support(b, place(b, ab), -found.normal).point, size);
}

template <FewFaced A, FewFaced B>
[[nodiscard]] [[gnu::noinline]] CoreSeparation separate_by_sat(const A& a, const B& b, const Pose& ab, Real size) {
  if constexpr (TwoBoxes<A, B>) {
    return separate_along(a, b, ab, sat_of_boxes(a.half(), b.half(), ab, noise_of(size), infinity), size);
  } else {
    const std::optional<SatResult> found = sat(a, b, ab, noise_of(size));
    // Without any axis the cores only touch.
    const Vec3 none{0, 0, 0};
    return separate_along(a, b, ab, found ? *found : SatResult{0, direction_across(a, b, ab), 0, false, none, none}, size);
  }
}

// False where there are too many axes, or rounding leaves the answer in doubt.
template <Convex A, Convex B>
  requires HullAndSeen<A, B>
[[nodiscard]] [[gnu::noinline]] bool separate_by_hull_sat(const A& a, const B& b, const Pose& ab, Real size, CoreSeparation& core) {
  std::optional<SatResult> found = hull_sat(a, b, ab, noise_of(size));
  if (!found) {
    return false;
  }
  const Vec3 point_a = a.support(found->normal).point;
  const Vec3 point_b = placed_support(b, place(b, ab), -found->normal).point;
  const Real separation = dot(found->normal, point_b - point_a);
  // An edge that rounding has taken for the end of its core promises too much.
  if (!(std::fabs(separation - found->separation) <= noise_of(size))) [[unlikely]] {
    return false;
  }
  found->separation = separation;
  const std::uint32_t iterations = core.iterations;
  core = separation_under(*found, point_a, point_b, size);
  core.iterations += iterations;
  core.upper += flatness_of(a) + flatness_of(b);
  core.rounding = noise_of(size);  // normals of slender faces are off by more than their corners
  return true;
}

// Out of line, here and below: a polytope takes pages of the stack, each of which is touched on the way in.
template <Convex A, Convex B>
[[gnu::noinline]] void separate_by_epa(const A& a, const B& b, const Pose& ab, Real size, Real error, const Simplex& start, CoreSeparation& core) {
  EpaResult found;
  if constexpr (Curved<A> || Curved<B>) {
    found = capped_epa(a, b, ab, size, error, start);
  } else {
    found = epa(a, b, ab, size, error, start);
  }
  if (found.upper - found.lower > error + noise_of(size)) [[unlikely]] {
    // A polytope that starts on slivers may not grow to the end; one that starts along the axes then does.
    const EpaResult again = epa(a, b, ab, size, error, Simplex{});
    found = again.upper < found.upper ? again : found;
  }
  core.algorithm = Algorithm::gjk_epa;
  core.iterations += found.iterations;
  core.rounding = noise_of(size);  // normals of slender triangles are off by more than their corners
  core.normal = found.normal;
  core.distance = -found.depth;
  core.lower = -found.upper;
  core.upper = -found.lower;
  core.point_a = found.point_a;
  core.point_b = found.point_b;
  // The polytope knows one triangle of a face, which need not hold the closest points of both faces. Curved
  // surfaces have no such faces.
  const Vec3 aside = core.point_b - core.point_a - core.distance * core.normal;
  core.points_open = !(Curved<A> || Curved<B>) && largest_magnitude(aside) > noise_of(size);
}

// How far cores are apart that GJK has left without a proof: how deep they overlap with a rounded off by more.
// They touch nearly, or one is a speck beside the other.
template <Convex A, Convex B>
[[gnu::noinline, gnu::cold]] void separate_by_rounding(const A& a, const B& b, const Pose& ab, Real size, Real error, CoreSeparation& core) {
  const Real rounding = 4 * core.upper + rounding_share * (a.extent() + b.extent());
  const EpaResult found = epa(a, b, ab, size, error, Simplex{}, rounding);
  core.iterations += found.iterations;
  // What belongs to both bounds the distance from above, wherever it was found.
  if (core.lower > 0 && !(found.upper - found.inside < core.upper - core.lower)) {
    return;
  }
  core.rounding = noise_of(size + rounding);
  core.overlap = found.depth >= rounding;
  core.normal = found.normal;
  core.distance = rounding - found.depth;
  core.lower = rounding - found.upper;
  core.upper = rounding - (found.inside < found.upper ? found.inside : found.upper);
  core.point_a = found.point_a;
  core.point_b = found.point_b;
}

// Where the rim of a round core touches, GJK may end on slivers near the common point, which a polytope finds. False unless
// the cores surely neither overlap nor are apart by more than the error.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline, gnu::cold]] bool separate_by_touch(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                                                  const Simplex& start, CoreSeparation& core) {
  const EpaResult found = capped_epa(a, b, ab, size, error, start);
  core.iterations += found.iterations;
  const Real apart = norm(found.point_b - found.point_a);
  if (!(std::fabs(found.depth) <= error && found.upper - found.lower <= error && apart <= error)) {
    return false;
  }
  core.rounding = noise_of(size);
  core.algorithm = Algorithm::gjk_epa;
  core.overlap = true;
  core.normal = found.normal;
  core.distance = -found.depth;
  core.lower = -found.upper;
  core.upper = apart > -found.lower ? apart : -found.lower;
  core.point_a = found.point_a;
  core.point_b = found.point_b;
  return true;
}

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
[[nodiscard]] inline bool separate_box_cores(const A& a, const B& b, const Pose& ab, Real size, Real error, Real limit, Vec3& toward,
                                      CoreSeparation& core) {
  if constexpr (TwoBoxes<A, B>) {
    // Whoever wants contacts mostly asks about boxes that overlap, or are known apart by an axis.
    if (limit < infinity) {
      const SatResult found = sat_of_boxes(a.half(), b.half(), ab, noise_of(size), limit);
      core.lower = found.separation;
      core.beyond = found.separation > limit;
      if (core.beyond) {
        return true;
      }
      if (found.separation <= touching_distance(size)) {
        core = separate_along(a, b, ab, found, size);
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
concept PointAndField = (PointCored<A> && Field<B>) || (Field<A> && PointCored<B>);

template <Convex A, Convex B>
  requires PointAndField<A, B>
[[nodiscard]] [[gnu::always_inline]] inline CoreSeparation separate_point(const A& a, const B& b, const Pose& ab, Real size) {
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

// GJK for any cores, whatever they are, from the direction `toward` on, and where they overlap the best
// way to the depth.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] CoreSeparation separate_by_gjk(const A& a, const B& b, const Pose& ab, const QuerySettings& settings,
                                                               const Vec3& toward, Real size, Real error, Real limit) {
  // What the searches for overlaps say of cores that are apart bounds their distance from below only: a coarse bound
  // must not send any there.
  const Real unproven = error_of(a, b, size, QuerySettings{});
  GjkResult near = gjk(a, b, ab, toward, size, error, limit, unproven);
  const auto is_open = [&] { return !near.overlap && !near.beyond && near.upper - near.lower > error + noise_of(size); };
  if (is_open()) [[unlikely]] {
    // Rounding stopped it short of a proof; from the point that it reached another simplex may go further.
    const GjkResult again = gjk(a, b, ab, -near.closest, size, error, limit, unproven);
    near = again.overlap || again.beyond || again.upper - again.lower < near.upper - near.lower ? again : near;
  }
  if constexpr (Curved<A> || Curved<B>) {
    if (is_open() && near.upper <= projection_limit * size) [[unlikely]] {
      CoreSeparation touch{};
      touch.iterations = near.iterations;
      if (separate_by_touch(a, b, ab, size, error, near.simplex, touch) || separate_by_touch(a, b, ab, size, error, Simplex{}, touch)) {
        return touch;
      }
    }
  }
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.algorithm = Algorithm::gjk_epa;
  core.iterations = near.iterations;
  core.lower = near.lower;
  core.beyond = near.beyond;
  core.overlap = near.overlap;
  if (near.beyond) {
    return core;
  }
  if (!near.overlap) {
    core.normal = near.normal;
    core.point_a = witness_on_a(near.simplex, near.closest);
    core.point_b = core.point_a - near.closest;
    core.distance = core.upper = near.upper;
    if (!(near.lower > 0) || near.upper - near.lower > error + noise_of(size)) [[unlikely]] {
      separate_by_rounding(a, b, ab, size, error, core);
    }
    return core;
  }
  if constexpr (FewFaced<A> && FewFaced<B>) {
    if (settings.algorithm != Algorithm::gjk_epa) {
      core = separate_by_sat(a, b, ab, size);
      core.iterations += near.iterations;
      if (is_touch(core, size)) {
        find_touch(near.simplex, error, core);
      }
      return core;
    }
  }
  if constexpr (HullAndSeen<A, B>) {
    if (settings.algorithm != Algorithm::gjk_epa && separate_by_hull_sat(a, b, ab, size, core)) {
      if (is_touch(core, size)) {
        find_touch(near.simplex, error, core);
      }
      return core;
    }
  }
  separate_by_epa(a, b, ab, size, error, near.simplex, core);
  if (Curved<A> || Curved<B> ? std::fabs(core.distance) <= error : is_touch(core, size)) {
    find_touch(near.simplex, error, core);
  }
  return core;
}

// `limit`: the caller only wants to know how near the cores are when they are nearer than this.
template <Convex A, Convex B>
[[nodiscard]] inline CoreSeparation separate_cores(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Real limit) {
  const Real size = core_size(a, b, ab);
  const Real error = error_of(a, b, size, settings);
  if constexpr (PointAndField<A, B>) {
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
