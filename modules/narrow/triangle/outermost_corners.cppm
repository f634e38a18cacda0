// SPDX-License-Identifier: Apache-2.0
// What of a triangle lies furthest along a direction.
export module abut.narrow.triangle.outermost_corners;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;

export namespace abut {

// The corners of a triangle that lie furthest along a direction, by bit: one of a vertex, two of an edge, three of the
// face.
[[nodiscard]] inline unsigned outermost_corners(const TriangleCorners& corners, const Vec3& direction, Real noise) {
  const Real b = dot(direction, corners[1] - corners[0]), c = dot(direction, corners[2] - corners[0]);
  const Real outermost = std::max(std::max(b, c), Real{0}) - noise;
  return (0 >= outermost ? 1u : 0u) | (b >= outermost ? 2u : 0u) | (c >= outermost ? 4u : 0u);
}

// Whether a direction is the normal of a face or its opposite, within rounding.
[[nodiscard]] inline bool is_along(const Vec3& direction, const Vec3& normal) {
  return std::fabs(dot(direction, normal)) > one_direction;
}

}  // namespace abut
