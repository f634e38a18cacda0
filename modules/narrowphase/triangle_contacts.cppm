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

// Whether a core lies behind a one-sided triangle rather than on or through it.
template <Convex B>
[[nodiscard]] bool lies_behind(const Triangle& triangle, const B& b, const Pose& ab, const CoreSeparation& core) {
  return !core.overlap && dot(triangle.normal(), ab * b.centre() - triangle.corners()[0]) < 0 &&
         dot(core.normal, triangle.normal()) < 0;
}

// Like separate_cores, with the rules of surfaces. False when the triangle does not stop the shape.
template <Convex B>
[[nodiscard]] bool separate_from_triangle(const Triangle& triangle, const B& b, const Pose& ab, const QuerySettings& settings,
                                          Real limit, CoreSeparation& core) {
  core = separate_cores(triangle, b, ab, settings, limit);
  if (core.beyond) {
    return false;
  }
  if (!triangle.has_area()) {
    return true;
  }
  if (triangle.is_one_sided() && dot(core.normal, triangle.normal()) < 0) {
    if (lies_behind(triangle, b, ab, core)) {
      return false;
    }
    turn_to_face(triangle, b, ab, core);
  } else if (is_inner_point(triangle, core.point_a)) {
    turn_to_face(triangle, b, ab, core);
  }
  return true;
}

template <Convex B>
void triangle_contacts(const Triangle& triangle, const B& b, const Pose& ab, const QuerySettings& settings, Manifold& out) {
  const Real radii = b.radius();
  CoreSeparation core{};
  if (!separate_from_triangle(triangle, b, ab, settings, settings.margin + radii, core) ||
      core.distance - radii > settings.margin) {
    return;
  }
  const std::size_t first = out.size();
  contacts_under(triangle, b, ab, core, settings.margin, out);
  // Seen from outside, the feature of a surface is its triangle; the number of the contact still tells
  // the corners and edges of the triangle apart.
  for (std::size_t i = first; i < out.size(); ++i) {
    out[i].id = mixed(out[i].id + triangle.index());
    out[i].feature_a = {FeatureKind::face, triangle.index()};
  }
}

}  // namespace abut
