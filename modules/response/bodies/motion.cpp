// SPDX-License-Identifier: Apache-2.0
// The implicit midpoint rule for Euler's equations, with the Cayley map for the orientation: Lewis and Simo,
// "Conserving algorithms for the dynamics of Hamiltonian systems on Lie groups" (1994),
// https://doi.org/10.1007/BF02430634.
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>

module abut.response;

namespace abut::response {

namespace {

// Matrix of cross(v, .).
[[nodiscard]] Matrix cross_matrix(const abut_vec3& v) { return {0, -v.z, v.y, v.z, 0, -v.x, -v.y, v.x, 0}; }

[[nodiscard]] abut_vec3 solved(const Matrix& m, const abut_vec3& right) {
  const abut_vec3 a{m[0], m[3], m[6]}, b{m[1], m[4], m[7]}, c{m[2], m[5], m[8]};
  const double determinant = dot(a, cross(b, c));
  return scale({dot(right, cross(b, c)), dot(a, cross(right, c)), dot(a, cross(b, right))}, 1 / determinant);
}

// inertia (end - start) + dt middle x inertia middle = 0, all in the frame of the body. Newton's method from the start.
[[nodiscard]] abut_vec3 end_of(const Matrix& inertia, const abut_vec3& start, double dt) {
  constexpr int most_steps = 20;
  constexpr double rounding = 1e-16;
  abut_vec3 end = start;
  for (int i = 0; i < most_steps; ++i) {
    const abut_vec3 middle = scale(add(start, end), 0.5), momentum = times(inertia, middle);
    const abut_vec3 missed = add(times(inertia, subtract(end, start)), scale(cross(middle, momentum), dt));
    Matrix slope = inertia;
    const Matrix turning = product(cross_matrix(middle), inertia), pulling = cross_matrix(momentum);
    for (std::size_t j = 0; j < slope.size(); ++j) slope[j] += dt / 2 * (turning[j] - pulling[j]);
    const abut_vec3 step = solved(slope, missed);
    end = subtract(end, step);
    if (!(length(step) > rounding * length(end))) break;
  }
  return end;
}

}  // namespace

Turning turned_freely(const Matrix& inertia, const Turning& start, double dt) {
  // Newton's method is sure of itself where the body turns by less than half a radian at a time.
  constexpr double most_turn = 0.5, most_parts = 1000;
  const double parts = std::clamp(std::ceil(length(start.angular) * dt / most_turn), 1.0, most_parts);
  const double part = dt / parts;
  abut_quat orientation = start.orientation;
  abut_vec3 angular = times(transposed(matrix_of(orientation)), start.angular);
  for (double i = 0; i < parts; ++i) {
    const abut_vec3 end = end_of(inertia, angular, part);
    orientation = normalized(product(orientation, cayley(scale(add(angular, end), 0.25 * part))));
    angular = end;
  }
  return {.orientation = orientation, .angular = times(matrix_of(orientation), angular)};
}

}  // namespace abut::response
