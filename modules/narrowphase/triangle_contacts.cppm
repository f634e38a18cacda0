// A triangle of a surface against a convex shape. Beside the convex pair this knows two things about
// surfaces: a one-sided triangle only pushes to its front, and at an inner edge, across which the
// surface goes on, only the normal of the face counts, so that sliding shapes do not trip over seams.
module;
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>
export module abut.narrowphase.triangle_contacts;
import abut.core;
import abut.math;
import abut.narrowphase.convex;
import abut.shape;

export namespace abut {

// Barycentric weights below this put a point on the edge opposite to the corner.
inline constexpr Real on_edge = 1e-7;

// Whether a point of a triangle lies on inner edges only, so that the surface goes on around it.
[[nodiscard]] inline bool is_inner_point(const Triangle& triangle, const Vec3& point) {
  if (triangle.inner_edges() == 0) {
    return false;
  }
  const auto& corners = triangle.corners();
  const Vec3 scaled = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Real square = squared_norm(scaled);
  unsigned touched = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Real weight = dot(scaled, cross(corners[(i + 1) % 3] - corners[i], point - corners[i])) / square;
    if (std::fabs(weight) <= on_edge) {
      touched |= 1u << i;
    }
  }
  return touched != 0 && (touched & triangle.inner_edges()) == touched;
}

// Turns a separation to the normal of the face, on the side that the old normal points to, or on the
// front of a one-sided triangle.
template <Convex B>
void turn_to_face(const Triangle& triangle, const B& b, const Pose& ab, CoreSeparation& core) {
  const bool front = triangle.is_one_sided() || dot(core.normal, triangle.normal()) >= 0;
  core.normal = front ? triangle.normal() : -triangle.normal();
  core.point_b = placed_support(b, place(b, ab), -core.normal).point;
  core.distance = dot(core.normal, core.point_b - triangle.corners()[0]);
  core.lower = core.upper = core.distance;
  core.point_a = core.point_b - core.distance * core.normal;
}

// Whether the foot of a point lies on the triangle.
[[nodiscard]] inline bool is_over(const Triangle& triangle, const Vec3& point) {
  const auto& corners = triangle.corners();
  const Real slack = -on_edge * squared_norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const Vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return dot(n, cross(corners[1] - corners[0], point - corners[0])) >= slack &&
         dot(n, cross(corners[2] - corners[1], point - corners[1])) >= slack &&
         dot(n, cross(corners[0] - corners[2], point - corners[2])) >= slack;
}

// A one-sided triangle that a core overlaps from behind pushes it out through its front.
template <Convex B>
[[nodiscard]] CoreSeparation separate_from_triangle(const Triangle& triangle, const B& b, const Pose& ab,
                                                    const QuerySettings& settings, Real limit) {
  CoreSeparation core = separate_cores(triangle, b, ab, settings, limit);
  find_points(triangle, b, ab, core);
  if (core.overlap && triangle.is_one_sided() && triangle.has_area() && dot(core.normal, triangle.normal()) < 0) {
    turn_to_face(triangle, b, ab, core);
  }
  return core;
}

template <Convex B>
void triangle_contacts(const Triangle& triangle, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  const Real radii = b.radius();
  CoreSeparation core = separate_from_triangle(triangle, b, ab, settings, settings.margin + radii);
  if (core.beyond || core.distance - radii > settings.margin) {
    return;
  }
  if (triangle.has_area()) {
    if (triangle.is_one_sided() && dot(core.normal, triangle.normal()) < 0) {
      // A core beside or behind the triangle: only what its rounding has sunk in from the front counts.
      if (dot(triangle.normal(), ab * b.centre() - triangle.corners()[0]) < 0) {
        return;
      }
      turn_to_face(triangle, b, ab, core);
    } else if (is_inner_point(triangle, core.point_a)) {
      turn_to_face(triangle, b, ab, core);
    }
  }
  // After a turn the closest points may lie beside the triangle, over a neighbour that has them too.
  const bool closest_count = !triangle.has_area() || is_over(triangle, core.point_a);
  const std::size_t first = out.size();
  contacts_under(triangle, b, ab, core, settings.margin, closest_count, out);
  // Seen from outside, the feature of a surface is its triangle; the number of the contact still tells
  // the corners and edges of the triangle apart.
  for (std::size_t i = first; i < out.size(); ++i) {
    out[i].id = mixed(out[i].id + triangle.index());
    out[i].feature_a = {FeatureKind::face, triangle.index()};
  }
}

}  // namespace abut
