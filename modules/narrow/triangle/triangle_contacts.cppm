// SPDX-License-Identifier: Apache-2.0
// A triangle of a surface against a convex shape, or against a triangle of another surface: their separation, and which
// normals may part them. A one-sided triangle only pushes to its front.
//
// A shape that only touches a triangle does not overlap it: a plane separates the two within rounding, and the shape
// has width beyond that plane. Points that reach under a neighbouring triangle then count no deeper than that. Normals
// of searches are exact only within the bound of the search, so the normal cones of edges and corners are tested with
// that bound.
export module abut.narrow.triangle.triangle_contacts;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.math.four_vec3;
import abut.narrow.apart.box_cores;
import abut.narrow.convex;
import abut.narrow.triangle.triangle_point;
import abut.narrow.triangle.triangle_segment;

export namespace abut {

// Whether a point of the plane of a triangle lies on the triangle, within rounding. All is asked at once, as no branch
// can be guessed.
[[nodiscard]] inline bool is_over(const Triangle& triangle, const Vec3& point) {
  const auto& [a, b, c] = triangle.corners();
  const Columns from = Columns::of(lanes_of(a), lanes_of(b), lanes_of(c), lanes_of(c)),
                to = Columns::of(lanes_of(b), lanes_of(c), lanes_of(a), lanes_of(a)), at = Columns::all(point);
  const Real size = std::fmax(largest(largest_magnitude(from)), largest_magnitude(point)),
             reach = 2 * rounding_of(size);
  // Beyond a sharp corner points are outside of its edges by rounding only.
  const auto is_beside = [&](Lanes corners, Real coordinate) {
    const Real low = -largest(-corners) - reach, high = largest(corners) + reach;
    return ((coordinate < low) | (coordinate > high)) != 0;
  };
  const Columns edges = to - from, n = Columns::all(cross(b - a, c - a));
  const Lanes slack = reach * __builtin_elementwise_sqrt(dot(n, n) * dot(edges, edges));
  const LaneNumbers is_outside = dot(n, cross(edges, at - from)) < -slack;
  const bool x = is_beside(from.x, point.x), y = is_beside(from.y, point.y), z = is_beside(from.z, point.z);
  return (x | y | z) == 0 && bits_of(is_outside) == 0;
}

// A point or a segment beside a triangle. False where rounding leaves the closest points in doubt.
template <Convex B>
  requires PointCored<B> || SegmentCored<B>
[[nodiscard]] bool separate_beside(const Triangle& triangle, const B& b, const Pose& ab, Real size, Real error,
                                   CoreSeparation& core) {
  const auto near_points = [&]() -> NearPoints {
    if constexpr (PointCored<B>) {
      const Vec3 point = placed_centre(b, ab);
      const auto [from, way] = nearest_way(triangle.corners(), point);
      return {lanes_of(from),
              lanes_of(point),
              lanes_of(way),
              squared_norm(way),
              gap_beyond(triangle.corners(), from, way),
              1};
    } else {
      return near_points_of_segment(triangle.corners(), ab.position, ab.rotation.z, b.half().z);
    }
  };
  const NearPoints near = near_points();
  if (!is_settled(near, size, error)) {
    return false;
  }
  core = separation_of(near, size);
  return true;
}

// A separation that may lack its points so far: contacts under the normal of a face have points of their own.
struct TriangleSeparation {
  CoreSeparation core;
  bool lacks_points;
};

// The separation without a search for closest points, where that is quick: of points and segments, and of other
// polytopes where only an overlap counts.
template <Convex B>
[[nodiscard]] bool separate_at_once(const Triangle& triangle, const B& b, const Pose& ab, const QuerySettings& settings,
                                    Real limit, TriangleSeparation& found) {
  if (!takes_closed_forms(settings.algorithm)) {
    return false;
  }
  CoreSeparation& core = found.core;
  const Real size = core_size(triangle, b, ab);
  if constexpr (PointCored<B> || SegmentCored<B>) {
    if (separate_beside(triangle, b, ab, size, error_of(triangle, b, size, settings), core)) {
      core.beyond = core.lower > limit;
      return true;
    }
    if constexpr (SegmentCored<B>) {
      // A segment that pierces the triangle.
      return separate_by_axes(triangle, b, ab, size, core) && core.distance < -noise_of(size);
    }
  } else if constexpr (FewFaced<B> || Faceted<B>) {
    const Real noise = noise_of(size);
    const auto is_separated = [&] {
      if constexpr (Faceted<B>) {
        return separate_by_hull_sat(triangle, b, ab, size, core, noise);
      } else if constexpr (has_triangle_sat<Triangle, B>) {
        if (const auto best = triangle_sat(triangle, b, ab, noise, noise)) {
          core = separation_of(*best, size);
          found.lacks_points = true;
          return true;
        }
        return separate_by_axes(triangle, b, ab, size, core);
      } else {
        return separate_by_axes(triangle, b, ab, size, core);
      }
    };
    if (limit <= noise && is_separated()) {
      core.beyond = core.distance > noise;
      core.overlap = !core.beyond;
      return core.beyond || core.distance < -noise;
    }
  }
  return false;
}

template <Convex B>
[[nodiscard]] TriangleSeparation begin_separation(const Triangle& triangle, const B& b, const Pose& ab,
                                                  const QuerySettings& settings, Real limit) {
  TriangleSeparation found{};
  if (!separate_at_once(triangle, b, ab, settings, limit, found)) {
    found = {separate_cores(triangle, b, ab, settings, limit), false};
  }
  return found;
}

// The separation of a triangle and a core. Axes that nearly agree may leave points that are not on the
// triangle, or not across each other. Such points stay open: the outermost features under the normal tell better ones.
template <Convex B>
[[nodiscard]] CoreSeparation completed(const Triangle& triangle, const B& b, const Pose& ab,
                                       const TriangleSeparation& found) {
  CoreSeparation core = found.core;
  // Curved surfaces have no features that would tell better ones than the search did.
  if (!core.overlap || Curved<B>) {
    return core;
  }
  const Real size = core_size(triangle, b, ab), noise = noise_of(size);
  if (found.lacks_points) {
    complete(triangle, b, ab, size, core);
  }
  if (!core.points_open) {
    const Vec3 aside = core.point_b - core.point_a - core.distance * core.normal;
    core.points_open = largest_magnitude(aside) > noise ||
                       !triangle.box().inflated(noise).overlaps({core.point_a, core.point_a}) ||
                       (triangle.has_area() && !is_over(triangle, core.point_a));
  }
  return core;
}
template <Convex B>
[[nodiscard]] CoreSeparation separate_from_triangle(const Triangle& triangle, const B& b, const Pose& ab,
                                                    const QuerySettings& settings, Real limit) {
  return completed(triangle, b, ab, begin_separation(triangle, b, ab, settings, limit));
}

// Between the normal of a front and a way that it allows, within rounding: normals are those of the sides, or lie in
// their planes, where shapes stand straight to each other.
inline constexpr Real least_cosine_of_front = -1e-12;

// Which ways a pair may be parted: the front of either side, where that side is a one-sided triangle.
template <Convex B>
class Fronts {
 public:
  Fronts() = default;
  Fronts(const Triangle& triangle, const B& b, const Pose& ab)
      : a_(triangle.is_one_sided() ? triangle.normal() : Vec3{0, 0, 0}), b_{0, 0, 0} {
    if constexpr (std::same_as<B, Triangle>) {
      b_ = b.is_one_sided() ? -(ab.rotation * b.normal()) : Vec3{0, 0, 0};
    }
  }
  [[nodiscard]] bool allows(const Vec3& normal) const {
    return dot(normal, a_) >= least_cosine_of_front && dot(normal, b_) >= least_cosine_of_front;
  }

 private:
  Vec3 a_, b_;
};

// Of a core that is beside or behind a triangle, only what its rounding has sunk in from the front counts.
template <Convex B>
[[nodiscard]] bool counts_from_behind(const Triangle& triangle, const B& b, const Pose& ab,
                                      const CoreSeparation& core) {
  return core.overlap ||
         (core.distance < b.radius() && dot(triangle.normal(), placed_centre(b, ab) - triangle.corners()[0]) >= 0);
}
// A segment may go through an edge of a surface. So that neither triangle beside the edge is missed by rounding, what
// is this near to it is met as well.
template <Convex B>
[[nodiscard]] Real edge_slack(const B& b, const Pose& ab) {
  if constexpr (SegmentCored<B>) {
    return b.radius() > 0 ? 0 : noise_of(largest_magnitude(ab.position) + b.extent());
  } else {
    return 0;
  }
}
// Cores that are no further apart, or overlap no more, may only touch. A search on curved cores has a bound.
template <Convex B>
[[nodiscard]] Real touching_within(Real size, const QuerySettings& settings) {
  return Curved<B> ? bound_of_curves(settings) * size : noise_of(size);
}

// The separation along the normal of a face.
template <Convex B>
[[nodiscard]] CoreSeparation along_face(const Triangle& triangle, const B& b, const Pose& ab,
                                        const CoreSeparation& core, const Vec3& normal) {
  CoreSeparation turned = core;
  turned.normal = normal;
  turned.points_open = false;
  turned.features = {};  // those of the search belong to its own normal
  turned.point_b = placed_support(b, place(b, ab), -normal).point;
  turned.distance = turned.lower = turned.upper = dot(normal, turned.point_b - triangle.corners()[0]);
  turned.point_a = turned.point_b - turned.distance * normal;
  return turned;
}

// The same with the face on side b.
[[nodiscard]] inline CoreSeparation along_other_face(const Triangle& triangle, const Triangle& b, const Pose& ab,
                                                     const CoreSeparation& core, const Vec3& normal) {
  CoreSeparation turned = core;
  turned.normal = normal;
  turned.points_open = false;
  turned.features = {};
  turned.point_a = triangle.support(normal).point;
  turned.distance = turned.lower = turned.upper = dot(normal, ab * b.corners()[0] - turned.point_a);
  turned.point_b = turned.point_a + turned.distance * normal;
  return turned;
}

}  // namespace abut
