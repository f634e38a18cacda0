// SPDX-License-Identifier: Apache-2.0
// Whether the way out of a triangle is one out of its surface: only where no neighbour reaches further, whether that
// shares a corner with the triangle or not.
export module abut.narrow.many.way_out;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.many.continuation;

export namespace abut {

// The corners of a triangle that lie furthest along a direction, by bit: one of a vertex, two of an edge, three of the
// face.
[[nodiscard]] inline unsigned outermost_corners(const TriangleCorners& corners, const Vec3& direction, Real noise) {
  const Real b = dot(direction, corners[1] - corners[0]), c = dot(direction, corners[2] - corners[0]);
  const Real outermost = std::max(std::max(b, c), Real{0}) - noise;
  return (0 >= outermost ? 1u : 0u) | (b >= outermost ? 2u : 0u) | (c >= outermost ? 4u : 0u);
}

// The same of four triangles, along a direction each: a bit for each of them, corner by corner.
[[nodiscard]] [[gnu::always_inline]] inline std::array<std::uint64_t, 3> outermost_corners(
    const FourTriangles& triangles, const Columns& directions, Lanes noise) {
  const Lanes b = dot(directions, triangles.b - triangles.a), c = dot(directions, triangles.c - triangles.a),
              outermost = maximum(maximum(b, c), all_lanes(0)) - noise;
  return {bits_of(all_lanes(0) >= outermost), bits_of(b >= outermost), bits_of(c >= outermost)};
}

// Whether a direction is the normal of a face or its opposite, within rounding.
[[nodiscard]] inline bool is_along(const Vec3& direction, const Vec3& normal) {
  return std::fabs(dot(direction, normal)) > 1 - 1e-12;
}

// Whether the way out of a triangle along a direction is one out of its surface. Otherwise a neighbour reaches further.
template <Surface S>
[[nodiscard]] bool leads_out(const S& surface, const Triangle& triangle, const Vec3& direction, Real noise) {
  if (!triangle.has_area() || is_along(direction, triangle.normal())) {
    return true;
  }
  const unsigned corners = outermost_corners(triangle.corners(), direction, noise);
  return corners == 7 || surface.is_crest(triangle.index(), corners, direction, noise);
}

// The same with the neighbours beside a point of the triangle that share no corner with it. `size`: of what touches the
// surface.
template <Surface S>
[[nodiscard]] bool leads_out_of_all(const S& surface, const Triangle& triangle, const Vec3& point,
                                    const Vec3& direction, Real noise, Real size) {
  if (!leads_out(surface, triangle, direction, noise)) {
    return false;
  }
  if constexpr (Terrain<S>) {
    return true;  // its triangles share all corners
  } else {
    return !triangle.has_area() || is_along(direction, triangle.normal()) ||
           !goes_on(surface, point, direction, std::min(triangle.extent(), size));
  }
}

}  // namespace abut
