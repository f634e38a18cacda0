// SPDX-License-Identifier: Apache-2.0
// How deep two cores overlap: all separating axes, or the expanding polytope, which also answers for cores that GJK
// leaves open.
export module abut.narrow.convex.overlap;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.core_separation;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.fan.box_sat;
import abut.narrow.fan.discs.disc_depth_of_pair;
import abut.narrow.fan.disc_pairs;
import abut.narrow.fan.features;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.sat;
export import abut.narrow.fan.triangle_sat;
import abut.narrow.points.witnesses;
import abut.narrow.polytope.epa;
import abut.narrow.polytope.points_under;
import abut.narrow.polytope.polytope_depth;

export namespace abut {

// Boxes have a way of their own to try all axes.
template <class A, class B>
inline constexpr bool are_boxes = is_box<A> && is_box<B>;

// Along a normal, with the points of the features that it belongs to, or else with open support points.
template <Convex A, Convex B>
[[nodiscard]] CoreSeparation separation_along(const A& a, const B& b, const Pose& ab, const Vec3& normal,
                                              const CoreFeatures& features, Real size) {
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.overlap = true;
  core.algorithm = Algorithm::sat;
  core.normal = normal;
  core.features = features;
  core.point_a = a.support(normal).point;
  core.point_b = placed_support(b, place(b, ab), -normal).point;
  core.distance = core.lower = core.upper = dot(normal, core.point_b - core.point_a);
  core.points_open = true;
  if constexpr (are_numbered<A, B>) {
    core.points_open = !(features.are_edges() && find_edge_witnesses(a, b, ab, size, core));
  }
  return core;
}
// The same of the best axis, still without points and with edges of any direction.
[[nodiscard]] inline CoreSeparation separation_of(const SatResult& found, Real size) {
  CoreSeparation core{};
  core.rounding = rounding_of(size);
  core.overlap = true;
  core.algorithm = Algorithm::sat;
  core.normal = found.normal;
  core.features = found.features;
  core.distance = core.lower = core.upper = found.separation;
  core.points_open = true;
  core.iterations = found.axes;
  return core;
}
// Adds what it lacks.
template <Convex A, Convex B>
void complete(const A& a, const B& b, const Pose& ab, Real size, CoreSeparation& core) {
  if constexpr (are_numbered<A, B>) {
    direct_edges(a, b, ab, core.normal, core.features);
  }
  const CoreSeparation along = separation_along(a, b, ab, core.normal, core.features, size);
  core.point_a = along.point_a;
  core.point_b = along.point_b;
  core.points_open = along.points_open;
}
template <Convex A, Convex B>
[[nodiscard]] CoreSeparation separation_along(const A& a, const B& b, const Pose& ab, const SatResult& found,
                                              Real size) {
  CoreSeparation core = separation_of(found, size);
  complete(a, b, ab, size, core);
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
  const Real noise = rounding_of(largest_magnitude(apart) + a.extent() + b.extent());
  if (!(largest_magnitude(sideways) > noise)) {
    return tangents_of(*axis).first;
  }
  const Vec3 n = *UnitVec3::make(sideways);
  // Where little is left of a long way, part of it still leads along.
  const bool is_little = squared_norm(sideways) < slender_square * squared_norm(apart);
  return is_little ? UnitVec3::make(n - dot(n, axis->vec()) * axis->vec())->vec() : n;
}

template <FewFaced A, FewFaced B>
[[nodiscard]] [[gnu::noinline]] CoreSeparation separate_by_sat(const A& a, const B& b, const Pose& ab, Real size) {
  if constexpr (are_boxes<A, B>) {
    return separation_along(a, b, ab, sat_of_boxes(a.half(), b.half(), ab, noise_of(size), infinity), size);
  } else {
    if constexpr (has_triangle_sat<A, B>) {
      if (const std::optional<SatResult> found = triangle_sat(a, b, ab, noise_of(size))) {
        return separation_along(a, b, ab, *found, size);
      }
    }
    if (const std::optional<SatResult> found = sat(a, b, ab, noise_of(size))) {
      return separation_along(a, b, ab, *found, size);
    }
    // Without any axis the cores lie on one line.
    return separation_along(a, b, ab, direction_across(a, b, ab), {}, size);
  }
}

// False where there are too many axes, or rounding leaves the answer in doubt. `enough`: as hull_sat has it.
template <Convex A, Convex B>
  requires has_hull<A, B>
[[nodiscard]] [[gnu::noinline]] bool separate_by_hull_sat(const A& a, const B& b, const Pose& ab, Real size,
                                                          CoreSeparation& core, Real enough = infinity) {
  std::optional<SatResult> found = hull_sat(a, b, ab, noise_of(size), enough);
  if (!found) {
    return false;
  }
  if (found->features.are_known()) {
    direct_edges(a, b, ab, found->normal, found->features);
    found->normal = normal_of(a, b, ab, found->features);
  }
  CoreSeparation along = separation_along(a, b, ab, found->normal, found->features, size);
  // An edge that rounding has taken for the end of its core promises too much.
  if (!(std::fabs(along.distance - found->separation) <= noise_of(size))) [[unlikely]] {
    return false;
  }
  along.iterations = core.iterations + found->axes;
  along.upper += flatness_of(a) + flatness_of(b);
  along.rounding = noise_of(size);  // normals of slender faces are off by more than their corners
  core = along;
  return true;
}

// How deep two cores overlap by all axes that may be across it. False where they have too many, or rounding leaves the
// answer in doubt.
template <Convex A, Convex B>
[[nodiscard]] bool separate_by_axes(const A& a, const B& b, const Pose& ab, Real size, CoreSeparation& core) {
  if constexpr (FewFaced<A> && FewFaced<B>) {
    core = separate_by_sat(a, b, ab, size);
    return true;
  } else if constexpr (has_hull<A, B>) {
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
  if constexpr (has_discs<A, B>) {
    const std::optional<ProvenDepth> least = disc_depth(a, b, ab, size, error);
    if (!least) {
      return false;
    }
    const Vec3& n = least->normal;
    CoreSeparation under = core;
    under.normal = n;
    under.features = least->features;
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
    core.algorithm = Algorithm::rims;
    core.features = least->features;
    core.points_open = false;
    return true;
  } else {
    return false;
  }
}

}  // namespace abut
