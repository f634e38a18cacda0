// A half-space against what has support points: exact in one step.
module;
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>
export module abut.narrowphase.half_space;
import abut.core;
import abut.math;
import abut.shape;

export namespace abut {

template <HalfSpace A, Convex B>
[[nodiscard]] Outcome half_space_distance(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Distance& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const Vec3 n = a.normal();
  const SupportPoint lowest = b.support(ab.rotation.undo(-n));
  const Vec3 point_b = ab * lowest.point - b.radius() * n;
  const Real distance = dot(n, point_b) - a.offset();
  out = {distance, distance, distance, point_b - distance * n, point_b, n, Algorithm::analytic, 1};
  return Outcome::ok;
}

// The corners of the face of b that looks at the plane, and the lowest point where it is none of them, as on a
// rim between its corners.
template <HalfSpace A, Convex B>
[[nodiscard]] Outcome half_space_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  if (!takes_closed_forms(settings.algorithm)) {
    return Outcome::unsupported;
  }
  const Vec3 n = a.normal();
  const Vec3 lowest = ab * b.support(ab.rotation.undo(-n)).point;
  const Real deepest = dot(n, lowest) - b.radius() - a.offset();
  if (deepest > settings.margin) {
    return Outcome::ok;
  }
  const Feature whole{FeatureKind::whole, 0};
  Real least = infinity;
  const auto append = [&](const Vec3& core_point, const Feature& feature_b) {
    const Vec3 point_b = core_point - b.radius() * n;
    const Real distance = dot(n, point_b) - a.offset();
    least = distance < least ? distance : least;
    if (distance <= settings.margin) {
      out.push_back({point_b - distance * n, point_b, n, distance, whole, feature_b, contact_id(whole, feature_b)});
    }
  };
  const Face face = placed_face(b, ab, -n);
  for (const FaceVertex& vertex : face.vertices.span()) {
    append(vertex.point, {FeatureKind::vertex, vertex.vertex});
  }
  if constexpr (Curved<B>) {
    const Real noise = 64 * epsilon * (b.extent() + largest_magnitude(lowest));
    if (least > deepest + noise) {
      append(lowest, feature_of(face));
    }
  }
  return Outcome::ok;
}

}  // namespace abut
