// SPDX-License-Identifier: Apache-2.0
// Whether a surface goes on past a contact. The triangles of one surface, or of two, may meet without a vertex in
// common: at a crack, a T-junction or a seam. There a border is no border, and a contact whose normal a neighbour rises
// over is none of the whole.
//
// Neighbours are found by position, since triangles at a crack share no vertex index. A contact at an edge or a corner
// searches the tree for triangles beside its point. Other surfaces are searched in the same way after all pairs are
// done (pairs/composites/seams, detect/seams).
export module abut.narrow.ways.continuation;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.triangle.triangle_point;

export namespace abut {

// Triangles meet that are apart by no more than this share of the smaller one of a triangle and of what touches it.
inline constexpr Real crack_share = 1e-4;

[[nodiscard]] inline Real reach_of_cracks(const TriangleCorners& corners, Real size) {
  const Aabb box = box_around(corners);
  return crack_share * std::min(size, largest_magnitude(box.high - box.low));
}

// Whether a triangle holds a point, within `reach`.
[[nodiscard]] inline bool holds(const TriangleCorners& corners, const Vec3& point, Real reach) {
  return squared_norm(nearest_on(corners, point) - point) <= reach * reach;
}

// How far a triangle rises over the plane through a point across a normal.
[[nodiscard]] inline Real rise_of(const TriangleCorners& corners, const Vec3& point, const Vec3& normal) {
  return std::max(std::max(dot(normal, corners[0] - point), dot(normal, corners[1] - point)),
                  dot(normal, corners[2] - point));
}

using LookAtCorners = std::function<bool(const TriangleCorners&, Real)>;

// Compiled once for each kind of surface.
template <class S>
[[nodiscard]] [[gnu::noinline]] bool any_corners_around(const S& surface, const Vec3& point, Real size,
                                                        const LookAtCorners& look) {
  const Real noise = noise_of(largest_magnitude(point));
  Aabb near = Aabb{point, point}.inflated(crack_share * size + noise);
  bool is_found = false;
  // No triangle is visited: corners tell all.
  const auto ask = [&](const TriangleCorners& corners) {
    const Real reach = reach_of_cracks(corners, size) + noise;
    is_found = is_found || (holds(corners, point, reach) && look(corners, reach));
    return false;
  };
  surface.visit_parts(near, ask, AcceptsAnyPart{});
  return is_found;
}

// Calls look(corners, reach) for the triangles of a surface that hold a point of it, within `reach`, until one answers
// true. `size`: of what touches the surface.
template <Surface S, class Look>
[[nodiscard]] bool any_around(const S& surface, const Vec3& point, Real size, Look&& look) {
  // What holds one reference is passed on without memory of its own.
  return any_corners_around(surface, point, size,
                            [&look](const TriangleCorners& corners, Real reach) { return look(corners, reach); });
}

// Whether a surface goes on from a point and rises over the plane across a normal, which leads out of it there.
template <Surface S>
[[nodiscard]] bool goes_on(const S& surface, const Vec3& point, const Vec3& normal, Real size) {
  return any_around(surface, point, size, [&](const TriangleCorners& corners, Real reach) {
    return rise_of(corners, point, normal) > 2 * reach;
  });
}

// Whether a normal is that of a face that holds a point.
template <Surface S>
[[nodiscard]] bool has_face(const S& surface, const Vec3& point, const Vec3& normal, Real size) {
  constexpr Real same_square = 1e-18;  // of the sine of the angle between two normals
  return any_around(surface, point, size, [&](const TriangleCorners& corners, Real) {
    const Vec3 n = cross(corners[1] - corners[0], corners[2] - corners[0]), aside = cross(n, normal);
    return squared_norm(aside) <= same_square * squared_norm(n);
  });
}

}  // namespace abut
