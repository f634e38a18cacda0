// SPDX-License-Identifier: Apache-2.0
// A point and a solid surface: the nearest point of the surface, and which side the point is on. The side is that of
// the winding number: near edges and vertices, normals of faces would tell the wrong one.
export module abut.narrow.parts.solid_point;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.triangle.triangle_point;
import abut.trees.volumes.eight_boxes;
import abut.trees.boxes.two_trees;

export namespace abut {

struct PointOnSurface {
  Vec3 point;
  Real distance;
  std::uint32_t part;
};

// A point as a tree of one item without extent.
struct PointTree {
  Vec3 point;

  [[nodiscard]] inline const Vec3& origin() const [[clang::lifetimebound]] { return point; }
  template <class Visitor>
  inline void visit_children(std::uint32_t, Visitor&& visit) const {
    EightBoxes eight = EightBoxes::empty();
    eight.set_sides(0, {});
    eight.numbers[0] = EightBoxes::item_bit;
    visit(eight);
  }
};

template <Surface A>
[[nodiscard]] PointOnSurface nearest_on_surface(const A& a, const Vec3& point) {
  PointOnSurface best{point, infinity, no_index};
  Real least = infinity;
  const Real noise = noise_of(largest_magnitude(point) + largest_magnitude(a.origin()));
  const auto consider = [&](std::uint32_t part) {
    const Vec3 nearest = nearest_on(a.corners(part), point);
    const Real square = squared_norm(nearest - point);
    if (square < least || (square == least && part < best.part)) {
      least = square;
      best = {nearest, 0, part};
    }
    return std::sqrt(least) + noise;
  };
  const Real reach = consider(a.part_near(point).index());
  visit_two(a, PointTree{point}, GapOrder(a.origin(), point, Pose::identity()), reach,
            [&](std::uint32_t part, std::uint32_t) { return consider(part); });
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
