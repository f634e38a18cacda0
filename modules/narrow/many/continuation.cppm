// SPDX-License-Identifier: Apache-2.0
// Whether a surface goes on past a contact. The triangles of one surface, or of two, may meet without a vertex in
// common: at a crack, a T-junction or a seam. There a border is no border, and a contact whose normal a neighbour rises
// over is none of the whole.
export module abut.narrow.many.continuation;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.many.triangle_point;

export namespace abut {

// Triangles meet that are apart by no more than this share of the smaller one of a triangle and of what touches it.
inline constexpr Real crack_share = 1e-4;

// Whether a triangle that holds a point, within `reach`, rises over the plane through the point across a normal.
[[nodiscard]] inline bool rises_over(const TriangleCorners& corners, const Vec3& point, const Vec3& normal,
                                     Real reach) {
  const Vec3 away = nearest_on(corners, point) - point;
  if (squared_norm(away) > reach * reach) {
    return false;
  }
  const Real highest = std::max(std::max(dot(normal, corners[0] - point), dot(normal, corners[1] - point)),
                                dot(normal, corners[2] - point));
  return highest > 2 * reach;
}

// Whether any triangle of a surface does. `normal` leads out of the surface.
template <Surface S>
[[nodiscard]] bool goes_on(const S& surface, const Vec3& point, const Vec3& normal, Real reach) {
  const Real within = reach + noise_of(largest_magnitude(point));
  Aabb near{point, point};
  near = near.inflated(within);
  bool is_rising = false;
  // No triangle is visited: all is told by corners.
  const auto look = [&](const TriangleCorners& corners) {
    is_rising = is_rising || rises_over(corners, point, normal, within);
    return false;
  };
  surface.visit_parts(near, look, [](const typename S::Part&, std::uint32_t) {});
  return is_rising;
}

}  // namespace abut
