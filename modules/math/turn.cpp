// SPDX-License-Identifier: Apache-2.0
module abut.math.turn;
import abut.core.standard;
import abut.math.pose;
import abut.math.vec3;

namespace abut {
namespace {

// For |t| below 0.1, where what the series leaves out is below rounding.
Real small_arc_tangent(Real t) {
  const Real s = t * t;
  return t * (1 - s * (1. / 3 - s * (1. / 5 - s * (1. / 7 - s * (1. / 9 - s * (1. / 11 - s * (1. / 13 - s / 15)))))));
}

// 1 / factorial, with the sign of its place in a series of Taylor.
constexpr Real coefficient(int factorial) {
  Real product = 1;
  for (int i = 2; i <= factorial; ++i) {
    product *= i;
  }
  return (factorial / 2 % 2 == 0 ? 1 : -1) / product;
}

// The cosine of an angle, and its sine over the angle, by the square of the angle. For angles up to a quarter of pi,
// where what the series leave out is below rounding.
template <int first>
Real series(Real s) {
  Real sum = coefficient(16 + first);
  [&]<std::size_t... Terms>(std::index_sequence<Terms...>) {
    ((sum = sum * s + coefficient(14 + first - 2 * static_cast<int>(Terms))), ...);
  }(std::make_index_sequence<8>{});
  return sum;
}
Real series_of_cosine(Real s) { return series<0>(s); }
Real series_of_sine(Real s) { return series<1>(s); }

struct SineAndCosine {
  Real sine, cosine;
};

// Of an angle that is not negative. Whole quarter turns are taken off with the two parts of half of pi that Cody and
// Waite ("Software manual for the elementary functions", 1980) propose: the first has 33 bits, so its multiples are
// exact.
SineAndCosine sine_and_cosine(Real angle) {
  constexpr Real first_part = 0x1.921fb544p+0, second_part = 0x1.0b4611a626331p-34;
  const Real quarters = std::floor(angle * (2 / std::numbers::pi) + 0.5);
  const Real rest = (angle - quarters * first_part) - quarters * second_part;
  const Real s = rest * rest, sine = rest * series_of_sine(s), cosine = series_of_cosine(s);
  switch (static_cast<std::uint32_t>(quarters) % 4) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

}  // namespace

// The quaternion of the turn is (cos h, sin h * axis) for half of its angle, h. The tangent of half an angle is
// t / (1 + sqrt(1 + t^2)). Square roots are the same on every platform, unlike the functions of the library that would
// answer at once.
Vec3 turn_between(const Quat& before, const Quat& after) {
  const Quat &a = after, &b = before;
  Real w = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  Vec3 v{a.x * b.w - a.w * b.x + (a.z * b.y - a.y * b.z), a.y * b.w - a.w * b.y + (a.x * b.z - a.z * b.x),
         a.z * b.w - a.w * b.z + (a.y * b.x - a.x * b.y)};
  if (w < 0) {
    w = -w;
    v = -v;
  }
  const Real sine = norm(v);
  if (sine == 0) {
    return {0, 0, 0};
  }
  Real t = sine / (w + std::sqrt(w * w + sine * sine));  // of a quarter of the angle, at most 1
  for (int i = 0; i < 3; ++i) {
    t = t / (1 + std::sqrt(1 + t * t));
  }
  return (32 * small_arc_tangent(t) / sine) * v;
}

// Divides by the largest of the four numbers, so that none loses digits (Shepperd, "Quaternion from rotation matrix",
// 1978).
Quat quaternion_of(const Rotation& rotation) {
  const Vec3 &x = rotation.x, &y = rotation.y, &z = rotation.z;
  const std::array<Real, 4> squares{1 + x.x + y.y + z.z, 1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const Vec3 turned{y.z - z.y, z.x - x.z, x.y - y.x};
  Quat q{};
  switch (largest) {
    case 0: q = {squares[0], turned.x, turned.y, turned.z}; break;
    case 1: q = {turned.x, squares[1], x.y + y.x, x.z + z.x}; break;
    case 2: q = {turned.y, x.y + y.x, squares[2], y.z + z.y}; break;
    default: q = {turned.z, x.z + z.x, y.z + z.y, squares[3]}; break;
  }
  return normalized(q).value_or(Quat{1, 0, 0, 0});
}

Rotation rotation_by(const Vec3& turn) {
  constexpr Real small = 0.25;
  const Real square = 0.25 * squared_norm(turn);  // of half of the angle
  if (square < small) {
    const Real share = 0.5 * series_of_sine(square);
    return Rotation::from({series_of_cosine(square), share * turn.x, share * turn.y, share * turn.z});
  }
  const Real half = std::sqrt(square);
  const auto [sine, cosine] = sine_and_cosine(half);
  const Real share = 0.5 * sine / half;
  return Rotation::from({cosine, share * turn.x, share * turn.y, share * turn.z});
}

}  // namespace abut
