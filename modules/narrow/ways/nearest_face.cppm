// SPDX-License-Identifier: Apache-2.0
// The face of a surface that a contact lies on.
export module abut.narrow.ways.nearest_face;
import abut.capability;
import abut.core.standard;
import abut.math;
import abut.narrow.ways.continuation;

export namespace abut {

// The normal of the face that holds a point and leans least from a direction; nothing where no face leans less than
// half a turn.
template <Surface S>
[[nodiscard]] std::optional<Vec3> nearest_face_normal(const S& surface, const Vec3& point, const Vec3& direction,
                                                      Real size) {
  std::optional<Vec3> best;
  Real most = 0;
  static_cast<void>(any_around(surface, point, size, [&](const TriangleCorners& corners, Real) {
    const Vec3 normal = Triangle(corners, 0, false).normal();
    if (const Real along = dot(normal, direction); std::fabs(along) > most) {
      most = std::fabs(along);
      best = along < 0 ? -normal : normal;
    }
    return false;
  }));
  return best;
}

}  // namespace abut
