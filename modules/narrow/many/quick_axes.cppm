// SPDX-License-Identifier: Apache-2.0
// Whether a triangle is further from a core than a limit, told by a few axes that cost little. Most triangles that a
// tree of boxes finds near a shape are left out so.
export module abut.narrow.many.quick_axes;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.apart.segment_cores;
import abut.narrow.many.triangle_point;

export namespace abut {

// Sums of the magnitudes of the coordinates stand for lengths: they are no shorter, so that no triangle is left out
// wrongly.
[[nodiscard]] [[gnu::always_inline]] inline Real length_bound(Lanes a) { return sum(absolute(a)); }
[[nodiscard]] [[gnu::always_inline]] inline Real length_bound(const Vec3& a) {
  return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
}

// The normal of a sliver is rounding, and so is how far anything lies along it. `size`: of the coordinates.
[[nodiscard]] [[gnu::always_inline]] inline Real rounding_of_normal(Real one_side, Real other_side, Real size) {
  return noise_of(one_side * other_side * size);
}

// The box around a core, along the axes of the core, and all separating axes of it and a triangle. Source:
// Gottschalk, Lin, Manocha, "OBBTree", 1996. All is in the frame of the box, an axis of the box per lane.
template <Convex B>
class QuickAxes {
 public:
  QuickAxes(const B& b, const Pose& ab) : rows_(LaneMatrix::rows_of(ab.rotation)), position_(ab.position) {
    const Aabb box = b.aabb(Pose::identity());
    half_ = lanes_of(0.5 * (box.high - box.low)) - Lanes{b.radius(), b.radius(), b.radius(), 0};
    centre_ = lanes_of(box.centre());
    noise_ = noise_of(largest_magnitude(ab.position));
  }

  [[nodiscard]] bool are_beyond(const TriangleCorners& corners, Real limit) const {
    const Lanes a = local(corners[0]), b = local(corners[1]), c = local(corners[2]);
    const Lanes low = minimum(minimum(a, b), c), high = maximum(maximum(a, b), c);
    const Real size = largest(maximum(absolute(low), absolute(high)) + half_);
    const Real reach = std::fmax(limit, 0) + noise_ + noise_of(size);
    if (bits_of(maximum(low, -high) - half_ > all_lanes(reach)) != 0) {
      return true;
    }
    const Lanes normal = cross(b - a, c - a);
    const Real rounding = rounding_of_normal(length_bound(b - a), length_bound(c - a), size);
    return std::fabs(dot(normal, a)) - dot(absolute(normal), half_) > reach * length_bound(normal) + rounding ||
           are_beyond_across(b - a, a, c, reach) || are_beyond_across(c - b, b, a, reach) ||
           are_beyond_across(a - c, c, b, reach);
  }

 private:
  [[nodiscard]] [[gnu::always_inline]] inline Lanes local(const Vec3& corner) const {
    return rows_ * (corner - position_) - centre_;
  }
  // Across an edge and each axis of the box. `opposite`: the corner that the edge does not have.
  [[nodiscard]] [[gnu::always_inline]] inline bool are_beyond_across(Lanes edge, Lanes corner, Lanes opposite,
                                                                     Real reach) const {
    const Lanes one = cross(edge, corner), other = cross(edge, opposite), lengths = absolute(edge);
    const Lanes of_box = lengths.yzxw * half_.zxyw + lengths.zxyw * half_.yzxw;
    const Lanes apart = maximum(minimum(one, other), -maximum(one, other)) - of_box;
    return bits_of(apart > all_lanes(reach * length_bound(edge))) != 0;
  }

  LaneMatrix rows_;  // of the rotation of the core
  Vec3 position_;
  Lanes half_, centre_;
  Real noise_;
};

// Two triangles: the planes of both.
template <>
class QuickAxes<Triangle> {
 public:
  QuickAxes(const Triangle& b, const Pose& ab)
      : corners_{ab * b.corners()[0], ab * b.corners()[1], ab * b.corners()[2]} {}

  [[nodiscard]] bool are_beyond(const TriangleCorners& corners, Real limit) const {
    return are_beside(corners, corners_, limit) || are_beside(corners_, corners, limit);
  }

 private:
  // Whether all corners of the second triangle are on one side of the plane of the first one.
  [[nodiscard]] static inline bool are_beside(const TriangleCorners& first, const TriangleCorners& second, Real limit) {
    const Vec3 one = first[1] - first[0], other = first[2] - first[0], n = cross(one, other);
    const Real a = dot(n, second[0] - first[0]), b = dot(n, second[1] - first[0]), c = dot(n, second[2] - first[0]);
    Real size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      size = std::fmax(size, std::fmax(largest_magnitude(first[i]), largest_magnitude(second[i])));
    }
    const Real reach = (std::fmax(limit, 0) + noise_of(size)) * length_bound(n) +
                       rounding_of_normal(length_bound(one), length_bound(other), size);
    return std::min(std::min(a, b), c) > reach || std::max(std::max(a, b), c) < -reach;
  }

  TriangleCorners corners_;
};

// A point: the line to the nearest point of the triangle.
template <Convex B>
  requires PointCored<B>
class QuickAxes<B> {
 public:
  QuickAxes(const B& b, const Pose& ab) : point_(placed_centre(b, ab)) {}

  [[nodiscard]] bool are_beyond(const TriangleCorners& corners, Real limit) const {
    const Real size = largest_magnitude(maximum(absolute(point_), absolute(corners[0])));
    const Real reach = std::fmax(limit, 0) + noise_of(size);
    const Vec3 nearest = nearest_on(corners, point_), between = point_ - nearest;
    // Along the line between both no point of the triangle comes nearer than this share of it.
    const Real square = squared_norm(between), proven = square - gap_beyond(corners, nearest, between);
    return proven > 0 && proven * proven > reach * reach * square;
  }

 private:
  Vec3 point_;
};

}  // namespace abut
