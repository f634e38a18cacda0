// SPDX-License-Identifier: Apache-2.0
// The point of a triangle that is nearest to a given one. The region that the given one lies over decides. Source:
// Ericson, "Real-Time Collision Detection", 2005, section 5.1.5.
export module abut.narrow.triangle.triangle_point;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

// The point of a triangle that is nearest to a given one, and the way from it to that one. The direction of a short way
// between two points has their rounding. This one is perpendicular to the edge or the face in which it begins.
struct WayFromTriangle {
  Vec3 from, way;
};

[[nodiscard]] inline WayFromTriangle nearest_way(const TriangleCorners& corners, const Vec3& point) {
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
  const auto from_edge = [&](const Vec3& first, const Vec3& edge, Real share) -> WayFromTriangle {
    const Vec3 from = first + share * edge, way = point - from;
    const Real square = squared_norm(edge);
    return {from, square > 0 ? way - (dot(way, edge) / square) * edge : way};
  };
  const Real ab_a = dot(ab, ap), ac_a = dot(ac, ap);
  if (ab_a <= 0 && ac_a <= 0) {
    return {a, ap};
  }
  const Real ab_b = dot(ab, bp), ac_b = dot(ac, bp);
  if (ab_b >= 0 && ac_b <= ab_b) {
    return {b, bp};
  }
  const Real over_c = ab_a * ac_b - ab_b * ac_a;
  // An edge without length leaves the answer to the others.
  if (over_c <= 0 && ab_a >= 0 && ab_b <= 0 && ab_a > ab_b) {
    return from_edge(a, ab, ab_a / (ab_a - ab_b));
  }
  const Real ab_c = dot(ab, cp), ac_c = dot(ac, cp);
  if (ac_c >= 0 && ab_c <= ac_c) {
    return {c, cp};
  }
  const Real over_b = ab_c * ac_a - ab_a * ac_c;
  if (over_b <= 0 && ac_a >= 0 && ac_c <= 0 && ac_a > ac_c) {
    return from_edge(a, ac, ac_a / (ac_a - ac_c));
  }
  const Real over_a = ab_b * ac_c - ab_c * ac_b, to_c = ac_b - ab_b, to_b = ab_c - ac_c;
  if (over_a <= 0 && to_c >= 0 && to_b >= 0 && to_c + to_b > 0) {
    return from_edge(b, c - b, to_c / (to_c + to_b));
  }
  const Real over_all = over_a + over_b + over_c, share = over_all > 0 ? 1 / over_all : 0;
  const Vec3 from = a + (over_b * share) * ab + (over_c * share) * ac, normal = cross(ab, ac);
  const Real square = squared_norm(normal);
  return {from, square > 0 ? (dot(normal, ap) / square) * normal : point - from};
}
[[nodiscard]] inline Vec3 nearest_on(const TriangleCorners& corners, const Vec3& point) {
  return nearest_way(corners, point).from;
}

// How much nearer to a point than a point of the triangle the triangle may come, along the line between both and times
// its length.
[[nodiscard]] inline Real gap_beyond(const TriangleCorners& corners, const Vec3& on_triangle, const Vec3& between) {
  return std::max({dot(between, corners[0] - on_triangle), dot(between, corners[1] - on_triangle),
                   dot(between, corners[2] - on_triangle), Real{0}});
}

}  // namespace abut
