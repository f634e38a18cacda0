// SPDX-License-Identifier: Apache-2.0
// The shortest of some ways out of all parts, and what stands in a way: all corners, asked one by one, judge both.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.many.parts_met;
import abut.narrow.many.triangle_contacts;
import abut.shapes.box;

namespace {

using abut::Box;
using abut::Fronts;
using abut::Pose;
using abut::Real;
using abut::Triangle;
using abut::Vec3;

constexpr Real deep = -1;     // how far parts are apart that overlap
constexpr Real noise = 1e-9;  // of depths

Real highest(const std::vector<Vec3>& corners, const Vec3& direction) {
  Real most = -abut::infinity;
  for (const Vec3& corner : corners) {
    most = std::fmax(most, dot(direction, corner));
  }
  return most;
}

// A part of a surface and what it meets, by the corners of both in one frame.
struct Part {
  std::vector<Vec3> of_a, of_b;
};

// Answers for four directions what is told for one.
template <class OfOne>
auto for_four(const OfOne& of_one) {
  return [of_one](const abut::Columns& directions) {
    return abut::Lanes{of_one(directions[0]), of_one(directions[1]), of_one(directions[2]), of_one(directions[3])};
  };
}

Real depth_along(const std::vector<Part>& parts, const Vec3& direction) {
  Real depth = 0;
  for (const Part& part : parts) {
    depth = std::fmax(depth, highest(part.of_a, direction) + highest(part.of_b, -direction));
  }
  return depth;
}
Real least_depth(const std::vector<Part>& parts, const std::vector<Vec3>& ways) {
  Real least = abut::infinity;
  for (const Vec3& way : ways) {
    least = std::fmin(least, depth_along(parts, way));
  }
  return least;
}

Vec3 random_direction(test::Random& random) {
  for (;;) {
    if (const auto direction = abut::UnitVec3::make(random.point(1))) {
      return *direction;
    }
  }
}
Triangle random_triangle(test::Random& random, std::uint32_t number) {
  const Vec3 near = random.point(1);
  return {near + random.point(1), near + random.point(1), near + random.point(1), number, false};
}
std::vector<Vec3> corners_of(const Triangle& triangle, const Pose& pose) {
  return {pose * triangle.corners()[0], pose * triangle.corners()[1], pose * triangle.corners()[2]};
}

// Out of the face of a triangle, and along its edges.
void add_ways_of(const std::vector<Vec3>& corners, std::vector<Vec3>& ways) {
  const Vec3 &a = corners[0], &b = corners[1], &c = corners[2];
  for (const Vec3& along : {cross(b - a, c - a), b - a, c - b, a - c}) {
    ways.insert(ways.end(), {(1 / norm(along)) * along, (-1 / norm(along)) * along});
  }
}

constexpr auto meets_none = [](const auto&, const abut::PartingWay&) { return std::uint64_t{0}; };

constexpr Vec3 no_way{0, 0, 0};

// Where only ways are wanted that are shorter than the shortest, there is none.
template <class Parts, class LowestAlong>
void expect_shortest(const Parts& met, const LowestAlong& lowest_along, const std::vector<Vec3>& ways,
                     const std::vector<Part>& parts) {
  const Real least = least_depth(parts, ways);
  const auto shortest = [&](Real most) { return met.shortest_of_parts({most, no_way}, lowest_along, meets_none); };
  const abut::PartingWay found = shortest(abut::infinity);
  EXPECT_NEAR(found.depth, least, noise);
  EXPECT_NEAR(depth_along(parts, found.direction), least, noise);
  for (const Real most : {0.5 * least, 0.0}) {
    const abut::PartingWay none = shortest(most);
    EXPECT_EQ(none.depth, most);
    EXPECT_EQ(none.direction, no_way);
  }
}

TEST(PartsMet, ABoxLeavesByTheShortestWayThatIsKnown) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Vec3 half{random.uniform(0.2, 2), random.uniform(0.2, 2), random.uniform(0.2, 2)};
    const Box box = test::made<Box>(std::vector<Real>{half.x, half.y, half.z});
    const Pose ab{random.rotation(), random.point(0.5)};
    abut::PartsMet<Box> met;
    std::vector<Part> parts;
    std::vector<Vec3> ways;
    for (std::uint32_t i = 0; i <= seed % 40; ++i) {
      const Triangle triangle = random_triangle(random, i);
      const Vec3 way = random_direction(random);
      const std::size_t part = met.add(triangle, box, ab, Fronts<Box>(triangle, box, ab), noise);
      met.put_in_the_way(part, deep, way);
      parts.push_back({corners_of(triangle, Pose::identity()), test::corners_of(half, ab)});
      ways.push_back(way);
      add_ways_of(parts.back().of_a, ways);
    }
    const auto lowest = [&](const Vec3& direction) { return -highest(test::corners_of(half, ab), -direction); };
    expect_shortest(met, for_four(lowest), ways, parts);
  }
}

// Each triangle of one surface meets several of the other, so that the same ways come again.
TEST(PartsMet, TwoSurfacesLeaveByTheShortestWayThatIsKnown) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Pose ab{random.rotation(), random.point(0.5)};
    std::vector<Triangle> of_a, of_b;
    for (std::uint32_t i = 0; i < 6; ++i) {
      of_a.push_back(random_triangle(random, i));
      of_b.push_back(random_triangle(random, i));
    }
    abut::PartsMet<Triangle> met;
    std::vector<Part> parts;
    std::vector<Vec3> ways;
    for (const Triangle& a : of_a) {
      for (const Triangle& b : of_b) {
        if (random.uniform(0, 1) < 0.5) {
          continue;
        }
        const Vec3 way = random_direction(random);
        const std::size_t part = met.add(a, b, ab, Fronts<Triangle>(a, b, ab), noise);
        met.put_in_the_way(part, deep, way);
        parts.push_back({corners_of(a, Pose::identity()), corners_of(b, ab)});
        ways.push_back(way);
        add_ways_of(parts.back().of_a, ways);
        add_ways_of(parts.back().of_b, ways);
      }
    }
    expect_shortest(met, for_four([](const Vec3&) { return 0.0; }), ways, parts);
  }
}

// Rounding may have lifted what touches.
TEST(PartsMet, WhatOnlyTouchesNeedsNoWay) {
  constexpr Real lifted = 1e-12;
  const Box box = test::made<Box>(std::vector<Real>{1, 1, 1});
  const Pose ab{abut::Rotation::identity(), {0, 0, 1 + lifted}};
  abut::PartsMet<Box> met;
  const std::vector<Vec3> ways{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0.6, -0.8}};
  for (std::uint32_t i = 0; i < ways.size(); ++i) {
    const Vec3 point{0.1 * i, 0, 0};  // without an area, and so without ways of its own
    const Triangle triangle{point, point, point, i, false};
    const std::size_t part = met.add(triangle, box, ab, Fronts<Box>(triangle, box, ab), noise);
    met.put_in_the_way(part, 0, ways[i]);
  }
  const auto lowest = [](const Vec3& direction) {
    return (1 + lifted) * direction.z - (std::fabs(direction.x) + std::fabs(direction.y) + std::fabs(direction.z));
  };
  const abut::PartingWay found = met.shortest(ways, {1, no_way}, for_four(lowest), meets_none);
  EXPECT_EQ(found.depth, 0);
  EXPECT_EQ(found.direction, (Vec3{0, 0, 1}));
}

// Of floors above each other, those that are met before the end of a way and not left there; of fronts that are
// touched, those against which it leads.
TEST(PartsMet, WhatStandsInAWayIsToldByItsLane) {
  const Box box = test::made<Box>(std::vector<Real>{1, 1, 1});
  const Pose ab = Pose::identity();
  struct Floor {
    Real height, gap;
    bool is_upside_down;
    bool stands_in_the_way;
  };
  // The box begins at -1, and a way of 2 leads up.
  const std::vector<Floor> floors{{0.9, deep, false, false}, {1.5, 0.5, false, true},
                                  {0.5, 0.5, false, false},  {2.5, 1.5, false, true},
                                  {3.5, 2.5, false, false},  {1, 0, true, true},
                                  {1, 0, false, false},      {1.8, abut::infinity, false, false}};
  abut::PartsMet<Box> met;
  for (const Floor& floor : floors) {
    const Vec3 p{-9, -9, floor.height}, q{9, -9, floor.height}, r{0, 9, floor.height};
    const Triangle triangle{p, floor.is_upside_down ? r : q, floor.is_upside_down ? q : r, 0, true};
    const std::size_t part = met.add(triangle, box, ab, Fronts<Box>(triangle, box, ab), noise);
    if (floor.gap < abut::infinity) {
      met.put_in_the_way(part, floor.gap, {0, 0, 1});
    }
  }
  // What is no further away than the way is long.
  const auto meets_on = [](const auto& parts, const abut::PartingWay& way) {
    return abut::bits_of(parts.gap <= abut::all_lanes(way.depth));
  };
  std::vector<bool> found(floors.size(), false);
  met.visit_in_the_way({2, {0, 0, 1}}, -1, meets_on, [&](std::size_t place, std::uint64_t lanes) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if ((lanes >> lane & 1u) != 0) {
        EXPECT_FALSE(found[4 * place + lane]);
        found[4 * place + lane] = true;
      }
    }
  });
  for (std::size_t i = 0; i < floors.size(); ++i) {
    EXPECT_EQ(found[i], floors[i].stands_in_the_way) << i;
  }
}

}  // namespace
