// SPDX-License-Identifier: Apache-2.0
module abut.narrow.cast.front_touch;
import abut.math;
import abut.math.tolerance;

namespace abut {

bool stops(const TouchOfFront& touch, const UnitVec3& direction, Real slack) {
  const Real least_cosine = -noise_of(1);
  const auto is_apart_along = [&](const Vec3& normal, Real gap) { return squared_norm(normal) > 0 && gap >= -slack; };
  // A triangle without area has no front, and a touch may have no normal.
  const bool is_before_front = is_apart_along(touch.front, touch.gap_along_front),
             is_before_plane = is_apart_along(touch.normal, touch.gap_along_normal);
  const auto leaves_along = [&](const Vec3& normal) { return dot(direction, normal) >= least_cosine; };
  if (is_before_front && leaves_along(touch.front)) {
    return false;
  }
  // Rounding must not open edges of triangles that stand upright.
  const bool is_met_from_front = dot(touch.front, touch.normal) > least_cosine;
  if (touch.is_later) {
    return is_met_from_front;
  }
  if (is_before_plane && leaves_along(touch.normal)) {
    return false;
  }
  // What overlaps at the start has been judged by its contacts.
  return is_before_front || (is_before_plane && is_met_from_front);
}

}  // namespace abut
