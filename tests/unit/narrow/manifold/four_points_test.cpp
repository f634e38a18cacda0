// SPDX-License-Identifier: Apache-2.0
// No corner of the hull of a patch is passed over, and of a crowd most others are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.narrow.manifold.four_points;

namespace {

using abut::Vec2;

// By all lines through two points: a corner of the hull lies on one that has no points on its left.
std::vector<std::uint32_t> corners_of(const std::vector<Vec2>& points) {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const bool is_corner = std::ranges::any_of(points, [&](const Vec2& other) {
      const Vec2 way = other - points[i];
      return (way.x != 0 || way.y != 0) &&
             std::ranges::none_of(points, [&](const Vec2& third) { return cross(way, third - points[i]) > 1e-14; });
    });
    if (is_corner) {
      corners.push_back(i);
    }
  }
  return corners;
}

using Maker = std::function<Vec2(test::Random&)>;

// How many of all points are kept. Checks that no corner is missing.
double share_kept(const Maker& make, std::size_t count, std::uint64_t seed) {
  test::Random random(seed);
  std::size_t kept = 0;
  constexpr std::size_t rounds = 100;
  for (std::size_t round = 0; round < rounds; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back(make(random));
    }
    const abut::Places places = abut::places_outside(points);
    EXPECT_TRUE(std::ranges::is_sorted(places.span()));
    EXPECT_TRUE(std::ranges::includes(places.span(), corners_of(points)));
    kept += places.size();
  }
  return static_cast<double>(kept) / static_cast<double>(rounds * count);
}

Vec2 in_a_square(test::Random& random) { return {random.uniform(-1, 1), random.uniform(-1, 1)}; }
Vec2 in_a_strip(test::Random& random) {
  const double along = random.uniform(-1, 1);
  return {along, 0.3 * along + random.uniform(-1e-6, 1e-6)};
}
Vec2 on_a_grid(test::Random& random) { return {std::floor(random.uniform(-2, 3)), std::floor(random.uniform(-2, 3))}; }
Vec2 on_a_circle(test::Random& random) {
  const double angle = random.uniform(0, 2 * std::numbers::pi);
  return {std::cos(angle), std::sin(angle)};
}
Vec2 on_a_line(test::Random& random) { return {random.uniform(-1, 1), 2}; }

TEST(PlacesOutside, HoldAllCornersOfTheHull) {
  for (const std::size_t count : {1u, 2u, 3u, 4u, 5u, 9u, 80u}) {
    for (const Maker& make : {Maker(in_a_square), Maker(in_a_strip), Maker(on_a_grid), Maker(on_a_circle)}) {
      share_kept(make, count, 271 + count);
    }
  }
}

TEST(PlacesOutside, LeaveOutMostOfACrowd) {
  EXPECT_LT(share_kept(in_a_square, 80, 272), 0.4);
  EXPECT_EQ(share_kept(on_a_circle, 8, 273), 1.0);
}

TEST(PlacesOutside, AreAllPointsOfALine) { EXPECT_EQ(share_kept(on_a_line, 20, 274), 1.0); }

}  // namespace
