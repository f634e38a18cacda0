// SPDX-License-Identifier: Apache-2.0
// A point and a solid surface: the nearest point of the surface, and which side the point is on. The side is that of
// the winding number: near edges and vertices, normals of faces would tell the wrong one.
export module abut.narrow.many.solid_point;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.many.triangle_point;

export namespace abut {

struct PointOnSurface {
  Vec3 point;
  Real distance;
  std::uint32_t part;
};

template <Surface A>
[[nodiscard]] PointOnSurface nearest_on_surface(const A& a, const Vec3& point) {
  PointOnSurface best{point, infinity, no_index};
  Real least = infinity;
  const auto consider = [&](const typename A::Part& part) {
    const Vec3 nearest = nearest_on(part.corners(), point);
    const Real square = squared_norm(nearest - point);
    if (square < least || (square == least && part.index() < best.part)) {
      least = square;
      best = {nearest, 0, part.index()};
    }
  };
  consider(a.part_near(point));
  const auto near = [&] { return Aabb{point, point}.inflated((1 + 4 * epsilon) * std::sqrt(least)); };
  Aabb query = near();
  a.visit_parts(query, [&](const typename A::Part& part, std::uint32_t) {
    consider(part);
    query = near();
  });
  best.distance = norm(best.point - point);
  return best;
}

// How far inside a point is; negative outside.
template <Enclosing A>
[[nodiscard]] Real depth_of_point(const A& a, const Vec3& point) {
  const Real distance = nearest_on_surface(a, point).distance;
  return a.contains(point) ? distance : -distance;
}

}  // namespace abut
