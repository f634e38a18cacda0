// SPDX-License-Identifier: Apache-2.0
// How far a convex shape travels along a direction until it overlaps a triangle no more. Both are convex: they overlap
// on one stretch of the way, which ends there.
export module abut.narrow.ways.leaving;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.convex;
import abut.narrow.fan.sat;
import abut.narrow.ways.leaving_portal;
import abut.narrow.triangle.triangle_contacts;

export namespace abut {

// Where a convex b begins along a direction.
template <Convex B>
[[nodiscard]] Real lowest_point_along(const B& b, const Pose& ab, const Vec3& direction) {
  return dot(direction, placed_support(b, place(b, ab), -direction).point) - b.radius();
}

// The end of the stretch, and the normal of the touch there, from the triangle. Of shapes that never overlap on the way
// the end is -infinity.
struct Leaving {
  Real length;
  Vec3 normal;
};
inline constexpr Leaving never_met{-infinity, {0, 0, 0}};

// What is known of the end, and what is asked of it.
struct LeavingBounds {
  Real bound = infinity;   // no less than the end
  Real inside = 0;         // where both overlap
  Real least = -infinity;  // an end before it need not be exact, if it is told to be before it
  Real enough = infinity;  // the same beyond it
};

// Cores whose separating axes are few.
template <class B>
inline constexpr bool leaves_by_axes = FewFaced<B> && !PointCored<B> && !SegmentCored<B>;

// The stretch ends where the first axis parts both.
template <Convex B>
  requires leaves_by_axes<B>
[[nodiscard]] Leaving leave_by_axes(const Triangle& triangle, const B& b, const Pose& ab, const Vec3& direction) {
  constexpr Real along_share = 1e-13;  // of cosines that are rounding
  const auto placement = place(b, ab);
  const auto& [p, q, r] = triangle.corners();
  Real enter = -infinity, leave = infinity;
  Vec3 normal{0, 0, 0};
  bool is_apart = false;
  const auto consider = [&](const Vec3& axis) {
    const Real of_p = dot(axis, p), of_q = dot(axis, q), of_r = dot(axis, r);
    const Real high = std::max(std::max(of_p, of_q), of_r), low = std::min(std::min(of_p, of_q), of_r);
    const Real low_of_b = dot(axis, placed_support(b, placement, -axis).point),
               high_of_b = dot(axis, placed_support(b, placement, axis).point);
    const Real speed = dot(axis, direction), ahead = high - low_of_b, behind = low - high_of_b;
    if (speed * speed <= along_share * along_share * squared_norm(axis)) {
      is_apart = is_apart || ahead <= 0 || behind >= 0;
      return;
    }
    const Real end = (speed > 0 ? ahead : behind) / speed, begin = (speed > 0 ? behind : ahead) / speed;
    enter = std::max(enter, begin);
    if (end < leave) {
      leave = end;
      normal = speed > 0 ? axis : -axis;
    }
  };
  if (triangle.has_area()) {
    consider(triangle.normal());
  }
  for (const Vec3& face : b.face_normals()) {
    if (squared_norm(face) > 0) {
      consider(ab.rotation * face);
    }
  }
  for (const Vec3& edge : triangle.edge_directions()) {
    for (const Vec3& other : b.edge_directions()) {
      const Vec3 placed = ab.rotation * other, axis = cross(edge, placed);
      const Real square = squared_norm(axis);
      if (square > parallel_square * squared_norm(edge) * squared_norm(placed) && square > 0) {
        consider(unit_across_edges(edge, placed, axis, square));
      }
    }
  }
  return is_apart || !(leave > enter) ? never_met : Leaving{leave, normal};
}

// Where the point of b that is last to pass the plane of the triangle does so over the triangle, both touch.
template <Convex B>
[[nodiscard]] std::optional<Leaving> leave_through_face(const Triangle& triangle, const B& b, const Pose& ab,
                                                        const Vec3& direction, Real bound, Real tolerance) {
  const Real slope = dot(triangle.normal(), direction);
  if (!(std::fabs(slope) > least_plane_slope)) {
    return std::nullopt;
  }
  const Vec3 normal = slope > 0 ? triangle.normal() : -triangle.normal();
  const Vec3 last = placed_support(b, place(b, ab), -normal).point - b.radius() * normal;
  const Real length = dot(normal, triangle.corners()[0] - last) / std::fabs(slope);
  return length <= bound + tolerance && is_over(triangle, last + length * direction)
             ? std::optional(Leaving{length, normal})
             : std::nullopt;
}

// The separation of cores that are apart or touch.
template <Convex B>
[[nodiscard]] CoreSeparation separate_outside(const Triangle& triangle, const B& b, const Pose& ab,
                                              const QuerySettings& settings) {
  if constexpr (PointCored<B> || SegmentCored<B>) {
    const Real size = core_size(triangle, b, ab);
    CoreSeparation core{};
    if (takes_closed_forms(settings.algorithm) &&
        separate_beside(triangle, b, ab, size, error_of(triangle, b, size, settings), core)) {
      return core;
    }
  }
  return separate_cores(triangle, b, ab, settings, infinity);
}

// From a length that is no less than the end on: the distance is a convex function of the way, so that Newton's method
// from the far side never passes its zero. Nothing nearer than `least` is looked for.
template <Convex B>
[[nodiscard]] Leaving leave_by_search(const Triangle& triangle, const B& b, const Pose& ab, const Vec3& direction,
                                      const QuerySettings& settings, Real bound, Real least, Real tolerance) {
  constexpr int most_steps = 40;
  constexpr Real least_slope = 1e-12;
  Leaving found{bound, direction};
  for (int step = 0; step < most_steps && found.length > least; ++step) {
    const Pose at{ab.rotation, ab.position + found.length * direction};
    const CoreSeparation core = separate_outside(triangle, b, at, settings);
    const Real gap = core.distance - b.radius();
    // The normal of cores that touch is rounding: the one before is as good.
    if (b.radius() > 0 || gap > tolerance) {
      found.normal = core.normal;
    }
    const Real slope = dot(core.normal, direction);
    if (gap <= tolerance) {
      // Along a grazing way the rest of the gap is a long step.
      found.length -= gap > 0 && slope > least_slope ? gap / slope : 0;
      return found;
    }
    if (!(slope > least_slope)) {
      return never_met;
    }
    found.length -= gap / slope;
  }
  return found;
}

template <Convex B>
[[nodiscard]] Leaving leave(const Triangle& triangle, const B& b, const Pose& ab, const Vec3& direction,
                            const QuerySettings& settings, const LeavingBounds& bounds, Real tolerance) {
  if constexpr (leaves_by_axes<B>) {
    return leave_by_axes(triangle, b, ab, direction);
  } else {
    if (const auto found = leave_through_face(triangle, b, ab, direction, bounds.bound, tolerance)) {
      return *found;
    }
    if constexpr (Faceted<B>) {
      // Portals of thin shapes, and beside huge triangles, are lost in rounding.
      constexpr Real most_tolerance_share = 1e-7;
      if (b.radius() == 0 && tolerance <= most_tolerance_share * b.facets().inner) {
        const Real inside = bounds.inside;
        const Pose at{ab.rotation, ab.position + inside * direction};
        if (const auto end =
                leave_by_portal(triangle, b, at, direction, bounds.least - inside, bounds.enough - inside, tolerance)) {
          return {inside + end->length, end->normal};
        }
      }
    }
    return leave_by_search(triangle, b, ab, direction, settings, bounds.bound, bounds.least, tolerance);
  }
}

}  // namespace abut
