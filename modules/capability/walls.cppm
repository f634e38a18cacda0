// SPDX-License-Identifier: Apache-2.0
// The walls of a cavity, seen from inside: flat ones, and a round one around a point or along Z. Where a wall is
// missing the cavity is open and goes on without end.
export module abut.capability.walls;
import abut.capability.concepts;
import abut.capability.records;
import abut.core.standard;
import abut.core;
import abut.math;

export namespace abut {

// Solid where dot(normal, p) >= offset.
struct FlatWall {
  Vec3 normal;  // unit, out of the cavity
  Real offset;
  std::uint32_t face;
};
using FlatWalls = SmallVector<FlatWall, 6>;

// Solid where a point is further than the radius from the origin, or from the Z axis.
struct RoundWall {
  Real radius;
  bool is_along_z;
  std::uint32_t face;

  // The part of a point that counts.
  [[nodiscard]] inline Vec3 radial(const Vec3& point) const { return {point.x, point.y, is_along_z ? 0 : point.z}; }
};

// A cavity: convex, between its walls.
template <class S>
concept Hole = Bounded<S> && requires(const S& shape) {
  { shape.flat_walls() } -> std::same_as<FlatWalls>;
  { shape.round_wall() } -> std::same_as<std::optional<RoundWall>>;
};

// Whether a point lies in the cavity by more than `inset`.
template <Hole S>
[[nodiscard]] bool is_within(const S& hole, const Vec3& point, Real inset) {
  const FlatWalls flat = hole.flat_walls();
  for (const FlatWall& wall : flat.span()) {
    if (!(dot(wall.normal, point) < wall.offset - inset)) {
      return false;
    }
  }
  const std::optional<RoundWall> wall = hole.round_wall();
  return !wall || norm(wall->radial(point)) < wall->radius - inset;
}

// Where a ray first crosses a wall. From outside it comes in through one, from inside it meets the far one.
template <Hole S>
[[nodiscard]] std::optional<RayHit> cast_ray_at_walls(const S& hole, const Vec3& origin, const UnitVec3& direction,
                                                      Real max_distance) {
  const Vec3 d = direction;
  RayHit enter{-infinity, {0, 0, 0}, {}}, leave{infinity, {0, 0, 0}, {}};
  const auto cut = [&](Real distance, bool leaves, const Vec3& outward, std::uint32_t face) {
    RayHit& side = leaves ? leave : enter;
    if (leaves ? distance < side.distance : distance > side.distance) {
      side = {distance, -outward, {FeatureKind::face, face}};
    }
  };
  const FlatWalls flat = hole.flat_walls();
  for (const FlatWall& wall : flat.span()) {
    const Real room = wall.offset - dot(wall.normal, origin), approach = dot(wall.normal, d);
    if (approach != 0) {
      cut(room / approach, approach > 0, wall.normal, wall.face);
    } else if (room < 0) {
      return std::nullopt;
    }
  }
  if (const std::optional<RoundWall> wall = hole.round_wall()) {
    const Vec3 from = wall->radial(origin), along = wall->radial(d);
    const Real speed = squared_norm(along);
    const Real middle = speed > 0 ? -dot(from, along) / speed : 0;
    const Real under = wall->radius * wall->radius - squared_norm(from + middle * along);
    if (under < 0) {
      return std::nullopt;
    }
    if (speed > 0) {
      const Real half_chord = std::sqrt(under / speed);
      for (const bool leaves : {false, true}) {
        const Real distance = leaves ? middle + half_chord : middle - half_chord;
        const auto outward = UnitVec3::make(from + distance * along);
        cut(distance, leaves, outward.value_or(direction), wall->face);
      }
    }
  }
  const RayHit& hit = enter.distance >= 0 ? enter : leave;
  if (!(enter.distance <= leave.distance) || !(hit.distance >= 0 && hit.distance <= max_distance)) {
    return std::nullopt;
  }
  return hit;
}

}  // namespace abut
