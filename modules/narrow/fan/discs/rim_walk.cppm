// SPDX-License-Identifier: Apache-2.0
// A rim seen from a line: the axis of another body, or an edge. In the half plane through the line the rim is a closed
// curve. An aim there is a corner, another line, or the first line itself. Where the curve is nearest to its aim is
// found by dividing arcs of the rim until
// - all in an arc is too far, or
// - a derivative has one sign all along: of the distance, or of its derivative, or
// - the distance is the same all along, within the slack.
export module abut.narrow.fan.discs.rim_walk;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.narrow.fan.discs.disc_depth;

export namespace abut {

// Four values, with how far each can be from there within an arc.
struct Around {
  Lanes middle, spread;
};
[[nodiscard]] [[gnu::always_inline]] inline Around operator+(const Around& a, const Around& b) {
  return {a.middle + b.middle, a.spread + b.spread};
}
[[nodiscard]] [[gnu::always_inline]] inline Around operator-(const Around& a, const Around& b) {
  return {a.middle - b.middle, a.spread + b.spread};
}
[[nodiscard]] [[gnu::always_inline]] inline Around operator+(const Around& a, Real b) {
  return {a.middle + b, a.spread};
}
[[nodiscard]] [[gnu::always_inline]] inline Around operator-(const Around& a, Real b) {
  return {a.middle - b, a.spread};
}
inline constexpr Real boundless = 1e150;
[[nodiscard]] [[gnu::always_inline]] inline Around operator*(Real a, const Around& b) {
  return {a * b.middle, std::fabs(a) * b.spread};
}
[[nodiscard]] [[gnu::always_inline]] inline Around operator*(const Around& a, const Around& b) {
  return {a.middle * b.middle, absolute(a.middle) * b.spread + a.spread * (absolute(b.middle) + b.spread)};
}
// By what is above zero; by what may not be, anything: finite, so that none of it is nothing.
[[nodiscard]] [[gnu::always_inline]] inline Around operator/(const Around& a, const Around& b) {
  const Lanes middle = a.middle / b.middle, least = b.middle - b.spread;
  return {middle, least > all_lanes(0) ? (a.spread + absolute(middle) * b.spread) / least : all_lanes(boundless)};
}

// Points that are as near to each other meet: where one lies from the other is rounding. A direction that is off by an
// angle costs half its square of the size, so this is far above the noise.
[[nodiscard]] inline Real near_of(const DiscDepth& least) { return std::fmax(5e4 * least.noise(), least.touch()); }

// Half the angle of an arc. Each level divides the arcs of the one before by four.
struct Opening {
  Real angle, cosine, sine, cosine_of_three, sine_of_three;
  Real chord;  // from the middle of an arc of radius one to its ends
};
inline constexpr std::size_t level_count = 11;
inline constexpr std::array<Opening, level_count> openings = [] {
  constexpr Real right_angle = 1.57079632679489661923;
  const auto sine_of = [](Real angle) {
    Real sum = angle, term = angle;
    for (int i = 2; i < 28; i += 2) {
      term *= -angle * angle / (i * (i + 1));
      sum += term;
    }
    return sum;
  };
  std::array<Opening, level_count> result{};
  Real angle = right_angle / 6;
  for (Opening& opening : result) {
    opening = {angle,
               sine_of(right_angle - angle),
               sine_of(angle),
               sine_of(right_angle - 3 * angle),
               sine_of(3 * angle),
               2 * sine_of(angle / 2)};
    angle /= 4;
  }
  return result;
}();

// A rim around its middle, in a frame along a line, Z, with Y across the line and the axis of the rim. Its point at an
// angle t is middle + (along_x cos t, radius sin t, along_z cos t).
struct RimWalk {
  Vec3 middle;
  Real radius, along_x, along_z;
};

// A frame along a line Z. The axis of discs is (axis_x, 0, axis_z) in it.
struct AxisFrame {
  Vec3 x, y, z;
  Real axis_x, axis_z;

  // One of the rims of discs whose centre is given.
  [[nodiscard]] inline RimWalk walk(const Vec3& centre, const PlacedDiscs& discs, std::size_t rim) const {
    const Vec3 middle = centre + discs.height[rim] * discs.axis;
    const Real radius = discs.radius[rim];
    return {{dot(middle, x), dot(middle, y), dot(middle, z)}, radius, radius * axis_z, -radius * axis_x};
  }
  // Visits the unit directions with these parts along the axis of the discs and along Z: normals across lines of two
  // sides. Nearly parallel lines are compared without the difference of their parts, which would lose digits.
  template <class Visit>
  inline void visit_lines(Real up_axis, Real up_z, Visit&& visit) const {
    if (axis_x == 0) {
      return;  // parallel lines never meet
    }
    const Real turn = std::copysign(Real{1}, axis_z);
    const Real along_x = (up_axis - turn * up_z) / axis_x + turn * up_z * axis_x / (1 + std::fabs(axis_z));
    const Real rest = 1 - along_x * along_x - up_z * up_z;
    if (rest >= 0) {
      const Real along_y = std::sqrt(rest);
      visit(along_x, along_y, up_z);
      visit(along_x, -along_y, up_z);
    }
  }
};
[[nodiscard]] inline AxisFrame frame_along(const Vec3& z, const Vec3& axis) {
  const Vec3 across = cross(z, axis);
  const Vec3 y = UnitVec3::make(across).value_or(UnitVec3::from_unit_unchecked(tangents_of(z).first));
  const Vec3 x = cross(y, z);
  return {x, y, z, dot(x, axis), dot(z, axis)};
}

template <class Number>
struct RimPlace {
  Number x, y, z;
  Number out;  // from the axis of the other body
};

// The same in the half plane, and its derivatives by the angle.
template <class Number>
struct RimCurve {
  Number z, dz, ddz, out, d_out;
  Number half, d_half;  // of half the square of the distance: its derivatives, which are plain waves
};

[[nodiscard]] inline Real root(Real a) { return std::sqrt(a); }
[[nodiscard]] [[gnu::always_inline]] inline Lanes root(Lanes a) { return __builtin_elementwise_sqrt(a); }

template <class Number>
[[nodiscard]] [[gnu::always_inline]] inline RimPlace<Number> point_at(const RimWalk& walk, Number cosine, Number sine) {
  const Number x = walk.middle.x + walk.along_x * cosine, y = walk.middle.y + walk.radius * sine;
  return {x, y, walk.middle.z + walk.along_z * cosine, root(x * x + y * y)};
}
[[nodiscard]] inline RimPlace<Real> middle_of(const RimWalk& walk) {
  const auto& [x, y, z] = walk.middle;
  return {x, y, z, root(x * x + y * y)};
}
template <class Number>
[[nodiscard]] [[gnu::always_inline]] inline RimCurve<Number> curve_at(const RimWalk& walk, const RimPlace<Number>& at,
                                                                      Number cosine, Number sine) {
  const Real ahead = walk.middle.x * walk.along_x, across = walk.middle.y * walk.radius;
  const Real twice = walk.radius * walk.radius - walk.along_x * walk.along_x;
  const Number half = across * cosine - ahead * sine + twice * (cosine * sine);
  const Number d_half = twice * (cosine * cosine - sine * sine) - ahead * cosine - across * sine;
  return {at.z, -walk.along_z * sine, -walk.along_z * cosine, at.out, half / at.out, half, d_half};
}
// The same all along four arcs.
[[nodiscard]] [[gnu::always_inline]] inline RimCurve<Around> curve_around(const RimWalk& walk,
                                                                          const RimCurve<Lanes>& at, Lanes cosine,
                                                                          Lanes sine, const Opening& opening) {
  const Real ahead = walk.middle.x * walk.along_x, across = walk.middle.y * walk.radius;
  const Real twice = walk.radius * walk.radius - walk.along_x * walk.along_x;
  const Real back = 1 - opening.cosine, twice_back = 2 * opening.sine * opening.sine,
             twice_aside = 2 * opening.sine * opening.cosine;
  const Lanes once_value = ahead * cosine + across * sine, once_slope = across * cosine - ahead * sine;
  const Lanes double_sine = twice * (cosine * sine), double_cosine = twice * (cosine * cosine - sine * sine);
  const Lanes first = absolute(once_value), second = absolute(once_slope), third = absolute(double_sine),
              fourth = absolute(double_cosine);
  const Around half{at.half, opening.sine * first + back * second + 0.5 * twice_aside * fourth + twice_back * third};
  const Around d_half{at.d_half, opening.sine * second + back * first + 2 * twice_aside * third + twice_back * fourth};
  const Around out{at.out, all_lanes(walk.radius * opening.chord)};
  const Lanes rise = absolute(at.dz), bow = absolute(at.ddz);
  return {{at.z, opening.sine * rise + back * bow},
          {at.dz, opening.sine * bow + back * rise},
          {at.ddz, opening.sine * rise + back * bow},
          out,
          half / out,
          half,
          d_half};
}

// Four arcs of a rim next to each other: their middles, and a bit for each that may hold what is looked for.
struct FourArcs {
  Lanes cosine, sine;
  RimPlace<Lanes> at;
  std::uint64_t left;
  std::size_t level;
};
// What a larger arc around an angle is divided into.
template <class Aim>
[[nodiscard]] [[gnu::always_inline]] inline FourArcs four_arcs(const RimWalk& walk, const Aim& aim, Real cosine,
                                                               Real sine, std::size_t level, const DiscDepth& least) {
  const Opening& opening = openings[level];
  const Lanes across{-opening.sine_of_three, -opening.sine, opening.sine, opening.sine_of_three};
  const Lanes ahead{opening.cosine_of_three, opening.cosine, opening.cosine, opening.cosine_of_three};
  const Lanes cosines = cosine * ahead - sine * across, sines = sine * ahead + cosine * across;
  const RimPlace<Lanes> at = point_at(walk, cosines, sines);
  return {cosines, sines, at, aim.lanes_left(at, walk.radius * opening.chord + least.touch(), least.goal()), level};
}

// Newton's method doubles the digits, and the depth is off by the square of what is left: no step after one as short as
// this.
inline constexpr Real last_step = 1e-5;

// Where the slope vanishes in an arc in which it grows, within what is left; an end, where it does not. `turn`: by how
// much the method would step from the middle.
template <class Aim>
[[nodiscard]] RimPlace<Real> lowest_in(const RimWalk& walk, const Aim& aim, Real cosine, Real sine,
                                       const Opening& opening, Real turn, Real size) {
  // Tangents of half the angle from the middle: sines and cosines without series.
  const Real end = opening.sine / (1 + opening.cosine);
  Real low = turn < 0 ? -end : 0, high = turn < 0 ? 0 : end, at = 0;
  for (int round = 0;; ++round) {
    constexpr int rounds = 60;
    Real next = at + 0.5 * (1 + at * at) * turn;
    if (!(next >= low && next <= high)) {
      next = round < 3 && next < low ? low : round < 3 && next > high ? high : (low + high) / 2;
    }
    const Real step = std::fabs(next - at);
    at = next;
    const Real scale = 1 / (1 + at * at), c = (1 - at * at) * scale, s = 2 * at * scale;
    const Real turned_cosine = cosine * c - sine * s, turned_sine = sine * c + cosine * s;
    const RimPlace<Real> point = point_at(walk, turned_cosine, turned_sine);
    if (step < last_step * aim.shortened(point, size) || round == rounds || !(point.out > 0)) {
      return point;
    }
    const RimCurve<Real> curve = curve_at(walk, point, turned_cosine, turned_sine);
    const Real slope = aim.slope(curve), bend = aim.bend(curve);
    (slope < 0 ? low : high) = at;
    turn = bend != 0 ? -slope / bend : infinity;
  }
}

// All around, twelve arcs at first: what moves as twice the angle falls, rises, or keeps its sign in each.
template <class Visit>
[[gnu::always_inline]] inline void visit_turn(Visit&& visit) {
  constexpr Real half_root_of_three = 0.86602540378443864676;
  visit(Real{1}, Real{0});
  visit(Real{-0.5}, half_root_of_three);
  visit(Real{-0.5}, -half_root_of_three);
}

// Visits each point of a walk at which it is nearest to what is aimed for, and nearer than the least depth. False where
// that cannot be told.
template <class Aim, class Visit>
[[nodiscard]] bool walk_around(const RimWalk& walk, const Aim& aim, Real size, const DiscDepth& least, Visit&& visit) {
  constexpr int cut_limit = 256;
  const Real noise = noise_of(walk.radius * aim.unit_of_speed(size));
  [[clang::uninitialized]] std::array<FourArcs, 3 * (level_count + 1)> rest;
  std::size_t count = 0;
  const auto push = [&](Real cosine, Real sine, std::size_t level) {
    rest[count] = four_arcs(walk, aim, cosine, sine, level, least);
    count += rest[count].left != 0 ? 1 : 0;
  };
  aim.visit_starts([&](Real cosine, Real sine) { push(cosine, sine, 0); });
  for (int cuts = 0; count > 0; ++cuts) {
    const FourArcs arcs = rest[--count];
    const Opening& opening = openings[arcs.level];
    const RimPlace<Lanes>& at = arcs.at;
    const RimCurve<Lanes> curve = curve_at(walk, at, arcs.cosine, arcs.sine);
    const Lanes slope = aim.slope(curve);
    const Around bend = aim.bend(curve_around(walk, curve, arcs.cosine, arcs.sine, opening));
    const Lanes steepest = absolute(slope) + opening.angle * (absolute(bend.middle) + bend.spread);
    const std::uint64_t left = arcs.left & ~(bits_of(2 * absolute(slope) > steepest + noise) |
                                             bits_of(bend.middle + bend.spread < all_lanes(-noise)));
    const std::uint64_t rising = left & bits_of(bend.middle - bend.spread > all_lanes(noise));
    for (std::uint64_t lanes = rising; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      visit(lowest_in(walk, aim, arcs.cosine[lane], arcs.sine[lane], opening, -slope[lane] / bend.middle[lane], size));
    }
    if (left == rising) {
      continue;
    }
    const std::uint64_t level = left & ~rising & aim.lanes_level(at, steepest, opening.angle, least);
    for (std::uint64_t lanes = level; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      visit(RimPlace<Real>{at.x[lane], at.y[lane], at.z[lane], at.out[lane]});
    }
    std::uint64_t divided = left & ~rising & ~level;
    if (divided != 0 && (cuts == cut_limit || arcs.level + 1 == level_count)) {
      return false;
    }
    for (; divided != 0; divided &= divided - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(divided));
      push(arcs.cosine[lane], arcs.sine[lane], arcs.level + 1);
    }
  }
  return true;
}

}  // namespace abut
