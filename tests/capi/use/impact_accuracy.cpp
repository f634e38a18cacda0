// SPDX-License-Identifier: Apache-2.0
// Times of impact against the root of the gap in 113 bits. Nothing of the library is asked for the gap: corners above a
// plane, the axes of two boxes (Gottschalk 1996), and the distance of two segments.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "../../oracle/quad.hpp"
#include "support.hpp"

namespace {

using namespace abut_test;
using oracle::absolute;
using oracle::cross;
using oracle::dot;
using oracle::larger;
using oracle::quad;
using oracle::Quad;
using oracle::smaller;
using oracle::Vec;

using Axes = std::array<Vec, 3>;

Vec vec(const abut_vec3& v) { return {quad(v.x), quad(v.y), quad(v.z)}; }

// A body whose angular velocity and angular acceleration have one direction.
struct Body {
  abut_pose start;
  abut_movement movement;

  // Cosine and sine of half the angle by their series, which end below the last of 113 bits.
  oracle::Pose at(Quad time) const {
    const Vec turn = vec(movement.angular_velocity) * time + vec(movement.angular_acceleration) * (time * time / 2);
    const Quad squared = dot(turn, turn) / 4;
    Quad cosine = 0, sine_by_angle = 0, term = 1;
    for (int i = 0; i < 60; ++i) {
      cosine += term;
      term /= 2 * i + 1;
      sine_by_angle += term;
      term *= -squared / (2 * i + 2);
    }
    const Vec t = turn * (sine_by_angle / 2);
    const oracle::Pose begin =
        oracle::Pose::from({start.position.x, start.position.y, start.position.z},
                           {start.orientation.w, start.orientation.x, start.orientation.y, start.orientation.z});
    const auto& q = begin.orientation;
    const Vec s{q[1], q[2], q[3]};
    const Vec product = s * cosine + t * q[0] + cross(t, s);
    return {begin.position + vec(movement.velocity) * time + vec(movement.acceleration) * (time * time / 2),
            {cosine * q[0] - dot(t, s), product.x, product.y, product.z}};
  }
};

Axes axes_of(const oracle::Pose& pose) {
  return {pose.rotate({1, 0, 0}), pose.rotate({0, 1, 0}), pose.rotate({0, 0, 1})};
}

Quad reach_along(const Vec& axis, const Vec& half, const Axes& axes) {
  return half.x * absolute(dot(axes[0], axis)) + half.y * absolute(dot(axes[1], axis)) +
         half.z * absolute(dot(axes[2], axis));
}

// Positive where two boxes are apart, and zero where they touch.
Quad gap_of_boxes(const Vec& half_a, const oracle::Pose& a, const Vec& half_b, const oracle::Pose& b) {
  const Axes axes_a = axes_of(a), axes_b = axes_of(b);
  const Vec between = b.position - a.position;
  Quad largest = quad(-1e9);
  const auto try_axis = [&](const Vec& axis) {
    const Quad size = oracle::length(axis);
    if (size > quad(1e-9)) {
      const Quad reach = reach_along(axis, half_a, axes_a) + reach_along(axis, half_b, axes_b);
      largest = larger(largest, (absolute(dot(between, axis)) - reach) / size);
    }
  };
  for (const Vec& of_a : axes_a) {
    try_axis(of_a);
    for (const Vec& of_b : axes_b) {
      try_axis(cross(of_a, of_b));
    }
  }
  std::ranges::for_each(axes_b, try_axis);
  return largest;
}

// Of segments with middles p, q and halves u, v: the nearest points are both inside, or one is an end.
Quad distance_of_segments(const Vec& p, const Vec& u, const Vec& q, const Vec& v) {
  const auto to_segment = [](const Vec& point, const Vec& middle, const Vec& half) {
    const Quad s = oracle::clamped(dot(point - middle, half) / dot(half, half), -1, 1);
    return oracle::length(point - (middle + half * s));
  };
  Quad least = smaller(smaller(to_segment(p + u, q, v), to_segment(p - u, q, v)),
                       smaller(to_segment(q + v, p, u), to_segment(q - v, p, u)));
  const Vec w = p - q;
  const Quad a = dot(u, u), b = dot(u, v), c = dot(v, v), d = dot(u, w), e = dot(v, w), determinant = a * c - b * b;
  if (determinant > 0) {
    const Quad s = (b * e - c * d) / determinant, t = (a * e - b * d) / determinant;
    if (absolute(s) <= 1 && absolute(t) <= 1) {
      least = smaller(least, oracle::length(w + u * s - v * t));
    }
  }
  return least;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) { testing::Test::RecordProperty("seed", static_cast<int>(seed)); }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  abut_vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  // From `place` it flies by `way` within the step, more or less, and turns and speeds up.
  Body body(const abut_vec3& place, const abut_vec3& way) {
    const double w = number(-1, 1);
    const abut_vec3 v = vector(1);
    const double size = std::sqrt(w * w + v.x * v.x + v.y * v.y + v.z * v.z);
    Body out{{place, {w / size, v.x / size, v.y / size, v.z / size}}, {}};
    out.movement.velocity = {way.x + number(-0.5, 0.5), way.y + number(-0.5, 0.5), way.z + number(-0.5, 0.5)};
    out.movement.acceleration = vector(0.3);
    out.movement.angular_velocity = vector(1.5);
    const double faster = number(-0.2, 0.2);
    const abut_vec3& turn = out.movement.angular_velocity;
    out.movement.angular_acceleration = {faster * turn.x, faster * turn.y, faster * turn.z};
    return out;
  }

 private:
  std::mt19937 engine_;
};

struct Counts {
  int touches = 0, judged = 0;
};

// gap(time): of the oracle, for one step of duration 1. Where it closes slower than 1e-3 of the size, which is about 1,
// nothing but the freedom before `lower` is asked.
template <class Gap>
void judge(const abut_impact& found, const Gap& gap, Counts& counts) {
  ASSERT_TRUE(found.state == ABUT_IMPACT_APART || found.state == ABUT_IMPACT_TOUCHES);
  for (int k = 0; k < 64; ++k) {
    ASSERT_GT(static_cast<double>(gap(quad(found.lower) * k / 64)), 0);
  }
  if (found.state == ABUT_IMPACT_APART) {
    ASSERT_GT(static_cast<double>(gap(1)), 0);
    return;
  }
  ++counts.touches;
  const Quad step = quad(1e-5);
  Quad free = quad(found.lower) - step, closed = quad(found.upper) + step;
  if ((gap(free) - gap(closed)) / (closed - free) < quad(1e-3) || gap(closed) > 0) {
    return;
  }
  ++counts.judged;
  while (closed - free > quad(1e-18)) {
    const Quad middle = (free + closed) / 2;
    (gap(middle) > 0 ? free : closed) = middle;
  }
  EXPECT_LE(static_cast<double>(absolute(closed - quad(found.lower))), 1e-9);
  EXPECT_LE(static_cast<double>(absolute(closed - quad(found.upper))), 1e-9);
}

abut_impact impact_of(const Shape& a, const Body& of_a, const Shape& b, const Body& of_b) {
  abut_impact out{};
  EXPECT_EQ(abut_pair_time_of_impact(a, &of_a.start, &of_a.movement, b, &of_b.start, &of_b.movement, 1, nullptr, &out),
            ABUT_OK);
  return out;
}

TEST(ImpactAccuracy, OfCornersOnAPlane) {
  Random random(21);
  Counts counts;
  const Vec half{quad(0.5), quad(0.25), quad(0.125)};
  const Shape box = make_box(0.5, 0.25, 0.125), ground = make_plane({0, 0, 1}, 0);
  const Body still{{{0, 0, 0}, {1, 0, 0, 0}}, {}};
  for (int i = 0; i < 60; ++i) {
    const Body body = random.body({0, 0, 1.5}, {0, 0, -1.5});
    const auto gap = [&](Quad time) {
      const oracle::Pose pose = body.at(time);
      return pose.position.z - reach_along({0, 0, 1}, half, axes_of(pose));
    };
    judge(impact_of(box, body, ground, still), gap, counts);
  }
  EXPECT_GT(counts.touches, 30);
  EXPECT_GE(counts.judged, counts.touches - 2);
}

TEST(ImpactAccuracy, OfCornersAndEdgesOfBoxes) {
  Random random(22);
  Counts counts;
  const Vec half_a{quad(0.5), quad(0.25), quad(0.125)}, half_b{quad(0.03125), quad(0.75), quad(0.5)};
  const Shape a = make_box(0.5, 0.25, 0.125), b = make_box(0.03125, 0.75, 0.5);
  for (int i = 0; i < 60; ++i) {
    const Body of_a = random.body({0, 0, 0}, {0, 0, 0}), of_b = random.body({2, 0, 0}, {-2.5, 0, 0});
    const auto gap = [&](Quad time) { return gap_of_boxes(half_a, of_a.at(time), half_b, of_b.at(time)); };
    judge(impact_of(a, of_a, b, of_b), gap, counts);
  }
  EXPECT_GT(counts.touches, 20);
  EXPECT_GE(counts.judged, counts.touches - 2);
}

TEST(ImpactAccuracy, OfRods) {
  Random random(23);
  Counts counts;
  const Shape rod = make_capsule(0.0625, 1);
  for (int i = 0; i < 100; ++i) {
    const Body of_a = random.body({0, 0, 0}, {0, 0, 0}), of_b = random.body({2.5, 0, 0}, {-3, 0, 0});
    const auto gap = [&](Quad time) {
      const oracle::Pose at_a = of_a.at(time), at_b = of_b.at(time);
      return distance_of_segments(at_a.position, at_a.rotate({0, 0, 1}), at_b.position, at_b.rotate({0, 0, 1})) -
             quad(0.125);
    };
    judge(impact_of(rod, of_a, rod, of_b), gap, counts);
  }
  EXPECT_GT(counts.touches, 20);
  EXPECT_GE(counts.judged, counts.touches - 2);
}

}  // namespace
