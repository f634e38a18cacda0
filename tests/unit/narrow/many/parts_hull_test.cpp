// SPDX-License-Identifier: Apache-2.0
// The shortest way out of the hull of parts. Directions all over the sphere are tried, and none has less depth. The
// corners of all triangles tell the depth.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../least_overlap.hpp"
#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.capability.second_order;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.many.parts_hull;
import abut.narrow.many.parts_met;
import abut.narrow.many.triangle_contacts;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cone;
import abut.shapes.cylinder;

namespace {

using abut::Fronts;
using abut::Pose;
using abut::Real;
using abut::Triangle;
using abut::Vec3;

constexpr Real deep = -1, ahead = 0.5;  // how far parts are apart
constexpr Real noise = 1e-12;           // of depths
constexpr abut::PartingWay no_way{-1, {0, 0, 0}};

Vec3 random_direction(test::Random& random) {
  return abut::UnitVec3::make(random.point(1)).value_or(abut::UnitVec3::axis_z());
}
Real highest(const std::vector<Vec3>& corners, const Vec3& direction) {
  Real most = -abut::infinity;
  for (const Vec3& corner : corners) {
    most = std::fmax(most, dot(direction, corner));
  }
  return most;
}
std::vector<Vec3> corners_of(const Triangle& triangle, const Pose& pose) {
  return {pose * triangle.corners()[0], pose * triangle.corners()[1], pose * triangle.corners()[2]};
}

// With a front, or with none. All fronts leave ways up.
Triangle random_triangle(test::Random& random, std::uint32_t number, bool has_front) {
  const Vec3 near = random.point(0.7), p = near + random.point(1), q = near + random.point(1),
             r = near + random.point(1);
  const bool is_up = cross(q - p, r - p).z > 0;
  return {p, is_up ? q : r, is_up ? r : q, number, has_front};
}

// A part of a surface and what it meets, by the corners of the triangle and how far the other side reaches.
template <class ReachOfB>
struct Part {
  std::vector<Vec3> corners;
  ReachOfB reach_of_b;
  std::vector<Vec3> fronts;
};

// How far b has to move along a direction of any length.
template <class Parts>
Real depth_along(const Parts& parts, const Vec3& direction, Real allowed) {
  const Real length = norm(direction);
  Real depth = -abut::infinity;
  for (const auto& part : parts) {
    for (const Vec3& front : part.fronts) {
      if (dot(direction, front) < -allowed * length) {
        return abut::infinity;
      }
    }
    depth = std::fmax(depth, highest(part.corners, direction) + part.reach_of_b(-direction));
  }
  return depth / length;
}

// The way is as long as it is told, and no other that was tried is shorter.
template <class WayOut, class Parts>
Real expect_shortest(const WayOut& way_out, const Parts& parts, Real error) {
  const auto strictly = [&](const Vec3& d) { return depth_along(parts, d, 0); };
  const Real least = test::least_overlap(strictly);
  if (!(least > 0.01 && least < 100)) {
    return 0;
  }
  const std::optional<abut::PartingWay> way = way_out(abut::infinity);
  EXPECT_TRUE(way.has_value());
  if (!way) {
    return 0;
  }
  EXPECT_NEAR(norm(way->direction), 1, noise);
  EXPECT_NEAR(depth_along(parts, way->direction, 1e-12), way->depth, error);
  EXPECT_LE(way->depth, least + error);
  EXPECT_FALSE(way_out(0.99 * way->depth).has_value());
  const std::optional<abut::PartingWay> again = way_out(1.01 * way->depth);
  EXPECT_TRUE(again.has_value());
  EXPECT_NEAR(again ? again->depth : 0, way->depth, error);
  return least;
}

// Half of the scenes have fronts. Returns how many were judged.
template <class B, class ReachOfB>
int expect_shortest_ways(const B& b, const ReachOfB& reach_in_its_frame, Real error) {
  int judged = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Pose ab{random.rotation(), random.point(0.3)};
    const auto reach = [&](const Vec3& d) { return dot(d, ab.position) + reach_in_its_frame(ab.rotation.undo(d)); };
    abut::PartsMet<B> met;
    std::vector<Part<decltype(reach)>> parts;
    for (std::uint32_t i = 0; i < 3 + seed % 7; ++i) {
      const Triangle triangle = random_triangle(random, i, seed % 2 == 0 && random.uniform(0, 1) < 0.7);
      const std::size_t part = met.add(triangle, b, ab, Fronts<B>(triangle, b, ab), noise);
      met.put_in_the_way(part, deep, {0, 0, 1});
      parts.push_back({corners_of(triangle, Pose::identity()), reach,
                       triangle.is_one_sided() ? std::vector<Vec3>{triangle.normal()} : std::vector<Vec3>{}});
    }
    const Real extent = b.extent() + largest_magnitude(ab.position);
    const abut::PartsHull<B> hull(met.fours(), extent, seed % 2 == 0);
    judged +=
        expect_shortest([&](Real most) { return hull.way_out(met.fours(), b, ab, most, noise); }, parts, error) > 0 ? 1
                                                                                                                    : 0;
  }
  return judged;
}

TEST(PartsHull, ABoxLeavesByTheShortestWay) {
  const Vec3 half{0.8, 0.5, 0.3};
  const auto reach = [&](const Vec3& d) { return dot(half, abut::absolute(d)); };
  EXPECT_GT(expect_shortest_ways(test::made<abut::Box>({half.x, half.y, half.z}), reach, 1e-9), 40);
}
TEST(PartsHull, CurvedBodiesLeaveByTheShortestWay) {
  const test::Solid cylinder{0.6, 0.4, false}, cone{0.6, 0.7, true};
  EXPECT_GT(expect_shortest_ways(
                test::made<abut::Cylinder>({0.6, 0.4}), [&](const Vec3& d) { return cylinder.reach(d); }, 1e-8),
            40);
  EXPECT_GT(
      expect_shortest_ways(test::made<abut::Cone>({0.6, 0.7}), [&](const Vec3& d) { return cone.reach(d); }, 1e-8), 40);
}
// The segment inside may be apart from what the ball around its points overlaps.
TEST(PartsHull, ARoundBodyLeavesByTheShortestWay) {
  for (const Real radius : {0.1, 2.0}) {
    const auto reach = [&](const Vec3& d) { return 0.5 * std::fabs(d.z) + radius * norm(d); };
    EXPECT_GT(expect_shortest_ways(test::made<abut::Capsule>({radius, 0.5}), reach, 1e-8), 20);
  }
}
struct ReachOfCorners {
  std::vector<Vec3> corners;
  Real operator()(const Vec3& d) const { return highest(corners, d); }
};

TEST(PartsHull, TwoSurfacesLeaveByTheShortestWay) {
  int judged = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    const Pose ab{random.rotation(), random.point(0.3)};
    abut::PartsMet<Triangle> met;
    std::vector<Part<ReachOfCorners>> parts;
    for (std::uint32_t i = 0; i < 3 + seed % 7; ++i) {
      const Triangle a = random_triangle(random, i, seed % 2 == 0), b = random_triangle(random, i, false);
      met.put_in_the_way(met.add(a, b, ab, Fronts<Triangle>(a, b, ab), noise), deep, {0, 0, 1});
      parts.push_back({corners_of(a, Pose::identity()),
                       {corners_of(b, ab)},
                       seed % 2 == 0 ? std::vector<Vec3>{a.normal()} : std::vector<Vec3>{}});
    }
    const abut::PartsHull<Triangle> hull(met.fours(), 0, true);
    const auto way_out = [&](Real most) {
      return hull.way_out(met.fours(), Triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, false), ab, most, noise);
    };
    judged += expect_shortest(way_out, parts, 1e-9) > 0 ? 1 : 0;
  }
  EXPECT_GT(judged, 40);
}

// Behind the fronts of two slopes a hull goes on far, and its faces are as far off as their corners are.
TEST(PartsHull, LeavesFromBehindTwoSlopesByTheShortestWay) {
  const Pose ab{abut::Rotation::identity(), {-0.65382350679516754, 1.2807815236349616, -0.67428998915253457}};
  const Real x = 0.55565429156393209, y = 0.8588363248113513, z = 0.43285887740144613;
  const Real wide = 0.80069801087188774, long_side = 0.60783872468134414;
  const Vec3 top{x, y, 2 * z};
  const std::array<Triangle, 2> slope{Triangle{top, {2 * x, y, z}, {2 * x, 2 * y, -2 * z}, 0, true},
                                      Triangle{top, {2 * x, 2 * y, -2 * z}, {x, 2 * y, -z}, 1, true}};
  const auto flat = [&](Real begin, bool is_near) {
    const Vec3 corner{begin * wide, 0, 0}, across{(begin + 1) * wide, long_side, 0};
    const Vec3 side = is_near ? Vec3{across.x, 0, 0} : Vec3{corner.x, across.y, 0};
    return Triangle{corner, is_near ? side : across, is_near ? across : side, 0, true};
  };
  const std::array<std::pair<Triangle, Triangle>, 4> pairs{
      {{slope[1], flat(2, false)}, {slope[0], flat(2, false)}, {slope[1], flat(1, true)}, {slope[0], flat(2, true)}}};
  abut::PartsMet<Triangle> met;
  std::vector<Part<ReachOfCorners>> parts;
  for (const auto& [a, b] : pairs) {
    met.put_in_the_way(met.add(a, b, ab, Fronts<Triangle>(a, b, ab), noise), deep, {0, 0, 1});
    parts.push_back({corners_of(a, Pose::identity()), {corners_of(b, ab)}, {a.normal(), -b.normal()}});
  }
  const abut::PartsHull<Triangle> hull(met.fours(), 0, true);
  const auto way_out = [&](Real most) { return hull.way_out(met.fours(), slope[0], ab, most, noise); };
  EXPECT_NEAR(expect_shortest(way_out, parts, 1e-9), 0.400672034, 1e-6);
}

// What lies ahead is no part until it is taken in. What b only touches is one, but its front is none until then.
TEST(PartsHull, TakesInWhatLiesAhead) {
  const abut::Box box = test::made<abut::Box>({1, 1, 1});
  const Pose ab{abut::Rotation::identity(), {0, 0, 0.5}};
  const auto floor_at = [](Real z, bool is_upside_down) {
    const Vec3 p{-9, -9, z}, q{9, -9, z}, r{0, 9, z};
    return Triangle{p, is_upside_down ? r : q, is_upside_down ? q : r, 0, true};
  };
  abut::PartsMet<abut::Box> met;
  const auto add = [&](const Triangle& triangle, Real gap) {
    met.put_in_the_way(met.add(triangle, box, ab, Fronts<abut::Box>(triangle, box, ab), noise), gap, {0, 0, 1});
  };
  add(floor_at(0, false), deep);
  add(floor_at(2, false), ahead);
  add(floor_at(0.1, true), 0);
  const auto way_out = [&](const abut::PartsHull<abut::Box>& hull) {
    return hull.way_out(met.fours(), box, ab, 100, noise);
  };
  abut::PartsHull<abut::Box> hull(met.fours(), 2, true);
  EXPECT_NEAR(way_out(hull).value_or(no_way).depth, 0.6, 1e-9);  // above what is touched
  EXPECT_TRUE(hull.take(0, 2));
  EXPECT_NEAR(way_out(hull).value_or(no_way).depth, 2.5, 1e-9);
  EXPECT_FALSE(hull.take(0, 2));
  EXPECT_TRUE(hull.take(0, 4));
  const std::optional<abut::PartingWay> way = way_out(hull);  // between the fronts
  EXPECT_GT(way.value_or(no_way).depth, 5);
  EXPECT_NEAR(way.value_or(no_way).direction.z, 0, noise);
}

// To second order a hull has a support point, and edges over the nearest creases, the nearest one first. Just beyond
// that, the end of its edge is the support point, and just before it is not.
TEST(PartsHull, TheNearestCreaseLeadsToTheNextSupportPoint) {
  const abut::Box box = test::made<abut::Box>({1, 1, 1});
  const Pose ab = Pose::identity();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    abut::PartsMet<abut::Box> met;
    for (std::uint32_t i = 0; i < 8; ++i) {
      const Triangle triangle = random_triangle(random, i, seed % 2 == 0);
      met.put_in_the_way(met.add(triangle, box, ab, Fronts<abut::Box>(triangle, box, ab), noise), deep, {0, 0, 1});
    }
    abut::PartsHull<abut::Box> hull(met.fours(), 2, true);
    if (seed % 3 == 0) {
      hull.hold(random_direction(random));
    }
    const auto support = [&](const Vec3& d) {
      return hull.support_pair(met.fours(), d, [](const Vec3&) { return Vec3{}; }).a;
    };
    const abut::DirectionFrame frame = abut::frame_along(random_direction(random));
    const Vec3 top = support(frame.n);
    const abut::SecondOrder near = hull.second_order(met.fours(), frame, top);
    ASSERT_EQ(near.edge_count, 3u);
    const auto tangent = [&](std::size_t i) { return -near.edges[i].n / std::hypot(near.edges[i].x, near.edges[i].y); };
    EXPECT_LE(tangent(0), tangent(1));
    EXPECT_LE(tangent(1), tangent(2));
    const abut::InFrame& edge = near.edges[0];
    const Real share = tangent(0) / std::hypot(edge.x, edge.y);
    const auto beside = [&](Real times) {
      return support(frame.n + times * share * (edge.x * frame.x + edge.y * frame.y));
    };
    EXPECT_LT(norm(beside(1 - 1e-6) - top), 1e-9);
    EXPECT_LT(norm(beside(1 + 1e-6) - top - edge.n * frame.n - edge.x * frame.x - edge.y * frame.y), 1e-9);
  }
}

}  // namespace
