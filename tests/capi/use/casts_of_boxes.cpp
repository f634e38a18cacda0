// SPDX-License-Identifier: Apache-2.0
// Boxes that move: when they first touch, beside their distances on the way.
#include <algorithm>
#include <cmath>
#include <random>

#include "support.hpp"

namespace {

using namespace abut_test;

struct Flight {
  Shape a, b;
  abut_pose from_a, from_b;
  abut_vec3 by_a, by_b;

  abut_pose a_at(double fraction) const { return moved(from_a, by_a, fraction); }
  abut_pose b_at(double fraction) const { return moved(from_b, by_b, fraction); }
  double gap(double fraction) const { return distance_of(a, a_at(fraction), b, b_at(fraction)); }

 private:
  static abut_pose moved(abut_pose pose, const abut_vec3& by, double fraction) {
    pose.position.x += fraction * by.x;
    pose.position.y += fraction * by.y;
    pose.position.z += fraction * by.z;
    return pose;
  }
};

abut_quat turn(std::mt19937_64& random, bool is_square) {
  if (is_square) {
    // Quarter turns, so that faces and edges are parallel.
    constexpr double half = 0.70710678118654752;
    constexpr std::array<abut_quat, 4> turns{
        {{1, 0, 0, 0}, {half, half, 0, 0}, {half, 0, half, 0}, {half, 0, 0, half}}};
    return turns.at(random() % turns.size());
  }
  std::normal_distribution<double> normal;
  const abut_quat q{normal(random), normal(random), normal(random), normal(random)};
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

Flight random_flight(std::mt19937_64& random, bool is_square) {
  std::uniform_real_distribution<double> place(-2, 2), size(0.1, 1);
  return {make_box(size(random), size(random), size(random)),
          make_box(size(random), size(random), size(random)),
          {{place(random), place(random), place(random)}, turn(random, is_square)},
          {{place(random), place(random), place(random)}, turn(random, is_square)},
          {2 * place(random), place(random), place(random)},
          {place(random), 2 * place(random), place(random)}};
}

abut_cast_hit cast(const Flight& flight, std::uint32_t& found) {
  abut_cast_hit hit{};
  require(abut_pair_cast(flight.a, &flight.from_a, &flight.by_a, flight.b, &flight.from_b, &flight.by_b, nullptr, &hit,
                         &found));
  return hit;
}

void expect_touch(const Flight& flight, const abut_cast_hit& hit) {
  constexpr double rounding = 1e-13;
  EXPECT_NEAR(flight.gap(hit.fraction), 0, rounding);
  EXPECT_NEAR(hit.contact.distance, 0, rounding);
  const abut_vec3 &a = hit.contact.point_a, &b = hit.contact.point_b, &n = hit.contact.normal;
  EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z), 0, 1e-12);
  EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1, 1e-12);
  // Each point is on its box.
  const Shape speck = make_of_kind("point", {});
  EXPECT_NEAR(distance_of(speck, at(a.x, a.y, a.z), flight.a, flight.a_at(hit.fraction)), 0, 1e-12);
  EXPECT_NEAR(distance_of(speck, at(b.x, b.y, b.z), flight.b, flight.b_at(hit.fraction)), 0, 1e-12);
  // The normal leads from a to b, against the motion of b relative to a.
  const abut_vec3 by{flight.by_b.x - flight.by_a.x, flight.by_b.y - flight.by_a.y, flight.by_b.z - flight.by_a.z};
  EXPECT_LE(by.x * n.x + by.y * n.y + by.z * n.z, 1e-9);
}

TEST(CastOfBoxes, FindsTheFirstTouchAndMissesNone) {
  constexpr int samples = 100;
  std::size_t hits = 0, misses = 0;
  for (const bool is_square : {false, true}) {
    std::mt19937_64 random(17);
    for (int i = 0; i < 1500; ++i) {
      const Flight flight = random_flight(random, is_square);
      std::uint32_t found = 0;
      const abut_cast_hit hit = cast(flight, found);
      if (flight.gap(0) <= 0) {
        EXPECT_EQ(found, 1U);
        EXPECT_EQ(hit.fraction, 0.0);
        continue;
      }
      if (found != 0) {
        ++hits;
        expect_touch(flight, hit);
      } else {
        ++misses;
      }
      const double end = found != 0 ? hit.fraction * (1 - 1e-9) : 1;
      for (int k = 0; k < samples; ++k) EXPECT_GT(flight.gap(end * k / samples), 0.0) << i;
    }
  }
  EXPECT_GT(hits, 250U);
  EXPECT_GT(misses, 300U);
}

TEST(CastOfBoxes, SlidingAlongAFaceTouchesFromTheStart) {
  const Flight flight{make_box(1, 1, 1), make_box(1, 1, 1), identity, at(0, 0, 2), {0, 0, 0}, {3, 0, 0}};
  std::uint32_t found = 0;
  const abut_cast_hit hit = cast(flight, found);
  EXPECT_EQ(found, 1U);
  EXPECT_EQ(hit.fraction, 0.0);
}

TEST(CastOfBoxes, PassesAtTheLeastDistance) {
  const Flight flight{make_box(1, 1, 1), make_box(1, 1, 1), identity, at(-5, 0, 2 + 1e-9), {0, 0, 0}, {10, 0, 0}};
  std::uint32_t found = 1;
  (void)cast(flight, found);
  EXPECT_EQ(found, 0U);
}

TEST(CastOfBoxes, EndsWhereTheyMeetFaceToFace) {
  const Flight flight{make_box(1, 1, 1), make_box(0.5, 0.5, 0.5), identity, at(0, 0, 4), {0, 0, 0}, {0, 0, -5}};
  std::uint32_t found = 0;
  const abut_cast_hit hit = cast(flight, found);
  ASSERT_EQ(found, 1U);
  EXPECT_NEAR(hit.fraction, 0.5, 1e-15);
  EXPECT_NEAR(hit.contact.normal.z, 1, 1e-15);
  expect_touch(flight, hit);
}

}  // namespace
