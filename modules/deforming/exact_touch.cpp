// SPDX-License-Identifier: Apache-2.0
// Coordinates are multiples of a power of two, so c and q (see quick_touch.cpp) are polynomials with whole
// coefficients. A time of touch is a zero of one of them. Sturm's theorem tells zeros apart. A common
// divisor tells the sign of one polynomial at a zero of another. Source: Basu, Pollack, Roy, "Algorithms in Real
// Algebraic Geometry", 2006, chapters 2 and 10.
module;
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <boost/multiprecision/cpp_int.hpp>
#pragma clang diagnostic pop
module abut.deforming.exact_touch;
import abut.core.standard;
import abut.math;
import abut.deforming;
import abut.deforming.moving_triangle;

namespace abut {
namespace {

using Whole = boost::multiprecision::cpp_int;

// Coefficients of the powers of the time; the last one is not zero. Zero has none.
using Polynomial = std::vector<Whole>;

void trim(Polynomial& p) {
  while (!p.empty() && p.back().is_zero()) {
    p.pop_back();
  }
}

Polynomial sum(Polynomial a, const Polynomial& b, int sign) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) {
    a[i] += sign * b[i];
  }
  trim(a);
  return a;
}
Polynomial operator+(const Polynomial& a, const Polynomial& b) { return sum(a, b, 1); }
Polynomial operator-(const Polynomial& a, const Polynomial& b) { return sum(a, b, -1); }
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) {
    return {};
  }
  Polynomial product(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      product[i + j] += a[i] * b[j];
    }
  }
  return product;
}

using MovingVector = std::array<Polynomial, 3>;

MovingVector across(const MovingVector& a, const MovingVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Polynomial along(const MovingVector& a, const MovingVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Coefficients without a common factor: keeps zeros and signs, and numbers short.
void shorten(Polynomial& p) {
  Whole factor = 0;
  for (const Whole& coefficient : p) {
    factor = gcd(factor, coefficient);
  }
  for (Whole& coefficient : p) {
    coefficient /= factor;
  }
}

Polynomial derivative(const Polynomial& p) {
  Polynomial out;
  for (std::size_t i = 1; i < p.size(); ++i) {
    out.push_back(p[i] * i);
  }
  return out;
}

// Divides by b, which is not zero: a becomes a positive multiple of the remainder, and the quotient is returned times
// as much.
Polynomial divide(Polynomial& a, const Polynomial& b) {
  Polynomial quotient(a.size() >= b.size() ? a.size() - b.size() + 1 : 0);
  const Whole factor = abs(b.back());
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    const Whole share = b.back() < 0 ? Whole(-a.back()) : a.back();
    for (Whole& coefficient : a) {
      coefficient *= factor;
    }
    for (Whole& coefficient : quotient) {
      coefficient *= factor;
    }
    quotient[shift] += share;
    for (std::size_t i = 0; i < b.size(); ++i) {
      a[i + shift] -= share * b[i];
    }
    trim(a);
  }
  return quotient;
}

Polynomial common_divisor(Polynomial a, Polynomial b) {
  while (!b.empty()) {
    static_cast<void>(divide(a, b));
    shorten(a);
    a.swap(b);
  }
  return a;
}

// The same zeros, each once.
Polynomial without_repetition(Polynomial p) {
  shorten(p);
  const Polynomial repeated = common_divisor(p, derivative(p));
  if (repeated.size() > 1) {
    p = divide(p, repeated);
    shorten(p);
  }
  return p;
}

// The time numerator / 2^digits.
struct Time {
  Whole numerator = 0;
  unsigned digits = 0;
  friend bool operator==(const Time&, const Time&) = default;
};

Time between(const Time& a, const Time& b) {
  const unsigned digits = std::max(a.digits, b.digits);
  return {(a.numerator << (digits - a.digits)) + (b.numerator << (digits - b.digits)), digits + 1};
}

// Rounded down, or up.
Real rounded(const Time& time, bool is_up) {
  constexpr unsigned most_digits = 52;
  const unsigned surplus = time.digits > most_digits ? time.digits - most_digits : 0;
  Whole numerator = time.numerator >> surplus;
  if (is_up && (numerator << surplus) != time.numerator) {
    ++numerator;
  }
  return std::ldexp(static_cast<Real>(numerator), -static_cast<int>(time.digits - surplus));
}

int sign_at(const Polynomial& p, const Time& time) {
  Whole value = 0;
  for (std::size_t i = p.size(); i-- > 0;) {
    value = value * time.numerator + (p[i] << (time.digits * (p.size() - 1 - i)));
  }
  return value.sign();
}

std::vector<Polynomial> sturm_sequence(const Polynomial& p) {
  std::vector<Polynomial> sequence{p, derivative(p)};
  while (sequence.back().size() > 1) {
    Polynomial next = sequence[sequence.size() - 2];
    static_cast<void>(divide(next, sequence.back()));
    shorten(next);
    for (Whole& coefficient : next) {
      coefficient = -coefficient;
    }
    sequence.push_back(std::move(next));
  }
  return sequence;
}

int sign_changes(std::span<const Polynomial> sequence, const Time& time) {
  int changes = 0, last = 0;
  for (const Polynomial& p : sequence) {
    if (const int sign = sign_at(p, time); sign != 0) {
      changes += sign == -last ? 1 : 0;
      last = sign;
    }
  }
  return changes;
}

// The only zero of a polynomial in (low, high], or the time low = high.
struct Zero {
  Time low, high;
  [[nodiscard]] bool is_known() const { return low == high; }
};

// All zeros in (low, high], the first one first.
void part_zeros(std::span<const Polynomial> sequence, const Zero& all, int changes_low, int changes_high,
                std::vector<Zero>& out) {
  if (changes_low - changes_high == 1) {
    out.push_back(sign_at(sequence[0], all.high) == 0 ? Zero{all.high, all.high} : all);
  } else if (changes_low != changes_high) {
    const Time middle = between(all.low, all.high);
    const int changes = sign_changes(sequence, middle);
    part_zeros(sequence, {all.low, middle}, changes_low, changes, out);
    part_zeros(sequence, {middle, all.high}, changes, changes_high, out);
  }
}

std::vector<Zero> zeros_of(const Polynomial& p) {
  const std::vector<Polynomial> sequence = sturm_sequence(p);
  const Zero all{{0, 0}, {1, 0}};
  std::vector<Zero> zeros;
  part_zeros(sequence, all, sign_changes(sequence, all.low), sign_changes(sequence, all.high), zeros);
  return zeros;
}

void halve(const Polynomial& p, Zero& zero) {
  const Time middle = between(zero.low, zero.high);
  const int sign = sign_at(p, middle);
  if (sign == 0) {
    zero = {middle, middle};
  } else {
    (sign == sign_at(p, zero.high) ? zero.high : zero.low) = middle;
  }
}

// The sign that all Bernstein coefficients of p over a stretch of time have, or 0.
int sign_over(const Polynomial& p, const Zero& stretch) {
  const std::size_t degree = p.size() - 1;
  const unsigned digits = std::max(stretch.low.digits, stretch.high.digits);
  const Polynomial line{stretch.low.numerator << (digits - stretch.low.digits),
                        (stretch.high.numerator << (digits - stretch.high.digits)) -
                            (stretch.low.numerator << (digits - stretch.low.digits))};
  Polynomial moved(p.size()), power{1};
  for (std::size_t i = 0; i <= degree; ++i) {
    const Whole factor = p[i] << (digits * (degree - i));
    for (std::size_t k = 0; k <= i; ++k) {
      moved[k] += factor * power[k];
    }
    power = power * line;
  }
  // The coefficient k is the sum over i <= k of binomial(k, i) / binomial(degree, i) moved[i].
  constexpr std::array<int, 5> factorials{1, 1, 2, 6, 24};
  int sign = 0;
  for (std::size_t k = 0; k <= degree; ++k) {
    Whole value = 0;
    for (std::size_t i = 0; i <= k; ++i) {
      value += moved[i] * (factorials[k] / factorials[k - i] * factorials[degree - i]);
    }
    if (value.is_zero() || value.sign() == -sign) {
      return 0;
    }
    sign = value.sign();
  }
  return sign;
}

// The sign of p at a zero of f, which gets nearer on the way.
int sign_at_zero(const Polynomial& f, Zero& zero, const Polynomial& p) {
  if (p.size() < 2) {
    return p.empty() ? 0 : p[0].sign();
  }
  if (const int sign = zero.is_known() ? 0 : sign_over(p, zero); sign != 0) {
    return sign;
  }
  const Polynomial common = common_divisor(f, p);
  for (;;) {
    if (zero.is_known()) {
      return sign_at(p, zero.high);
    }
    // The divisor has no zero but those of f: it changes its sign here only where this is one of its own.
    if (common.size() > 1 && sign_at(common, zero.low) * sign_at(common, zero.high) < 0) {
      return 0;
    }
    if (const int sign = sign_over(p, zero); sign != 0) {
      return sign;
    }
    halve(f, zero);
  }
}

class ExactTriangle {
 public:
  explicit ExactTriangle(const std::array<MovingVector, 3>& corners) : d_(corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      w_[i] = across(d_[(i + 1) % 3], d_[(i + 2) % 3]);
    }
    c_ = along(d_[0], w_[0]);
    q_ = {along(w_[0], w_[1]), along(w_[1], w_[2]), along(w_[2], w_[0])};
  }

  // Polynomials of which one is zero when the origin comes in, if it does so after the start.
  [[nodiscard]] std::vector<Polynomial> candidates() const {
    if (!c_.empty()) {
      return {c_};
    }
    std::vector<Polynomial> all(q_.begin(), q_.end());
    for (std::size_t i = 0; i < 3; ++i) {
      all.push_back(along(w_[i], w_[i]));
      for (std::size_t j = i; j < 3; ++j) {
        all.push_back(along(d_[i], d_[j]));
      }
    }
    return all;
  }

  // Whether the origin is in the triangle when polynomials have these signs.
  template <class SignOf>
  [[nodiscard]] bool holds_origin(const SignOf& sign_of) const {
    if (sign_of(c_) != 0 || std::ranges::any_of(q_, [&](const Polynomial& q) { return sign_of(q) < 0; })) {
      return false;
    }
    for (const MovingVector& w : w_) {
      if (std::ranges::any_of(w, [&](const Polynomial& coordinate) { return sign_of(coordinate) != 0; })) {
        return true;
      }
    }
    // All corners lie on a line through the origin, which is between two of them or is one.
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = i; j < 3; ++j) {
        if (sign_of(along(d_[i], d_[j])) <= 0) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  std::array<MovingVector, 3> d_, w_;
  Polynomial c_;
  std::array<Polynomial, 3> q_;
};

// The mantissa as a whole number, and the power of two that it is multiplied by.
std::pair<std::int64_t, int> parts_of(Real value) {
  constexpr int digits = std::numeric_limits<Real>::digits;
  int exponent = 0;
  const Real mantissa = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(mantissa, digits)), exponent - digits};
}

int least_exponent(const std::array<MovingDifference, 3>& corners) {
  int least = std::numeric_limits<int>::max();
  for (const MovingDifference& corner : corners) {
    for (const Vec3& point : {corner.a.start, corner.a.end, corner.b.start, corner.b.end}) {
      for (const Real coordinate : {point.x, point.y, point.z}) {
        least = coordinate != 0 ? std::min(least, parts_of(coordinate).second) : least;
      }
    }
  }
  return least;
}

ExactTriangle exact(const std::array<MovingDifference, 3>& corners) {
  const int least = least_exponent(corners);
  const auto whole = [&](Real value) {
    const auto [mantissa, exponent] = parts_of(value);
    return mantissa == 0 ? Whole(0) : Whole(mantissa) << (exponent - least);
  };
  std::array<MovingVector, 3> d;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Whole start = whole(corners[i].a.start[axis]) - whole(corners[i].b.start[axis]),
                  end = whole(corners[i].a.end[axis]) - whole(corners[i].b.end[axis]);
      Polynomial& coordinate = d[i][static_cast<std::size_t>(axis)];
      coordinate = {start, end - start};
      trim(coordinate);
    }
  }
  return ExactTriangle(d);
}

}  // namespace

MovingTouch exact_touch(const std::array<MovingDifference, 3>& corners) {
  const ExactTriangle triangle = exact(corners);
  if (triangle.holds_origin([](const Polynomial& p) { return p.empty() ? 0 : p[0].sign(); })) {
    return {true, 0, 0};
  }
  MovingTouch first;
  for (const Polynomial& candidate : triangle.candidates()) {
    if (candidate.size() < 2) {
      continue;
    }
    const Polynomial f = without_repetition(candidate);
    for (Zero& zero : zeros_of(f)) {
      if (!triangle.holds_origin([&](const Polynomial& p) { return sign_at_zero(f, zero, p); })) {
        continue;
      }
      constexpr Real wanted_width = 0x1p-44;
      while (!zero.is_known() && rounded(zero.high, true) - rounded(zero.low, false) > wanted_width) {
        halve(f, zero);
      }
      const MovingTouch touch{true, rounded(zero.low, false), rounded(zero.high, true)};
      first = first.touches ? MovingTouch{true, std::min(first.lower, touch.lower), std::min(first.upper, touch.upper)}
                            : touch;
      break;
    }
  }
  return first;
}

}  // namespace abut
