// SPDX-License-Identifier: Apache-2.0
// Where a shape leaves a triangle that it overlaps, on a way that parts both. From the end of the way, back along it,
// that is the first touch.
export module abut.narrow.many.last_touch;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.cast.cast_search;
import abut.narrow.cast.linear_cast;
import abut.narrow.convex;
import abut.narrow.many.parts_met;

export namespace abut {

struct LastTouch {
  Real depth;  // how far b has moved by then
  Vec3 point;  // of b, where it is now
};

// Nothing where b does not touch the triangle on the way. The way is long enough to have parted them.
template <Convex B>
[[nodiscard]] std::optional<LastTouch> last_touch(const Triangle& triangle, const B& b, const Pose& ab,
                                                  const PartingWay& way, const QuerySettings& settings) {
  const UnitVec3 back = UnitVec3::from_unit_unchecked(-way.direction);
  const Pose end = moved(ab, {back, way.depth}, -way.depth);
  std::optional<FirstTouch> touch;
  const Outcome outcome = first_touch(
      {back, way.depth}, core_size(triangle, b, end), 0,
      [&](Real travelled, Distance& out) {
        return convex_distance(triangle, b, moved(end, {back, way.depth}, travelled), settings, out);
      },
      [&](const Vec3& normal) { return -reach(b, end, -normal) - reach(triangle, Pose::identity(), normal); }, touch);
  if (outcome != Outcome::ok || !touch) {
    return std::nullopt;
  }
  const Real depth = way.depth - touch->travelled;
  return LastTouch{depth, touch->contact.point_b - depth * way.direction};
}

}  // namespace abut
