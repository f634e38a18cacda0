// SPDX-License-Identifier: Apache-2.0
// Fronts that stand in a way: one-sided triangles of a surface that face what moves.
export module abut.narrow.many.fronts_ahead;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;

export namespace abut {

// Whether a triangle near a box has a front against a direction.
template <Surface S>
[[nodiscard]] bool has_front_against(const S& surface, Aabb box, const Vec3& direction) {
  if (!surface.has_fronts()) {
    return false;
  }
  // Slivers, whose normals are rounding, and what is nearly along the direction, are asked in full.
  const Columns along = Columns::all(direction);
  const auto may_be_against = [&](const FourTriangles& triangles) {
    const Columns ab = triangles.b - triangles.a, ac = triangles.c - triangles.a, normal = cross(ab, ac);
    return bits_of(dot(along, normal) <= 1e-6 * (dot(ab, ab) + dot(ac, ac)));
  };
  bool is_found = false;
  surface.visit_parts(box, InFours{may_be_against}, [&](const Triangle& triangle, std::uint32_t) {
    if (triangle.is_one_sided() && dot(triangle.normal(), direction) < -1e-12) {
      is_found = true;
      box = Aabb::empty();  // no other is asked for
    }
  });
  return is_found;
}

}  // namespace abut
