// SPDX-License-Identifier: Apache-2.0
// Where a polytope on its way leaves a triangle that it overlaps, by a portal: three points of the difference of both
// between which the way leads, moved outward until they lie in a face of it. Source: Snethen, "XenoCollide: Complex
// Collision Made Simple", Game Programming Gems 7, 2008.
export module abut.narrow.ways.leaving_portal;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// The end of the stretch, and the normal of the touch there, from the triangle.
struct PortalEnd {
  Real length;
  Vec3 normal;
};

// `ab`: where both overlap. Lengths count from there. An end before `least` or beyond `enough` is told less exactly,
// but on the right side of it. Nothing where rounding hides the portal, as where both barely overlap or the way only
// grazes a face.
template <Convex B>
[[nodiscard]] std::optional<PortalEnd> leave_by_portal(const Triangle& triangle, const B& b, const Pose& ab,
                                                       const Vec3& direction, Real least, Real enough, Real tolerance) {
  constexpr int most_steps = 40;
  // Lengths are rounded as reaches are, over the slope.
  constexpr Real least_slope = 1e-2, flat_square = 1e-12, parallel_square = 1e-24;
  const auto placement = place(b, ab);
  // Points p of the triangle less points of b: b moved along by t overlaps where t * direction is such a difference.
  const auto outermost = [&](const Vec3& normal) {
    return triangle.support(normal).point - placed_support(b, placement, -normal).point;
  };
  Vec3 p = outermost(direction);
  Vec3 normal = cross(p, direction);
  if (squared_norm(normal) <= parallel_square * squared_norm(p)) {
    const Real length = dot(p, direction);
    return length > 0 ? std::optional(PortalEnd{length, direction}) : std::nullopt;
  }
  Vec3 q = outermost(normal);
  if (!(dot(q, normal) > 0)) {
    return std::nullopt;
  }
  normal = cross(p, q);
  if (dot(normal, direction) < 0) {
    std::swap(p, q);
    normal = -normal;
  }
  // A third point, until the way leads between all three.
  Vec3 r{0, 0, 0};
  for (int step = 0;; ++step) {
    r = outermost(normal);
    if (step == most_steps || !(dot(r, normal) > 0)) {
      return std::nullopt;
    }
    if (dot(cross(p, r), direction) > 0) {
      q = r;
      normal = cross(p, r);
    } else if (dot(cross(r, q), direction) > 0) {
      p = r;
      normal = cross(r, q);
    } else {
      break;
    }
  }
  for (int step = 0; step < most_steps; ++step) {
    normal = cross(q - p, r - p);
    // The normal of a sliver is rounding.
    const Real size = norm(normal);
    if (!(size * size > flat_square * squared_norm(q - p) * squared_norm(r - p))) {
      return std::nullopt;
    }
    normal = (dot(normal, direction) < 0 ? -1 / size : 1 / size) * normal;
    const Real slope = dot(normal, direction);
    if (!(slope > 0)) {
      return std::nullopt;
    }
    const Vec3 beyond = outermost(normal);
    const Real reach = dot(normal, beyond), most = reach / slope, proven = dot(normal, p) / slope;
    if (slope > least_slope && (most < least || proven > enough)) {
      return PortalEnd{proven > enough ? proven : most, normal};
    }
    if (reach - dot(normal, p) <= tolerance) {
      return slope > least_slope && most > 0 ? std::optional(PortalEnd{most, normal}) : std::nullopt;
    }
    // The three planes through the way and the new point tell which one gives way.
    const Vec3 across = cross(beyond, direction);
    if (dot(p, across) > 0) {
      (dot(r, across) > 0 ? p : q) = beyond;
    } else {
      (dot(q, across) < 0 ? p : r) = beyond;
    }
  }
  return std::nullopt;
}

}  // namespace abut
