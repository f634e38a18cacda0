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
  if (settings.algorithm != Algorithm::automatic && settings.algorithm != Algorithm::analytic) {
    return Outcome::unsupported;
  }
  const Vec3 n = a.normal();
  const SupportPoint lowest = b.support(ab.rotation.undo(-n));
  const Vec3 point_b = ab * lowest.point - b.radius() * n;
  const Real distance = dot(n, point_b) - a.offset();
  out = {distance, distance, distance, point_b - distance * n, point_b, n, Algorithm::analytic, 1};
  return Outcome::ok;
}

// The corners of the face of b that looks at the plane.
template <HalfSpace A, Convex B>
[[nodiscard]] Outcome half_space_contacts(const A& a, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  if (settings.algorithm != Algorithm::automatic && settings.algorithm != Algorithm::analytic) {
    return Outcome::unsupported;
  }
  const Vec3 n = a.normal();
  const Vec3 lowest = ab * b.support(ab.rotation.undo(-n)).point;
  if (dot(n, lowest) - b.radius() - a.offset() > settings.margin) {
    return Outcome::ok;
  }
  const Feature whole{FeatureKind::whole, 0};
  const Face face = placed_face(b, ab, -n);
  for (const FaceVertex& vertex : face.vertices.span()) {
    const Vec3 point_b = vertex.point - b.radius() * n;
    const Real distance = dot(n, point_b) - a.offset();
    if (distance <= settings.margin) {
      const Feature feature_b{FeatureKind::vertex, vertex.vertex};
      out.push_back({point_b - distance * n, point_b, n, distance, whole, feature_b, contact_id(whole, feature_b)});
    }
  }
  return Outcome::ok;
}

}  // namespace abut
