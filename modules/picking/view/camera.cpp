// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/picking.h>

#include <cmath>

module abut.picking;
import :vector;

namespace abut::picking {

namespace {

// Sine of the least angle between two directions that still span a plane: what is left of a cross
// product of unit vectors below this is rounding.
constexpr double least_sine = 1e-12;

}  // namespace

bool are_parallel(const abut_vec3& a, const abut_vec3& b) {
  if (largest_component(a) == 0 || largest_component(b) == 0) return true;
  return length(cross(normalized(a), normalized(b))) < least_sine;
}

abut_quat look_along(const abut_vec3& forward, const abut_vec3& up) {
  const abut_vec3 back = scale(normalized(forward), -1);
  const abut_vec3 right = normalized(cross(normalized(up), back));
  const abut_vec3 above = cross(back, right);
  // Rotation matrix with the columns right, above, back to a quaternion; the largest of the four
  // components is computed first, the others are divided by it (Shepperd 1978).
  const double trace = right.x + above.y + back.z;
  abut_quat q{};
  if (trace > 0) {
    q = {1 + trace, above.z - back.y, back.x - right.z, right.y - above.x};
  } else if (right.x > above.y && right.x > back.z) {
    q = {above.z - back.y, 1 + right.x - above.y - back.z, above.x + right.y, back.x + right.z};
  } else if (above.y > back.z) {
    q = {back.x - right.z, above.x + right.y, 1 - right.x + above.y - back.z, back.y + above.z};
  } else {
    q = {right.y - above.x, back.x + right.z, back.y + above.z, 1 - right.x - above.y + back.z};
  }
  const double norm = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / norm, q.x / norm, q.y / norm, q.z / norm};
}

}  // namespace abut::picking
