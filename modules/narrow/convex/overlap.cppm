// How deep two cores overlap: all separating axes, or the expanding polytope, which also answers for cores that GJK
// leaves open.
export module abut.narrow.convex.overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.cores.difference;
import abut.narrow.cores.outlines;
import abut.narrow.cores.simplex;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.disc_depth_of_pair;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.sat;
import abut.narrow.points.witnesses;
import abut.narrow.polytope.capped_epa;
import abut.narrow.polytope.epa;
import abut.narrow.polytope.polytope_depth;

export namespace abut {

// Boxes have a way of their own to try all axes.
template <class A, class B>
concept TwoBoxes = BoxCored<A> && BoxCored<B> && A::core_axes == 3 && B::core_axes == 3;

// Under the normal found, with the support points along it.
[[nodiscard]] inline CoreSeparation separation_under(const SatResult& found, const Vec3& point_a, const Vec3& point_b,
                                                     Real size) {
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.overlap = true;
  core.algorithm = Algorithm::sat;
  core.iterations = found.axes;
  core.normal = found.normal;
  core.distance = core.lower = core.upper = found.separation;
  core.point_a = point_a;
  core.point_b = point_b;
  core.points_open = !(found.of_edges && find_edge_witnesses(found.edge_a, found.edge_b, core));
  return core;
}
// The lines along both edges may come closest beyond the ends of these: then the points are support points, and open.
inline void open_points(const Vec3& point_a, const Vec3& point_b, CoreSeparation& core) {
  core.point_a = point_a;
  core.point_b = point_b;
  core.points_open = true;
}

template <Convex A, Convex B>
[[nodiscard]] CoreSeparation separate_along(const A& a, const B& b, const Pose& ab, const SatResult& found, Real size) {
  const Vec3 point_a = a.support(found.normal).point;
  const Vec3 point_b = placed_support(b, place(b, ab), -found.normal).point;
  CoreSeparation core = separation_under(found, point_a, point_b, size);
  const Real slack = rounding_of(size);
  if (!core.points_open && !(holds(a, core.point_a, slack) && holds(b, ab.undo(core.point_b), slack))) [[unlikely]] {
    open_points(point_a, point_b, core);
  }
  return core;
}

// Any direction across two cores that touch without an axis of their own: across the longest edge that
// there is, toward the other centre where that says something.
template <FewFaced A, FewFaced B>
[[nodiscard]] Vec3 direction_across(const A& a, const B& b, const Pose& ab) {
  const Vec3 apart = placed_centre(b, ab) - a.centre();
  Vec3 along{0, 0, 0};
  const auto consider = [&](const Vec3& edge) { along = squared_norm(edge) > squared_norm(along) ? edge : along; };
  for (const Vec3& edge : a.edge_directions()) {
    consider(edge);
  }
  for (const Vec3& edge : b.edge_directions()) {
    consider(ab.rotation * edge);
  }
  const auto axis = UnitVec3::make(along);
  if (!axis) {
    return UnitVec3::make(apart).value_or(UnitVec3::axis_z());
  }
  const Vec3 sideways = apart - dot(apart, axis->vec()) * axis->vec();
  const Real noise = 16 * epsilon * (largest_magnitude(apart) + a.extent() + b.extent());
  if (!(largest_magnitude(sideways) > noise)) {
    return tangents_of(*axis).first;
  }
  const Vec3 n = *UnitVec3::make(sideways);
  // Where little is left of a long way, part of it still leads along.
  const bool is_little = squared_norm(sideways) < 1e-6 * squared_norm(apart);
  return is_little ? UnitVec3::make(n - dot(n, axis->vec()) * axis->vec())->vec() : n;
}

template <FewFaced A, FewFaced B>
[[nodiscard]] [[gnu::noinline]] CoreSeparation separate_by_sat(const A& a, const B& b, const Pose& ab, Real size) {
  if constexpr (TwoBoxes<A, B>) {
    return separate_along(a, b, ab, sat_of_boxes(a.half(), b.half(), ab, noise_of(size), infinity), size);
  } else {
    if (const std::optional<SatResult> found = sat(a, b, ab, noise_of(size))) {
      return separate_along(a, b, ab, *found, size);
    }
    // Without any axis the cores lie on one line.
    const Vec3 n = direction_across(a, b, ab), none{0, 0, 0};
    const Real separation = dot(n, placed_support(b, place(b, ab), -n).point - a.support(n).point);
    return separate_along(a, b, ab, SatResult{separation, n, 0, false, none, none}, size);
  }
}

// False where there are too many axes, or rounding leaves the answer in doubt.
template <Convex A, Convex B>
  requires HullAndSeen<A, B>
[[nodiscard]] [[gnu::noinline]] bool separate_by_hull_sat(const A& a, const B& b, const Pose& ab, Real size,
                                                          CoreSeparation& core) {
  std::optional<HullSatResult> found = hull_sat(a, b, ab, noise_of(size));
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
  const auto on_edge = [&](const Vec3& support, const Vec3& on, const Vec3& edge) {
    const Real off = noise_of(size);
    return found->of_edges && squared_norm(cross(support - on, edge)) > off * off * squared_norm(edge) ? on : support;
  };
  core = separation_under(*found, on_edge(point_a, found->on_a, found->edge_a),
                          on_edge(point_b, found->on_b, found->edge_b), size);
  const Real slack = noise_of(size);
  const auto is_on = [&]<class S>(const S& shape, const Vec3& own, const Vec3& point, const Vec3& from,
                                  const Vec3& edge) {
    if constexpr (Faceted<S>) {
      const Real at = dot(point - from, edge), square = squared_norm(edge), room = slack * std::sqrt(square);
      return at >= -room && at <= square + room;
    } else {
      return holds(shape, own, slack);
    }
  };
  if (!core.points_open && !(is_on(a, core.point_a, core.point_a, found->on_a, found->edge_a) &&
                             is_on(b, ab.undo(core.point_b), core.point_b, found->on_b, found->edge_b))) [[unlikely]] {
    open_points(point_a, point_b, core);
  }
  core.iterations += iterations;
  core.upper += flatness_of(a) + flatness_of(b);
  core.rounding = noise_of(size);  // normals of slender faces are off by more than their corners
  return true;
}

// How deep two cores overlap by all axes that may be across it. False where they have too many, or rounding leaves the
// answer in doubt.
template <Convex A, Convex B>
[[nodiscard]] bool separate_by_axes(const A& a, const B& b, const Pose& ab, Real size, CoreSeparation& core) {
  if constexpr (FewFaced<A> && FewFaced<B>) {
    core = separate_by_sat(a, b, ab, size);
    return true;
  } else if constexpr (HullAndSeen<A, B>) {
    return separate_by_hull_sat(a, b, ab, size, core);
  } else {
    return false;
  }
}

// A hull of discs and a polyhedron or another one, by all directions in which their overlap may be least. False where
// they hardly overlap, or rounding leaves the answer in doubt.
template <Convex A, Convex B>
[[nodiscard]] [[gnu::noinline]] bool separate_by_discs(const A& a, const B& b, const Pose& ab, Real size, Real error,
                                                       CoreSeparation& core) {
  if constexpr (WithDiscs<A, B>) {
    const Real noise = 8 * epsilon * size;
    if constexpr (Outlined<A> && Outlined<B>) {
      if (is_coaxial(ab, noise)) {
        return false;  // one outline in another says which of many directions that are as good
      }
    }
    const std::optional<ProvenDepth> least = disc_depth(a, b, ab, size, error);
    if (!least) {
      return false;
    }
    const Vec3& n = least->normal;
    CoreSeparation under = core;
    under.normal = n;
    under.distance = -least->depth;
    under.point_a = a.support(n).point;
    under.point_b = placed_support(b, place(b, ab), -n).point;
    if (dot(n, under.point_a - under.point_b) > least->depth + noise_of(size)) {
      return false;
    }
    EpaResult depth{least->depth, least->lower, least->depth, n, under.point_a, under.point_b, 1};
    const bool is_exact = find_disc_witnesses(a, b, ab, under);
    const auto minimum = is_exact ? std::nullopt : with_difference(a, b, ab, size, [&](const Difference& cores) {
      return with_points(cores, error, depth);
    });
    // Beside a parallel axis a minimum may lie far away along it. Support points then lie across each other but for the
    // tilt of the axis, which is far below the error.
    const bool is_held =
        minimum && holds(a, minimum->point_a, error / 4) && holds(b, ab.undo(minimum->point_b), error / 4);
    if (is_exact || (!is_held && find_vertex_witness(a, b, ab, error / 256, under))) {
      depth.point_a = under.point_a;
      depth.point_b = under.point_b;
    } else if (minimum) {
      depth = *minimum;
    } else {
      return false;
    }
    set_depth(depth, size, core);
    core.points_open = false;
    return true;
  } else {
    return false;
  }
}

}  // namespace abut
