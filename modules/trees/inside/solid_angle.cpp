// SPDX-License-Identifier: Apache-2.0
module abut.trees.inside.solid_angle;
import abut.core.standard;
import abut.math;
import abut.math.wide;

namespace abut {

// The angle is halved four times; then its series is short.
Real angle_of(Real real, Real imaginary) {
  constexpr int halvings = 4, terms = 11;
  Real x = real, y = imaginary;
  for (int i = 0; i < halvings; ++i) {
    const Real length = std::sqrt(x * x + y * y);
    if (x < 0) {
      const Real rise = std::fabs(y);
      y = std::copysign(length - x, y);
      x = rise;
    } else {
      x += length;
    }
  }
  const Real tangent = y / x, square = tangent * tangent;
  Real sum = 0;
  for (int term = terms; term >= 0; --term) {
    sum = 1.0 / (2 * term + 1) - square * sum;
  }
  return (1 << halvings) * tangent * sum;
}

Real SolidAngles::turns() const {
  Real turns = 0;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    turns += static_cast<Real>(turns_[lane]) + angle_of(real_[lane], imaginary_[lane]) / (2 * std::numbers::pi);
  }
  return turns;
}

namespace {

Wide length(const WideVec3& v) {
  const Wide square = squared_norm(v);
  if (!(square.high > 0)) {
    return 0;
  }
  const Real root = std::sqrt(square.high);
  return Wide(root) + (square - Wide::product(root, root)) / Wide(2 * root);
}

}  // namespace

HalfAngle half_angle(const std::array<WideVec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Wide sine = dot(a, cross(b, c));
  if (sine.high == 0) {
    return {0, 1};
  }
  const Wide of_a = length(a), of_b = length(b), of_c = length(c);
  const Wide cosine = of_a * of_b * of_c + dot(a, b) * of_c + dot(b, c) * of_a + dot(c, a) * of_b;
  return {sine.high, cosine.high};
}

}  // namespace abut
