// SPDX-License-Identifier: Apache-2.0
#include "turn.hpp"

#include <numbers>

namespace cli {

using namespace tools;

namespace {

struct SineCosine {
  double sine;
  double cosine;
};

// Taylor series for |x| <= pi / 4. Terms that are left out are below 1e-17 of the sum.
SineCosine series(double x) {
  const double square = x * x;
  double sine = 1.0;
  for (double n = 16.0; n >= 2.0; n -= 2.0) {
    sine = 1.0 - sine * square / (n * (n + 1.0));
  }
  double cosine = 1.0;
  for (double n = 18.0; n >= 2.0; n -= 2.0) {
    cosine = 1.0 - cosine * square / (n * (n - 1.0));
  }
  return {x * sine, cosine};
}

// Whole turns and quarters are taken off without rounding, so multiples of 90 degrees are exact.
SineCosine sine_cosine(double degrees) {
  const double within = std::fmod(degrees, 360.0);
  const double quarters = std::floor(within / 90.0 + 0.5);
  const SineCosine rest = series((within - 90.0 * quarters) * (std::numbers::pi / 180.0));
  switch (static_cast<int>(quarters) & 3) {
    case 0: return rest;
    case 1: return {rest.cosine, -rest.sine};
    case 2: return {-rest.sine, -rest.cosine};
    default: return {-rest.cosine, rest.sine};
  }
}

}  // namespace

abut_quat turn_by(const abut_vec3& axis, double degrees) {
  const SineCosine half = sine_cosine(0.5 * degrees);
  const abut_vec3 imaginary = normalised(axis) * half.sine;
  return {half.cosine, imaginary.x, imaginary.y, imaginary.z};
}

abut_pose compose(const abut_pose& a, const abut_pose& b) {
  return {a.position + rotate(a.orientation, b.position), unit(multiply(a.orientation, b.orientation))};
}

}  // namespace cli
