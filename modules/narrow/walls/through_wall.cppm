// SPDX-License-Identifier: Apache-2.0
// Whether a triangle, a segment or a point comes through a wall of a cavity from inside. It has no inside of its own
// that could hold a point of the wall.
export module abut.narrow.walls.through_wall;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.walls.hole;
import abut.narrow.triangle.triangle_point;

export namespace abut {

// At most three corners, and one more for each wall.
using Polygon = SmallVector<Vec3, 12>;

// What of a convex polygon lies behind a plane. Two points are a segment.
[[nodiscard]] inline Polygon cut_behind(const Polygon& polygon, const Vec3& normal, Real offset) {
  Polygon behind;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const Real height = dot(normal, from) - offset, next = dot(normal, to) - offset;
    if (height <= 0) {
      behind.push_back(from);
    }
    if ((height < 0 && next > 0) || (height > 0 && next < 0)) {
      behind.push_back(from + (height / (height - next)) * (to - from));
    }
  }
  return behind;
}

// How near a polygon comes to the middle of a round wall. Seen along the axis it may have no area.
[[nodiscard]] inline Real least_reach(const RoundWall& wall, const Polygon& polygon) {
  Real least = infinity;
  const auto consider = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Real reach = norm(nearest_on({wall.radial(a), wall.radial(b), wall.radial(c)}, {0, 0, 0}));
    least = reach < least ? reach : least;
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& next = polygon[(i + 1) % polygon.size()];
    consider(polygon[i], next, next);
    consider(polygon[0], polygon[i], next);
  }
  return least;
}

// `corners`: in the frame of the cavity. `face`: of the wall.
[[nodiscard]] inline bool comes_through(const Walls& walls, std::uint32_t face, std::span<const Vec3> corners,
                                        Real noise) {
  Polygon left;
  for (const Vec3& corner : corners) {
    left.push_back(corner);
  }
  for (const FlatWall& wall : walls.flat.span()) {
    left = cut_behind(left, wall.normal, wall.offset + noise);
    if (wall.face == face) {
      left = cut_behind(left, -wall.normal, noise - wall.offset);
    }
  }
  if (left.empty() || !walls.round) {
    return !left.empty();
  }
  const RoundWall& wall = *walls.round;
  const auto reaches_out = [&](const Vec3& point) { return norm(wall.radial(point)) >= wall.radius - noise; };
  return least_reach(wall, left) <= wall.radius + noise &&
         (wall.face != face || std::ranges::any_of(left.span(), reaches_out));
}

}  // namespace abut
