// SPDX-License-Identifier: Apache-2.0
// The origin lies in a triangle with the corners d0, d1, d2 when
//
// - it lies in its plane: c = det(d0, d1, d2) = 0, and
// - it lies on the same side of all edges: of w_i = d_(i+1) x d_(i+2), no two point in opposite directions, so that
//   q_ij = w_i . w_j >= 0.
//
// Along straight paths c is a cubic and each q_ij a quartic of the time. In Bernstein form their coefficients bound
// them over a stretch of time, and halving the stretch tightens that (Farin, "Curves and Surfaces for CAGD", 2002).
module abut.deforming.moving_triangle;
import abut.core.standard;
import abut.math;
import abut.deforming;

namespace abut {
namespace {

using Cubic = std::array<Real, 4>;
using Quartic = std::array<Real, 5>;

// What rounding may add to c and to q, in units in the last place of one. Bounds of c are times the cube of the largest
// coordinate, those of q times its fourth power. Products and sums add 48 and 136. Each of at most 30 halvings adds 18
// and 48.
constexpr int most_halvings = 30;
constexpr Real unit = epsilon / 2;
constexpr Real cubic_rounding = 1024 * unit, quartic_rounding = 2048 * unit;

// More stretches at once than there are halvings are not needed.
constexpr std::size_t most_waiting = most_halvings + 2;
// Grazing motion is halved again and again; exact numbers are quicker than this many halvings.
constexpr int most_stretches = 200;

// How near the ends of the answer come to each other, where rounding allows it.
constexpr Real wanted_width = 0x1p-40;

struct Stretch {
  Cubic c;
  std::array<Quartic, 3> q;
  Real low, high;
};

template <std::size_t Count>
bool are_above(const std::array<Real, Count>& values, Real limit) {
  bool all = true;
  for (const Real value : values) {
    all &= value > limit;
  }
  return all;
}
template <std::size_t Count>
bool are_below(const std::array<Real, Count>& values, Real limit) {
  bool all = true;
  for (const Real value : values) {
    all &= value < limit;
  }
  return all;
}

// De Casteljau's algorithm.
template <std::size_t Count>
void halve(const std::array<Real, Count>& whole, std::array<Real, Count>& left, std::array<Real, Count>& right) {
  std::array<Real, Count> row = whole;
  for (std::size_t last = Count - 1;; --last) {
    left[Count - 1 - last] = row[0];
    right[last] = row[last];
    if (last == 0) {
      return;
    }
    for (std::size_t i = 0; i < last; ++i) {
      row[i] = 0.5 * (row[i] + row[i + 1]);
    }
  }
}

Real value_at(const Cubic& c, Real x) {
  const Real y = 1 - x;
  const Real a = y * c[0] + x * c[1], b = y * c[1] + x * c[2], d = y * c[2] + x * c[3];
  return y * (y * a + x * b) + x * (y * b + x * d);
}

// The whole motion. Returns false where c has no zero.
bool start_from(const MovingTriangle& triangle, Real cubic_error, Stretch& whole) {
  const auto& [a, b] = triangle;
  std::array<std::array<Vec3, 3>, 3> w;  // coefficients of w0, w1, w2
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    w[i] = {cross(a[j], a[k]), 0.5 * (cross(a[j], b[k]) + cross(b[j], a[k])), cross(b[j], b[k])};
  }
  const auto& [start, middle, end] = w[0];
  whole.c = {dot(a[0], start), (dot(b[0], start) + 2 * dot(a[0], middle)) / 3,
             (2 * dot(b[0], middle) + dot(a[0], end)) / 3, dot(b[0], end)};
  if (are_above(whole.c, cubic_error) || are_below(whole.c, -cubic_error)) {
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &u = w[i], &v = w[(i + 1) % 3];
    whole.q[i] = {dot(u[0], v[0]), 0.5 * (dot(u[0], v[1]) + dot(u[1], v[0])),
                  (dot(u[0], v[2]) + 4 * dot(u[1], v[1]) + dot(u[2], v[0])) / 6,
                  0.5 * (dot(u[1], v[2]) + dot(u[2], v[1])), dot(u[2], v[2])};
  }
  whole.low = 0;
  whole.high = 1;
  return true;
}

// The zero of a cubic that rises over [0, 1], as far as the signs beside it are certain. Regula falsi aims at it, and
// looks at a place on each side: so both ends come nearer. Where they do not by half, the middle is looked at.
std::pair<Real, Real> zero_of_rising(const Cubic& c, Real error, Real width) {
  Real low = 0, high = 1, at_low = c[0], at_high = c[3];
  const auto take = [&](Real x) {
    const Real value = x > low && x < high ? value_at(c, x) : 0;
    if (value < -error) {
      low = x;
      at_low = value;
    } else if (value > error) {
      high = x;
      at_high = value;
    }
    return std::fabs(value) > error;
  };
  // Near the zero no sign is certain: then the next places lie further from it.
  constexpr Real further = 8;
  Real share = 1;
  for (int round = 0; round < 80 && high - low > width; ++round) {
    const Real before = high - low, slope = (at_high - at_low) / before;
    const Real zero = low - at_low / slope, aside = share * std::max(0.25 * width, 4 * error / slope);
    const bool has_left = take(zero - aside), has_right = take(zero + aside);
    const bool is_half = high - low <= 0.5 * before;
    const bool is_nearer = is_half || take(0.5 * (low + high)) || has_left || has_right;
    share = is_nearer ? 1 : further * share;
    if (!is_nearer && aside > before) {
      break;
    }
  }
  return {low, high};
}

// The time at which c passes zero; none unless it surely passes once, with the origin surely on one side of all edges.
std::optional<MovingTouch> certain_touch(const Stretch& at, Real cubic_error, Real quartic_error) {
  if (!std::ranges::all_of(at.q, [&](const Quartic& q) { return are_above(q, quartic_error); })) {
    return std::nullopt;
  }
  Cubic c = at.c;
  if (c[0] > c[3]) {
    for (Real& coefficient : c) {
      coefficient = -coefficient;
    }
  }
  const bool passes = c[0] < -cubic_error && c[3] > cubic_error;
  const bool rises = c[1] - c[0] > 2 * cubic_error && c[2] - c[1] > 2 * cubic_error && c[3] - c[2] > 2 * cubic_error;
  if (!passes || !rises) {
    return std::nullopt;
  }
  const Real width = at.high - at.low;
  const auto [low, high] = zero_of_rising(c, cubic_error, wanted_width / width);
  return MovingTouch{true, std::max(at.low + low * width - epsilon, Real{0}),
                     std::min(at.low + high * width + epsilon, Real{1})};
}

// Signs of differences survive rounding, so this needs no bound.
bool is_beside_origin(const MovingTriangle& triangle) {
  Vec3 low = triangle.start[0], high = low;
  for (const auto& corners : {triangle.start, triangle.end}) {
    for (const Vec3& corner : corners) {
      low = minimum(low, corner);
      high = maximum(high, corner);
    }
  }
  return low.x > 0 || low.y > 0 || low.z > 0 || high.x < 0 || high.y < 0 || high.z < 0;
}

}  // namespace

std::optional<MovingTouch> quick_touch(const MovingTriangle& triangle) {
  if (is_beside_origin(triangle)) {
    return MovingTouch{};
  }
  // Fourth powers of these neither overflow nor lose digits.
  constexpr Real least_size = 1e-60, most_size = 1e60;
  const Real size = largest_coordinate_of(triangle);
  if (!(size > least_size && size < most_size)) {
    return std::nullopt;
  }
  const Real cube = size * size * size;
  const Real cubic_error = cubic_rounding * cube, quartic_error = quartic_rounding * cube * size;
  [[clang::uninitialized]] std::array<Stretch, most_waiting> waiting;
  if (!start_from(triangle, cubic_error, waiting[0])) {
    return MovingTouch{};
  }
  std::size_t count = 1;
  for (int stretches = 0; count > 0; ++stretches) {
    const Stretch at = waiting[--count];
    const bool is_apart = are_above(at.c, cubic_error) || are_below(at.c, -cubic_error) ||
                          std::ranges::any_of(at.q, [&](const Quartic& q) { return are_below(q, -quartic_error); });
    if (is_apart) {
      continue;
    }
    if (const auto touch = certain_touch(at, cubic_error, quartic_error)) {
      return touch;
    }
    constexpr Real least_width = 1.0 / (std::uint64_t{1} << most_halvings);
    if (at.high - at.low <= least_width || stretches == most_stretches) {
      return std::nullopt;
    }
    // The earlier half comes next.
    Stretch &right = waiting[count], &left = waiting[count + 1];
    count += 2;
    halve(at.c, left.c, right.c);
    for (std::size_t i = 0; i < 3; ++i) {
      halve(at.q[i], left.q[i], right.q[i]);
    }
    left.low = at.low;
    left.high = right.low = 0.5 * (at.low + at.high);
    right.high = at.high;
  }
  return MovingTouch{};
}

}  // namespace abut
