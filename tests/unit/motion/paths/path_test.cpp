// SPDX-License-Identifier: Apache-2.0
// Paths against Rodrigues' formula in long double, and their bounds against many times and points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

import abut.math;
import abut.math.turn;
import abut.motion.paths.path;

namespace {

using namespace abut;

using Long = std::array<long double, 3>;

Long cross_of(const Long& a, const Long& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A vector turned by an axis times an angle (Rodrigues 1840).
Long turned(const Long& turn, const Long& v) {
  const long double angle = std::sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2]);
  if (angle == 0) {
    return v;
  }
  const Long axis{turn[0] / angle, turn[1] / angle, turn[2] / angle};
  const long double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  const Long across = cross_of(axis, v);
  Long out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = v[i] * std::cos(angle) + across[i] * std::sin(angle) + axis[i] * along * (1 - std::cos(angle));
  }
  return out;
}

using LongReal = long double;

Long long_of(const Vec3& v) {
  return {static_cast<LongReal>(v.x), static_cast<LongReal>(v.y), static_cast<LongReal>(v.z)};
}

// Where a point of the body is, after a time.
Long point_at(const Pose& start, const Vec3& centre, const Motion& motion, const Vec3& point, long double time) {
  const auto passed = [&](const Vec3& rate, const Vec3& change) {
    const Long r = long_of(rate), c = long_of(change);
    Long out{};
    for (std::size_t i = 0; i < 3; ++i) {
      out[i] = time * r[i] + time * time / 2 * c[i];
    }
    return out;
  };
  const auto in_world = [&](const Vec3& v) {
    const Rotation& r = start.rotation;
    const Long of = long_of(v), x = long_of(r.x), y = long_of(r.y), z = long_of(r.z);
    Long out{};
    for (std::size_t i = 0; i < 3; ++i) {
      out[i] = x[i] * of[0] + y[i] * of[1] + z[i] * of[2];
    }
    return out;
  };
  const Long shift = passed(motion.velocity, motion.acceleration);
  const Long arm = turned(passed(motion.angular_velocity, motion.angular_acceleration), in_world(point - centre));
  const Long middle = in_world(centre), origin = long_of(start.position);
  Long out{};
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = origin[i] + middle[i] + shift[i] + arm[i];
  }
  return out;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) { testing::Test::RecordProperty("seed", static_cast<int>(seed)); }
  Real number(Real low, Real high) { return std::uniform_real_distribution<Real>(low, high)(engine_); }
  Vec3 vector(Real size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Pose pose() { return {rotation_by(vector(3)), vector(5)}; }
  // One in four without turning, one in four around a fixed axis.
  Motion motion() {
    Motion out{vector(4), vector(3), vector(6), vector(2)};
    const int kind = static_cast<int>(number(0, 4));
    if (kind == 0) {
      out.angular_velocity = out.angular_acceleration = {0, 0, 0};
    } else if (kind == 1) {
      out.angular_acceleration = number(-2, 2) * out.angular_velocity;
    } else if (kind == 2) {
      out.acceleration = {0, 0, 0};
    }
    return out;
  }

 private:
  std::mt19937 engine_;
};

Path path_of(const Pose& start, const Vec3& centre, const Motion& motion, Real duration) {
  return Path::along(start, centre, motion, duration).value();
}

Vec3 corner_of(const Aabb& box, unsigned corner) {
  return {(corner & 1) != 0 ? box.high.x : box.low.x, (corner & 2) != 0 ? box.high.y : box.low.y,
          (corner & 4) != 0 ? box.high.z : box.low.z};
}

TEST(Path, LeadsPointsWhereTheFormulaDoes) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Pose start = random.pose();
    const Vec3 centre = random.vector(1), point = random.vector(2);
    const Motion motion = random.motion();
    const Path path = path_of(start, centre, motion, 2);
    const Real time = random.number(0, 2);
    const Vec3 found = path.at(time) * point;
    const Long expected = point_at(start, centre, motion, point, static_cast<LongReal>(time));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(found[static_cast<int>(axis)], static_cast<double>(expected[axis]), 3e-14) << i;
    }
    EXPECT_EQ(path.at(0) * point, start * point) << "exactly the start";
  }
}

TEST(Path, TurnsFarWithoutLosingDigits) {
  const Vec3 axis{2. / 3, -2. / 3, 1. / 3};
  for (Real angle = 0.001; angle < 200; angle *= 1.37) {
    const Vec3 found = rotation_by(angle * axis) * Vec3{1, 2, 3};
    const Long expected = turned(long_of(angle * axis), {1, 2, 3});
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(found[static_cast<int>(i)], static_cast<double>(expected[i]), 1e-15 * (4 + angle)) << angle;
    }
  }
}

TEST(Path, BetweenTwoPosesEndsAtTheSecond) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Pose start = random.pose(), end = random.pose();
    const Vec3 centre = random.vector(1), point = random.vector(2);
    const Path path = Path::between(start, end, centre, 0.25).value();
    EXPECT_LE(norm(path.at(0.25) * point - end * point), 1e-13) << i;
    const Vec3 middle = path.at(0.125) * centre;
    EXPECT_LE(norm(middle - 0.5 * (start * centre + end * centre)), 1e-14) << "the centre goes straight";
  }
}

TEST(Path, BoundsHoldForSpeedsAndDeviations) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Pose start = random.pose();
    const Motion motion = random.motion();
    const Vec3 centre = random.vector(1);
    const Path path = path_of(start, centre, motion, 1);
    const Aabb body{centre - Vec3{0.5, 1, 0.25}, centre + Vec3{1.5, 0.5, 1}};
    const Reach reach = path.reach_of(body);
    const Real first = random.number(0, 0.8);
    const TimeSpan span{first, first + random.number(0.01, 0.2)};
    const Vec3 n = UnitVec3::make(random.vector(1)).value();
    const Real speed = path.largest_speed(span, reach.radius), along = path.largest_speed_along(n, span, reach);
    const Real deviation = path.largest_deviation(span, reach.radius);
    const Real bend = path.largest_acceleration_along(n, span, reach);
    constexpr int steps = 16;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec3 point = corner_of(body, corner);
      const Vec3 from = path.at(span.begin) * point, to = path.at(span.end) * point;
      for (int k = 0; k < steps; ++k) {
        const Real s = static_cast<Real>(k) / steps, t = span.begin + s * span.length(), dt = span.length() / steps;
        const Vec3 at = path.at(t) * point, next = path.at(t + dt) * point;
        EXPECT_LE(norm(next - at), speed * dt + 1e-13) << i;
        EXPECT_LE(dot(next - at, n), along * dt + 1e-13) << i;
        EXPECT_LE(norm(at - ((1 - s) * from + s * to)), deviation + 1e-13) << i;
        // A way along n that is bent less than `bend` lies above the straight one less half of it times s (1 - s).
        const Real straight = dot(n, (1 - s) * from + s * to);
        EXPECT_GE(dot(n, at), straight - 0.5 * bend * span.length() * span.length() * s * (1 - s) - 1e-13) << i;
      }
    }
  }
}

TEST(Path, SweptBoxesContainTheMotion) {
  Random random(4);
  Real widest = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose start = random.pose();
    const Motion motion = random.motion();
    const Vec3 centre = random.vector(1);
    const Path path = path_of(start, centre, motion, 2);
    const Aabb body{{-1, -0.5, -0.1}, {0.3, 0.5, 0.2}};
    const Real first = random.number(0, 1), length = i % 2 == 0 ? 1 : 0.05;
    const TimeSpan span{first, first + length};
    const Real radius = path.reach_of(body).radius;
    const Aabb swept =
        path.swept_box(transformed(body, path.at(span.begin)), transformed(body, path.at(span.end)), span, radius);
    Aabb met = Aabb::empty();
    constexpr int steps = 32;
    for (int k = 0; k <= steps; ++k) {
      const Aabb now = transformed(body, path.at(span.begin + span.length() * k / steps));
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(swept.low[axis], now.low[axis]) << i;
        EXPECT_GE(swept.high[axis], now.high[axis]) << i;
      }
      met.include(now);
    }
    if (length < 0.1) {
      widest = std::max(widest, largest_magnitude((swept.high - swept.low) - (met.high - met.low)));
    }
  }
  EXPECT_LT(widest, 0.15) << "of bodies two long that turn by up to a quarter of a radian";
}

TEST(Path, SweptBoxReachesTheApexOfAParabola) {
  const Path path = path_of(Pose::identity(), {0, 0, 0}, {.velocity = {1, 0, 5}, .acceleration = {0, 0, -10}}, 1);
  const Aabb body{{-1, -1, -1}, {1, 1, 1}};
  const Aabb swept = path.swept_box(body, {{0, -1, -1}, {2, 1, 1}}, path.whole(), 2);
  EXPECT_NEAR(swept.high.z, 2.25, 1e-12);
  EXPECT_LE(2.25, swept.high.z);
  EXPECT_NEAR(swept.low.z, -1, 1e-12);
  EXPECT_NEAR(swept.high.x, 2, 1e-12);
}

TEST(Path, SweptBoxOfWhatIsInfiniteIsInfinite) {
  const Aabb half{{-infinity, -infinity, -infinity}, {infinity, infinity, 1}};
  const Path falling = path_of(Pose::identity(), {0, 0, 0}, {.velocity = {0, 0, 2}}, 1);
  const Aabb swept = falling.swept_box(half, {half.low, {infinity, infinity, 3}}, falling.whole(), infinity);
  EXPECT_NEAR(swept.high.z, 3, 1e-12);
  EXPECT_EQ(swept.low, half.low);
  const Path turning = path_of(Pose::identity(), {0, 0, 0}, {.angular_velocity = {1, 0, 0}}, 1);
  const Aabb all = turning.swept_box(half, half, turning.whole(), infinity);
  EXPECT_EQ(all.high.z, infinity);
}

TEST(Path, RefusesWhatIsNoMotion) {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  const auto message = [](const Motion& motion, Real duration) {
    const auto made = Path::along(Pose::identity(), {0, 0, 0}, motion, duration);
    return made ? std::string("none") : made.error().message;
  };
  EXPECT_NE(message({.velocity = {0, nan, 0}}, 1).find("velocity[1] is nan"), std::string::npos);
  EXPECT_NE(message({.angular_acceleration = {0, 0, infinity}}, 1).find("angular_acceleration[2] is inf"),
            std::string::npos);
  EXPECT_EQ(message({}, -1), "duration is -1; it must be positive");
  EXPECT_EQ(message({.angular_velocity = {0, 0, 40 * std::numbers::pi}}, 1),
            "revolutions is 20; it must be at most 16 within the duration");
  EXPECT_EQ(message({.angular_velocity = {0, 0, 31 * std::numbers::pi}}, 1), "none");
  EXPECT_NE(message({.velocity = {1e70, 0, 0}}, 10).find("way is "), std::string::npos);
}

}  // namespace
