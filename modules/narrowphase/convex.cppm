// Signed distance and contacts of two convex shapes: GJK between the cores, and where the cores
// overlap all separating axes or the expanding polytope. Radii are added at the end, so a shallow
// contact of rounded shapes comes exactly from the distance of the cores.
module;
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>
export module abut.narrowphase.convex;
import abut.core;
import abut.math;
import abut.narrowphase.clip;
import abut.narrowphase.epa;
import abut.narrowphase.gjk;
import abut.narrowphase.libccd;
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
  bool beyond;   // only `lower` was found, and exceeds the limit asked for
  bool overlap;  // the cores overlap or touch
  Algorithm algorithm;
  std::uint32_t iterations;
};

// Bound of the coordinates of both cores in the frame of a: rounding is relative to it.
template <Convex A, Convex B>
[[nodiscard]] inline Real core_size(const A& a, const B& b, const Pose& ab) {
  return 2 * (a.extent() + b.extent()) + largest_magnitude(a.centre()) + largest_magnitude(ab * b.centre());
}

// Any direction across two cores that touch without an axis of their own: across the first edge that
// there is, toward the other centre where that says something.
template <FewFaced A, FewFaced B>
[[nodiscard]] Vec3 direction_across(const A& a, const B& b, const Pose& ab) {
  const Vec3 apart = ab * b.centre() - a.centre();
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

// The deepest pair of points under the normal of a face: from the common region of the supporting
// faces, or else the support points, which are at the right distance along the normal.
template <Convex A, Convex B>
void find_face_witnesses(const A& a, const B& b, const Pose& ab, CoreSeparation& core) {
  [[clang::uninitialized]] const Face face_a = a.supporting_face(core.normal);
  [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal);
  if (face_a.vertices.size() == 1) {
    core.point_b = core.point_a + core.distance * core.normal;
    return;
  }
  if (face_b.vertices.size() == 1) {
    core.point_a = core.point_b - core.distance * core.normal;
    return;
  }
  [[clang::uninitialized]] ClipPoints points;
  clip_faces(face_a, face_b, core.normal, points);
  Real least = core.distance + 1e-12 * core_size(a, b, ab);
  for (const ClipPoint& point : points.span()) {
    const Real distance = dot(point.point_b - point.point_a, core.normal);
    if (distance <= least) {
      least = distance;
      core.point_a = point.point_a;
      core.point_b = point.point_b;
    }
  }
  // What rounding leaves between the points and the distance is shared by both.
  const Vec3 half = (0.5 * (core.distance - dot(core.point_b - core.point_a, core.normal))) * core.normal;
  core.point_a = core.point_a - half;
  core.point_b += half;
}

template <Convex A, Convex B>
void separate_by_sat(const A& a, const B& b, const Pose& ab, Real noise, CoreSeparation& core)
  requires FewFaced<A> && FewFaced<B>
{
  const std::optional<SatResult> found = sat(a, b, ab, noise);
  core.algorithm = Algorithm::sat;
  core.iterations += found ? found->axes : 0;
  core.normal = found ? found->normal : direction_across(a, b, ab);
  core.distance = core.lower = core.upper = found ? found->separation : 0;
  core.point_a = a.support(core.normal).point;
  core.point_b = placed_support(b, place(b, ab), -core.normal).point;
  if (found && found->of_edges) {
    find_edge_witnesses(found->edge_a, found->edge_b, core);
  } else {
    find_face_witnesses(a, b, ab, core);
  }
}

template <Convex A, Convex B>
void separate_by_epa(const A& a, const B& b, const Pose& ab, Real size, Real error, const Simplex& start, CoreSeparation& core) {
  const EpaResult found = epa(a, b, ab, size, error, start);
  core.algorithm = Algorithm::gjk_epa;
  core.iterations += found.iterations;
  core.normal = found.normal;
  core.distance = -found.depth;
  core.lower = -found.upper;
  core.upper = -found.lower;
  core.point_a = found.point_a;
  core.point_b = found.point_b;
  // The polytope knows one triangle of a face, which need not hold the closest points of both faces.
  const Vec3 aside = core.point_b - core.point_a - core.distance * core.normal;
  if (largest_magnitude(aside) > core.rounding) {
    find_face_witnesses(a, b, ab, core);
  }
}

// `limit`: the caller only wants to know how near the cores are when they are nearer than this.
template <Convex A, Convex B>
[[nodiscard]] CoreSeparation separate_cores(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Real limit) {
  const Real size = core_size(a, b, ab);
  const Real shape_size = 2 * (a.extent() + b.extent()) + a.radius() + b.radius();
  const Real error = settings.error_bound * shape_size + 4 * epsilon * size;
  CoreSeparation core{};
  core.rounding = 64 * epsilon * size;
  const GjkResult near = gjk(a, b, ab, size, error, limit);
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
    return core;
  }
  if constexpr (FewFaced<A> && FewFaced<B>) {
    if (settings.algorithm != Algorithm::gjk_epa) {
      separate_by_sat(a, b, ab, core.rounding, core);
      return core;
    }
  }
  separate_by_epa(a, b, ab, size, error, near.simplex, core);
  return core;
}

// Rounds the cores off: both surfaces move toward each other along the normal.
[[nodiscard]] inline Distance rounded(const CoreSeparation& core, Real radius_a, Real radius_b) {
  const Real radii = radius_a + radius_b;
  return {core.distance - radii,
          core.lower - core.rounding - radii,
          core.upper + core.rounding - radii,
          core.point_a + radius_a * core.normal,
          core.point_b - radius_b * core.normal,
          core.normal,
          core.algorithm,
          core.iterations};
}

template <Convex A, Convex B>
[[nodiscard]] Outcome convex_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& out) {
  if (settings.algorithm == Algorithm::analytic) {
    return Outcome::unsupported;
  }
  if (settings.algorithm == Algorithm::libccd_gjk || settings.algorithm == Algorithm::libccd_mpr) {
    return libccd_distance(a, b, ab, settings.algorithm, out);
  }
  if (settings.algorithm == Algorithm::sat) {
    if constexpr (FewFaced<A> && FewFaced<B>) {
      // Axes bound the distance of separated shapes only from below, so they need the overlap.
      const CoreSeparation core = separate_cores(a, b, ab, settings, infinity);
      if (!core.overlap) {
        return Outcome::unsupported;
      }
      out = rounded(core, a.radius(), b.radius());
      return Outcome::ok;
    } else {
      return Outcome::unsupported;
    }
  }
  out = rounded(separate_cores(a, b, ab, settings, infinity), a.radius(), b.radius());
  return Outcome::ok;
}

// Appends the corners of the contact region under a given separation, and the closest points where the
// region misses them, unless those are known not to count.
template <Convex A, Convex B>
void contacts_under(const A& a, const B& b, const Pose& ab, const CoreSeparation& core, Real margin, bool closest_count,
                    Manifold& out) {
  const Real radii = a.radius() + b.radius();
  const std::size_t first = out.size();
  [[clang::uninitialized]] ClipPoints points;
  [[clang::uninitialized]] const Face face_a = a.supporting_face(core.normal);
  [[clang::uninitialized]] const Face face_b = placed_face(b, ab, -core.normal);
  clip_faces(face_a, face_b, core.normal, points);
  Real least = infinity;
  const auto append = [&](const Vec3& point_a, const Vec3& point_b, const Feature& feature_a, const Feature& feature_b) {
    const Real distance = dot(point_b - point_a, core.normal) - radii;
    if (distance <= margin) {
      least = distance < least ? distance : least;
      out.push_back({point_a + a.radius() * core.normal, point_b - b.radius() * core.normal, core.normal, distance, feature_a,
                     feature_b, contact_id(feature_a, feature_b)});
    }
  };
  for (const ClipPoint& point : points.span()) {
    append(point.point_a, point.point_b, point.feature_a, point.feature_b);
  }
  // Where the region misses the closest points, as between edges that cross, they are the contact.
  const Real slack = 64 * epsilon * core_size(a, b, ab);
  if (closest_count && (out.size() == first || least > core.distance - radii + slack)) {
    const auto feature_of = [](const Face& face) {
      return face.vertices.size() == 1   ? Feature{FeatureKind::vertex, face.vertices[0].vertex}
             : face.vertices.size() == 2 ? Feature{FeatureKind::edge, face.vertices[0].edge}
                                         : Feature{FeatureKind::face, face.index};
    };
    append(core.point_a, core.point_b, feature_of(face_a), feature_of(face_b));
  }
}

template <Convex A, Convex B>
[[nodiscard]] Outcome convex_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  if (settings.algorithm == Algorithm::analytic) {
    return Outcome::unsupported;
  }
  const Real radii = a.radius() + b.radius();
  CoreSeparation core{};
  if (settings.algorithm == Algorithm::libccd_gjk || settings.algorithm == Algorithm::libccd_mpr) {
    Distance found{};
    const Outcome outcome = libccd_distance(a, b, ab, settings.algorithm, found);
    if (outcome == Outcome::apart || (outcome == Outcome::ok && found.distance > settings.margin)) {
      return Outcome::ok;
    }
    if (outcome != Outcome::ok) {
      return outcome;
    }
    core.normal = found.normal;
    core.distance = found.distance + radii;
    core.point_a = found.point_a - a.radius() * found.normal;
    core.point_b = found.point_b + b.radius() * found.normal;
  } else {
    core = separate_cores(a, b, ab, settings, settings.margin + radii);
    if (core.beyond || core.distance - radii > settings.margin) {
      return Outcome::ok;
    }
    if (settings.algorithm == Algorithm::sat && !(core.overlap && core.algorithm == Algorithm::sat)) {
      return Outcome::unsupported;
    }
  }
  contacts_under(a, b, ab, core, settings.margin, true, out);
  return Outcome::ok;
}

}  // namespace abut
