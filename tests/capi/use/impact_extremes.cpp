// SPDX-License-Identifier: Apache-2.0
// Times of impact of extreme shapes and motions: a giant and a speck, sheets, needles, propellers. The distance of the
// library judges the interval, and every question is asked again swapped and in two halves.
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "support.hpp"

namespace {

using namespace abut_test;

struct Body {
  abut_pose start;
  abut_movement movement;
};

// Without accelerations.
abut_movement moving(const abut_vec3& velocity, const abut_vec3& angular_velocity) {
  abut_movement out{};
  out.velocity = velocity;
  out.angular_velocity = angular_velocity;
  return out;
}

struct Pair {
  const char* name;
  Shape a, b;
  double size;  // of both, as a length
};

abut_vec3 operator+(const abut_vec3& a, const abut_vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
abut_vec3 operator*(double s, const abut_vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
double norm(const abut_vec3& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

abut_quat product(const abut_quat& a, const abut_quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

// With constant speeds, around the origin of the shape.
abut_pose at_time(const Body& body, double time) {
  const abut_vec3 turn = time * body.movement.angular_velocity;
  const double angle = norm(turn), share = angle > 0 ? std::sin(angle / 2) / angle : 0.5;
  const abut_quat turned{std::cos(angle / 2), share * turn.x, share * turn.y, share * turn.z};
  return {body.start.position + time * body.movement.velocity, product(turned, body.start.orientation)};
}

abut_impact impact_of(const Shape& a, const Body& of_a, const Shape& b, const Body& of_b, double duration = 1,
                      std::uint32_t most_rounds = 1024) {
  abut_impact_options options;
  abut_impact_options_init(&options, sizeof options);
  options.most_rounds = most_rounds;
  abut_impact out{};
  EXPECT_EQ(abut_pair_time_of_impact(a, &of_a.start, &of_a.movement, b, &of_b.start, &of_b.movement, duration, &options,
                                     &out),
            ABUT_OK);
  return out;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) { testing::Test::RecordProperty("seed", static_cast<int>(seed)); }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  abut_vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  abut_pose pose(const abut_vec3& place) {
    const abut_vec3 v = vector(1);
    const double w = number(0.1, 1), size = std::sqrt(w * w + v.x * v.x + v.y * v.y + v.z * v.z);
    return {place, {w / size, v.x / size, v.y / size, v.z / size}};
  }

 private:
  std::mt19937 engine_;
};

std::vector<Pair> extreme_pairs() {
  std::vector<Pair> pairs;
  pairs.push_back({"giant and speck", make_box(1e3, 1e3, 1e3), make_sphere(1e-3), 2e3});
  pairs.push_back({"two sheets", make_box(1, 1, 1e-6), make_box(1, 1, 1e-6), 3});
  pairs.push_back({"two needles", make_capsule(1e-4, 1), make_capsule(1e-4, 1), 2});
  pairs.push_back({"needle and sheet", make_capsule(1e-4, 1), make_box(1, 1, 0), 3});
  pairs.push_back({"propeller and ball", make_box(2, 0.1, 0.02), make_sphere(0.05), 2});
  return pairs;
}

void judge(const Pair& pair, const Body& of_a, const Body& of_b, const abut_impact& found) {
  const auto gap = [&](double time) {
    const abut_pose a = at_time(of_a, time), b = at_time(of_b, time);
    abut_distance out{};
    EXPECT_EQ(abut_pair_distance(pair.a, &a, pair.b, &b, nullptr, &out), ABUT_OK);
    return out;
  };
  const double tolerance = 1e-11 * pair.size;
  for (int k = 0; k < 64; ++k) {
    EXPECT_GT(gap(found.lower * k / 64).upper, -tolerance) << pair.name;
  }
  EXPECT_LE(found.lower, found.upper) << pair.name;
  if (found.state == ABUT_IMPACT_TOUCHES) {
    EXPECT_LE(gap(found.upper).lower, tolerance) << pair.name;
  }
}

void same_when_swapped(const Pair& pair, const Body& of_a, const Body& of_b, const abut_impact& found) {
  const abut_impact swapped = impact_of(pair.b, of_b, pair.a, of_a);
  EXPECT_EQ(swapped.state, found.state) << pair.name;
  EXPECT_NEAR(swapped.lower, found.lower, 1e-9) << pair.name;
  EXPECT_NEAR(swapped.upper, found.upper, 1e-9) << pair.name;
}

// Slow touches lose digits.
void same_in_two_halves(const Pair& pair, const Body& of_a, const Body& of_b, const abut_impact& found) {
  const abut_impact early = impact_of(pair.a, of_a, pair.b, of_b, 0.5);
  if (early.state != ABUT_IMPACT_APART) {
    EXPECT_EQ(early.state, found.state) << pair.name;
    EXPECT_NEAR(early.upper, found.upper, 1e-6) << pair.name;
    return;
  }
  const abut_impact late =
      impact_of(pair.a, {at_time(of_a, 0.5), of_a.movement}, pair.b, {at_time(of_b, 0.5), of_b.movement}, 0.5);
  EXPECT_EQ(late.state, found.state) << pair.name;
  EXPECT_NEAR(0.5 + late.upper, found.upper, 1e-6) << pair.name;
}

// Two needles that pass within their width take 4,745 rounds: with the default rounds one answer of 500 is undecided.
TEST(ImpactExtremes, HoldForExtremeShapesThatSpin) {
  Random random(31);
  int undecided = 0;
  for (const Pair& pair : extreme_pairs()) {
    int touches = 0;
    for (int i = 0; i < 100; ++i) {
      const double way = pair.size * random.number(0.5, 2);
      const Body of_a{random.pose({0, 0, 0}), moving({0, 0, 0}, random.vector(6))};
      const Body of_b{random.pose({pair.size, 0, 0}),
                      moving(abut_vec3{-way, 0, 0} + random.vector(0.3 * way), random.vector(6))};
      const abut_impact found = impact_of(pair.a, of_a, pair.b, of_b);
      touches += found.state == ABUT_IMPACT_TOUCHES ? 1 : 0;
      judge(pair, of_a, of_b, found);
      same_when_swapped(pair, of_a, of_b, found);
      if (found.state == ABUT_IMPACT_UNDECIDED) {
        ++undecided;
        EXPECT_NE(impact_of(pair.a, of_a, pair.b, of_b, 1, 10'000).state, ABUT_IMPACT_UNDECIDED) << pair.name;
      } else {
        same_in_two_halves(pair, of_a, of_b, found);
      }
    }
    EXPECT_GT(touches, 0) << pair.name;
  }
  EXPECT_LE(undecided, 1);
}

// A box slides along the top of another one, above it by a gap: it never comes nearer.
TEST(ImpactExtremes, StayApartAlongAFace) {
  const Shape box = make_box(1, 1, 1);
  for (const double gap : {1e-9, 1e-6, 1e-3, 1.0}) {
    const Body ground{{{0, 0, 0}, {1, 0, 0, 0}}, {}};
    const Body slides{{{-3, 0.1, 2 + gap}, {1, 0, 0, 0}}, moving({6, 0, 0}, {0, 0, 0})};
    EXPECT_EQ(impact_of(box, ground, box, slides).state, ABUT_IMPACT_APART) << gap;
  }
}

// Both move together, and turn nothing.
TEST(ImpactExtremes, StayApartWithoutRelativeMotion) {
  for (const Pair& pair : extreme_pairs()) {
    const abut_movement same = moving({1e3, -7, 0.1}, {0, 0, 0});
    const abut_pose near{{0, 0, 0}, {1, 0, 0, 0}}, far{{2 * pair.size, 0, 0}, {1, 0, 0, 0}};
    const abut_impact found = impact_of(pair.a, {near, same}, pair.b, {far, same});
    EXPECT_EQ(found.state, ABUT_IMPACT_APART) << pair.name;
    EXPECT_EQ(found.lower, 1) << pair.name;
  }
}

}  // namespace
