// SPDX-License-Identifier: Apache-2.0
// The point of a triangle that is nearest to a given one. The region that the given one lies over decides. Source:
// Ericson, "Real-Time Collision Detection", 2005, section 5.1.5.
export module abut.narrow.many.triangle_point;
import abut.capability;
import abut.core.standard;
import abut.math;

export namespace abut {

[[nodiscard]] inline Vec3 nearest_on(const TriangleCorners& corners, const Vec3& point) {
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a, ac = c - a, ap = point - a, bp = point - b, cp = point - c;
  const Real ab_a = dot(ab, ap), ac_a = dot(ac, ap);
  if (ab_a <= 0 && ac_a <= 0) {
    return a;
  }
  const Real ab_b = dot(ab, bp), ac_b = dot(ac, bp);
  if (ab_b >= 0 && ac_b <= ab_b) {
    return b;
  }
  const Real over_c = ab_a * ac_b - ab_b * ac_a;
  if (over_c <= 0 && ab_a >= 0 && ab_b <= 0) {
    return a + (ab_a / (ab_a - ab_b)) * ab;
  }
  const Real ab_c = dot(ab, cp), ac_c = dot(ac, cp);
  if (ac_c >= 0 && ab_c <= ac_c) {
    return c;
  }
  const Real over_b = ab_c * ac_a - ab_a * ac_c;
  if (over_b <= 0 && ac_a >= 0 && ac_c <= 0) {
    return a + (ac_a / (ac_a - ac_c)) * ac;
  }
  const Real over_a = ab_b * ac_c - ab_c * ac_b, to_c = ac_b - ab_b, to_b = ab_c - ac_c;
  if (over_a <= 0 && to_c >= 0 && to_b >= 0) {
    return b + (to_c / (to_c + to_b)) * (c - b);
  }
  const Real share = 1 / (over_a + over_b + over_c);
  return a + (over_b * share) * ab + (over_c * share) * ac;
}

// How much nearer to a point than a point of the triangle the triangle may come, along the line between both and times
// its length.
[[nodiscard]] inline Real gap_beyond(const TriangleCorners& corners, const Vec3& on_triangle, const Vec3& between) {
  return std::max({dot(between, corners[0] - on_triangle), dot(between, corners[1] - on_triangle),
                   dot(between, corners[2] - on_triangle), Real{0}});
}

}  // namespace abut
