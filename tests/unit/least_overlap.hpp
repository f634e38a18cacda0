// SPDX-License-Identifier: Apache-2.0
// How deep bodies overlap, by trying directions: what the depths along few proven ones are held against.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

import abut.math;

namespace test {

// A body of revolution around Z, whatever the modules under test think of it.
struct Solid {
  abut::Real radius, half_height;
  bool is_cone;

  [[nodiscard]] abut::Real reach(const abut::Vec3& d) const {
    // Not by std::hypot, which is for numbers that are much larger or smaller and takes most of the time of a search.
    const abut::Real base = radius * std::sqrt(d.x * d.x + d.y * d.y) + half_height * (is_cone ? -d.z : std::fabs(d.z));
    return is_cone ? std::max(base, half_height * d.z) : base;
  }
};

// All over the sphere.
inline std::vector<abut::Vec3> make_directions() {
  constexpr int count = 3000;
  const abut::Real golden = std::numbers::pi * (3 - std::sqrt(abut::Real{5}));
  std::vector<abut::Vec3> directions;
  for (int i = 0; i < count; ++i) {
    const abut::Real z = 1 - (2 * i + 1) / abut::Real(count), side = std::sqrt(1 - z * z);
    directions.push_back({side * std::cos(golden * i), side * std::sin(golden * i), z});
  }
  return directions;
}

// All around, as cosine and sine.
inline std::vector<std::pair<abut::Real, abut::Real>> make_turns() {
  std::vector<std::pair<abut::Real, abut::Real>> turns;
  for (int around = 0; around < 16; ++around) {
    const abut::Real angle = std::numbers::pi * around / 8;
    turns.emplace_back(std::cos(angle), std::sin(angle));
  }
  return turns;
}

// The least overlap of directions all over the sphere, and of those that a search by ever smaller steps reaches from
// them: never less than the truth. `overlap` takes a direction of any length.
template <class Overlap>
abut::Real least_overlap(const Overlap& overlap) {
  using abut::Real;
  using abut::Vec3;
  constexpr int kept = 12;
  static const std::vector<Vec3> directions = make_directions();
  static const std::vector<std::pair<Real, Real>> turns = make_turns();
  std::vector<std::pair<Real, Vec3>> tried;
  tried.reserve(directions.size());
  for (const Vec3& d : directions) {
    tried.emplace_back(overlap(d), d);
  }
  std::ranges::partial_sort(tried, tried.begin() + kept, {}, [](const auto& one) { return one.first; });
  Real least = tried[0].first;
  for (int i = 0; i < kept; ++i) {
    auto [here, d] = tried[static_cast<std::size_t>(i)];
    for (Real step = 0.1; step > 1e-8; step /= 2) {
      for (bool is_lower = true; is_lower;) {
        is_lower = false;
        const abut::Tangents across = abut::tangents_of(d);
        for (const auto& [cosine, sine] : turns) {
          const Vec3 next = d + step * (cosine * across.first + sine * across.second);
          const Real value = overlap(next);
          if (value < here - 1e-14) {
            here = value;
            d = (1 / norm(next)) * next;
            is_lower = true;
            break;
          }
        }
      }
    }
    least = std::min(least, here);
  }
  return least;
}

// A depth with a direction and a lower bound, of bodies that overlap by `least` as the search above found.
template <class Depth, class Overlap>
void expect_least(const Depth& found, abut::Real least, abut::Real error, const Overlap& overlap, int number) {
  EXPECT_NEAR(norm(found.normal), 1, 1e-15) << number;
  EXPECT_NEAR(overlap(found.normal), found.depth, 1e-13) << number;
  EXPECT_LE(found.depth, least + error) << number;
  EXPECT_LE(found.lower, least + 1e-13) << number;
  EXPECT_LE(found.depth - found.lower, error) << number;
}

}  // namespace test
