// SPDX-License-Identifier: Apache-2.0
// Which of four triangles may be nearer to a core than a limit, told by a few axes that cost little. Most triangles
// that a tree of boxes finds near a shape are left out so.
export module abut.narrow.triangle.quick_axes;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.math.tolerance;
import abut.narrow.apart.segment_cores;
import abut.narrow.triangle.four_nearest;

export namespace abut {

// Sums of the magnitudes of the coordinates stand for lengths: they are no shorter, so that no triangle is left out
// wrongly.
[[nodiscard]] [[gnu::always_inline]] inline Lanes length_bound(const Columns& a) {
  return absolute(a.x) + absolute(a.y) + absolute(a.z);
}

// A bit for each triangle that is not left out. One that is no number leaves none out.
[[nodiscard]] [[gnu::always_inline]] inline std::uint64_t others_than(LaneNumbers left_out) {
  return ~bits_of(left_out) & 15u;
}

// The box around a core, along the axes of the core, and all separating axes of it and a triangle. Source:
// Gottschalk, Lin, Manocha, "OBBTree", 1996. All is in the frame of the box.
template <Convex B>
class QuickAxes {
 public:
  QuickAxes(const B& b, const Pose& ab) : rotation_(ab.rotation), position_(ab.position) {
    const Aabb box = b.aabb(Pose::identity());
    half_ = 0.5 * (box.high - box.low) - Vec3{b.radius(), b.radius(), b.radius()};
    centre_ = box.centre();
    noise_ = noise_of(largest_magnitude(ab.position));
  }

  // A bit for each triangle that may be nearer than a limit.
  [[nodiscard]] std::uint64_t near(const FourTriangles& triangles, Real limit) const {
    const Columns a = local(triangles.a, centre_), b = local(triangles.b, centre_), c = local(triangles.c, centre_);
    const Span x(a.x, b.x, c.x, half_.x), y(a.y, b.y, c.y, half_.y), z(a.z, b.z, c.z, half_.z);
    const Lanes size = maximum(maximum(x.size, y.size), z.size);
    const Lanes reach = all_lanes(std::fmax(limit, 0) + noise_) + noise_of(size);
    LaneNumbers beyond = maximum(maximum(x.gap, y.gap), z.gap) > reach;
    if (others_than(beyond) == 0) {
      return 0;
    }
    const Columns ab = b - a, bc = c - b, ca = a - c, normal = cross(ab, ca);
    // The normal of a sliver is rounding, and so is how far anything lies along it.
    const Lanes rounding = noise_of(size) * length_bound(ab) * length_bound(ca);
    const Lanes of_box = absolute(normal.x) * half_.x + absolute(normal.y) * half_.y + absolute(normal.z) * half_.z;
    beyond |= absolute(dot(normal, a)) - of_box > reach * length_bound(normal) + rounding;
    beyond |=
        are_beyond_across(ab, a, c, reach) | are_beyond_across(bc, b, a, reach) | are_beyond_across(ca, c, b, reach);
    return others_than(beyond);
  }

 private:
  // How far triangles lie beside the box along one of its axes, and their largest coordinate with the box.
  struct Span {
    Lanes gap, size;

    [[gnu::always_inline]] inline Span(Lanes a, Lanes b, Lanes c, Real half) {
      const Lanes low = minimum(minimum(a, b), c), high = maximum(maximum(a, b), c);
      gap = maximum(low, -high) - half;
      size = maximum(absolute(low), absolute(high)) + half;
    }
  };
  [[nodiscard]] [[gnu::always_inline]] inline Columns local(const Columns& corner, const Vec3& centre) const {
    const Columns d = corner - Columns::all(position_);
    return Columns{dot(Columns::all(rotation_.x), d), dot(Columns::all(rotation_.y), d),
                   dot(Columns::all(rotation_.z), d)} -
           Columns::all(centre);
  }
  // Across an edge and each axis of the box. `opposite`: the corner that the edge does not have.
  [[nodiscard]] [[gnu::always_inline]] inline LaneNumbers are_beyond_across(const Columns& edge, const Columns& corner,
                                                                            const Columns& opposite,
                                                                            Lanes reach) const {
    const Columns one = cross(edge, corner), other = cross(edge, opposite);
    const Lanes x = absolute(edge.x), y = absolute(edge.y), z = absolute(edge.z), least = reach * (x + y + z);
    const auto beyond = [&](Lanes p, Lanes q, Lanes of_box) {
      return maximum(minimum(p, q), -maximum(p, q)) - of_box > least;
    };
    return beyond(one.x, other.x, y * half_.z + z * half_.y) | beyond(one.y, other.y, z * half_.x + x * half_.z) |
           beyond(one.z, other.z, x * half_.y + y * half_.x);
  }

  Rotation rotation_;  // of the core
  Vec3 position_, half_, centre_;
  Real noise_;
};

// Two triangles: the planes of both.
template <>
class QuickAxes<Triangle> {
 public:
  QuickAxes(const Triangle& b, const Pose& ab)
      : a_(Columns::all(ab * b.corners()[0])),
        b_(Columns::all(ab * b.corners()[1])),
        c_(Columns::all(ab * b.corners()[2])) {}

  [[nodiscard]] std::uint64_t near(const FourTriangles& triangles, Real limit) const {
    return near(triangles, {a_, b_, c_, {}}, limit);
  }
  // The same of four pairs of triangles.
  [[nodiscard]] [[gnu::always_inline]] static inline std::uint64_t near(const FourTriangles& triangles,
                                                                        const FourTriangles& placed, Real limit) {
    const Lanes size = maximum(triangles.size(), placed.size());
    const Lanes reach = all_lanes(std::fmax(limit, 0)) + noise_of(size);
    return others_than(are_beside(triangles, placed, reach, size) | are_beside(placed, triangles, reach, size));
  }

 private:
  // Whether all corners of the second triangle are on one side of the plane of the first one.
  [[nodiscard]] [[gnu::always_inline]] static inline LaneNumbers are_beside(const FourTriangles& first,
                                                                            const FourTriangles& second, Lanes reach,
                                                                            Lanes size) {
    const Columns one = first.b - first.a, other = first.c - first.a, n = cross(one, other);
    const Lanes a = dot(n, second.a - first.a), b = dot(n, second.b - first.a), c = dot(n, second.c - first.a);
    const Lanes least = reach * length_bound(n) + noise_of(size) * length_bound(one) * length_bound(other);
    return (minimum(minimum(a, b), c) > least) | (maximum(maximum(a, b), c) < -least);
  }

  Columns a_, b_, c_;
};

// A point: the line to the nearest point of the triangle.
template <Convex B>
  requires PointCored<B>
class QuickAxes<B> {
 public:
  QuickAxes(const B& b, const Pose& ab) : point_(placed_centre(b, ab)) {}

  [[nodiscard]] std::uint64_t near(const FourTriangles& triangles, Real limit) const {
    return near(triangles, nearest_of(triangles), limit);
  }
  [[nodiscard]] [[gnu::always_inline]] inline FourNearest nearest_of(const FourTriangles& triangles) const {
    return {triangles, point_};
  }
  [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t near(const FourTriangles& triangles,
                                                                 const FourNearest& nearest, Real limit) const {
    const Lanes size = maximum(largest_magnitude(triangles.a), all_lanes(largest_magnitude(point_)));
    const Lanes reach = all_lanes(std::fmax(limit, 0)) + noise_of(size);
    // Along the line between both no point of the triangle comes nearer than this share of it.
    const Lanes proven = nearest.square - nearest.gap_beyond(triangles);
    return others_than((proven > all_lanes(0)) & (proven * proven > reach * reach * nearest.square));
  }

 private:
  Vec3 point_;
};

}  // namespace abut
