// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "../../hull_of.hpp"
#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.convex.separation;
import abut.narrow.cores.difference;
import abut.narrow.cores.simplex;
import abut.narrow.fan.hull_sat;
import abut.narrow.fan.sat;
import abut.narrow.polytope.epa;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.hull;
import abut.shapes.sphere;
import abut.shapes.triangle;

namespace {

using abut::Hull;
using abut::Pose;
using abut::Vec3;
using test::hull_of;
using Points = std::vector<Vec3>;

// The exact depth, in 113 bits: the least overlap along the cross products of any two lines through two points each,
// of either set. Face normals and products of edges are among them.
class ExactDepth {
 public:
  ExactDepth(const Points& a, const Points& b, const Pose& ab) {
    for (const Vec3& p : a) {
      a_.push_back({static_cast<Quad>(p.x), static_cast<Quad>(p.y), static_cast<Quad>(p.z)});
    }
    const abut::Rotation& r = ab.rotation;
    for (const Vec3& p : b) {
      const auto along = [&](double x, double y, double z, double shift) {
        return static_cast<Quad>(x) * static_cast<Quad>(p.x) + static_cast<Quad>(y) * static_cast<Quad>(p.y) +
               static_cast<Quad>(z) * static_cast<Quad>(p.z) + static_cast<Quad>(shift);
      };
      b_.push_back({along(r.x.x, r.y.x, r.z.x, ab.position.x), along(r.x.y, r.y.y, r.z.y, ab.position.y),
                    along(r.x.z, r.y.z, r.z.z, ab.position.z)});
    }
  }
  [[nodiscard]] double find() {
    std::vector<Point> lines = lines_of(a_);
    const std::vector<Point> others = lines_of(b_);
    lines.insert(lines.end(), others.begin(), others.end());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = i + 1; j < lines.size(); ++j) {
        try_along(lines[i], lines[j]);
      }
    }
    return std::sqrt(static_cast<double>(least_));
  }

 private:
  using Quad = __float128;
  using Point = std::array<Quad, 3>;
  static constexpr Quad far = 1 << 30;

  [[nodiscard]] static std::vector<Point> lines_of(const std::vector<Point>& points) {
    std::vector<Point> lines;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        lines.push_back({points[j][0] - points[i][0], points[j][1] - points[i][1], points[j][2] - points[i][2]});
      }
    }
    return lines;
  }
  void try_along(const Point& u, const Point& v) {
    const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const Quad square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (!(square > 0)) {
      return;
    }
    Quad low_a = far, high_a = -far, low_b = far, high_b = -far;
    const auto extend = [&](const std::vector<Point>& points, Quad& low, Quad& high) {
      for (const Point& p : points) {
        const Quad at = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
        low = at < low ? at : low;
        high = at > high ? at : high;
      }
    };
    extend(a_, low_a, high_a);
    extend(b_, low_b, high_b);
    for (const Quad overlap : {high_a - low_b, high_b - low_a}) {
      const Quad depth = overlap > 0 ? overlap * overlap / square : 0;
      least_ = depth < least_ ? depth : least_;
    }
  }

  std::vector<Point> a_, b_;
  Quad least_ = far;
};

Points cloud(std::size_t count, const Vec3& size, test::Random& random) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 p = random.point(1);
    points.push_back({size.x * p.x, size.y * p.y, size.z * p.z});
  }
  return points;
}

// A hull of random form: pebbles, boxes, plates, needles, polygons, prisms, points on a coarse lattice.
Points random_points(int form, test::Random& random) {
  switch (form) {
    case 0: return cloud(9, {1, 1, 1}, random);
    case 1: return test::corners_of({0.5, 0.25, 1}, Pose::identity());
    case 2: return cloud(8, {1, 1, 1e-3}, random);
    case 3: return cloud(8, {2, 1e-3, 1e-3}, random);
    case 4: return cloud(7, {1, 1, 0}, random);
    case 5: {
      Points points;
      for (int i = 0; i < 5; ++i) {
        const double angle = 2 * std::numbers::pi * i / 5;
        points.push_back({std::cos(angle), std::sin(angle), -0.5});
        points.push_back({std::cos(angle), std::sin(angle), 0.5});
      }
      return points;
    }
    default: {
      Points points = cloud(9, {2, 2, 2}, random);
      for (Vec3& p : points) {
        p = {std::round(p.x), std::round(p.y), std::round(p.z)};
      }
      points.push_back(points[0]);
      return points;
    }
  }
}
constexpr int forms = 7;

// Turned at random, or such that faces and edges are parallel.
Pose random_pose(int i, test::Random& random) {
  if (i % 4 == 3) {
    const Vec3 p = random.point(1.5);
    return {abut::Rotation::identity(),
            {0.5 * std::round(2 * p.x), 0.5 * std::round(2 * p.y), 0.5 * std::round(2 * p.z)}};
  }
  return {random.rotation(), random.point(i % 4 == 2 ? 0.01 : 0.7)};
}

constexpr double noise = 1e-13;

// The overlap along the normal is the one promised, and no direction has less.
template <class A, class B>
bool expect_least(const A& a, const B& b, const Points& points_a, const Points& points_b, const Pose& ab) {
  const std::optional<abut::SatResult> found = abut::hull_sat(a, b, ab, noise);
  if (!found) {
    return false;
  }
  Points placed;
  for (const Vec3& p : points_b) {
    placed.push_back(ab * p);
  }
  EXPECT_NEAR(norm(found->normal), 1, 1e-14);
  EXPECT_NEAR(test::corners_overreach(points_a, placed, found->normal, found->separation), 0, noise);
  if (found->separation < 0) {
    EXPECT_NEAR(-found->separation, ExactDepth(points_a, points_b, ab).find(), noise);
    return true;
  }
  return false;
}

TEST(HullSat, TwoHullsHaveTheExactDepth) {
  test::Random random(301);
  int deep = 0;
  for (int i = 0; i < 2 * forms * forms; ++i) {
    SCOPED_TRACE(i);
    const Points a = random_points(i % forms, random), b = random_points(i / forms % forms, random);
    deep += expect_least(hull_of(a), hull_of(b), a, b, random_pose(i, random)) ? 1 : 0;
  }
  EXPECT_GT(deep, 50);
}

// A polygon turns round half a circle at its edges; the height of what lies in its plane is zero at both ends.
TEST(HullSat, PolygonsInThePlaneOfTheMiddle) {
  test::Random random(307);
  int deep = 0;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Points a = random_points(4, random), b = random_points(i % 2 == 0 ? 1 : 5, random);
    const Pose ab{abut::Rotation::identity(), {random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), 0}};
    deep += expect_least(hull_of(a), hull_of(b), a, b, ab) ? 1 : 0;
  }
  EXPECT_GT(deep, 20);
}

TEST(HullSat, BoxesInHullsEitherWayRound) {
  test::Random random(302);
  int deep = 0;
  for (int i = 0; i < 5 * forms; ++i) {
    SCOPED_TRACE(i);
    const Vec3 half = i % 3 == 0 ? Vec3{0.5, 0.8, 0} : abut::absolute(random.point(1)) + Vec3{0.05, 0.05, 0.05};
    const auto box = test::made<abut::Box>({half.x, half.y, half.z});
    const Points corners = test::corners_of(half, Pose::identity()), points = random_points(i % forms, random);
    const Pose pose = random_pose(i, random);
    deep += expect_least(box, hull_of(points), corners, points, pose) ? 1 : 0;
    deep += expect_least(hull_of(points), box, points, corners, pose) ? 1 : 0;
  }
  EXPECT_GT(deep, 25);
}

TEST(HullSat, RodsAndPointsInHulls) {
  test::Random random(303);
  int deep = 0;
  for (int i = 0; i < 5 * forms; ++i) {
    SCOPED_TRACE(i);
    const double length = random.uniform(0.1, 1);
    const Points points = random_points(i % forms, random), ends{{0, 0, -length}, {0, 0, length}}, middle{{0, 0, 0}};
    const Pose pose = random_pose(i, random);
    deep += expect_least(test::made<abut::Capsule>({1, length}), hull_of(points), ends, points, pose) ? 1 : 0;
    deep += expect_least(hull_of(points), test::made<abut::Sphere>({1}), points, middle, pose) ? 1 : 0;
  }
  EXPECT_GT(deep, 10);
}

TEST(HullSat, TrianglesInHulls) {
  test::Random random(304);
  int deep = 0;
  for (int i = 0; i < 5 * forms; ++i) {
    SCOPED_TRACE(i);
    const Points points = random_points(i % forms, random), corners = cloud(3, {1, 1, 1}, random);
    std::vector<double> numbers;
    for (const Vec3& p : corners) {
      numbers.insert(numbers.end(), {p.x, p.y, p.z});
    }
    deep +=
        expect_least(test::made<abut::FreeTriangle>(numbers), hull_of(points), corners, points, random_pose(i, random))
            ? 1
            : 0;
  }
  EXPECT_GT(deep, 10);
}

Points on_ellipsoid(std::size_t count, test::Random& random) {
  Points points;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 p = random.rotation().x;
    points.push_back({p.x, 0.8 * p.y, 0.6 * p.z});
  }
  return points;
}
// Larger ones are compared with the expanding polytope, which knows neither faces nor edges. Whether they are deep.
template <class A, class B>
bool expect_depth_of_polytope(const A& a, const B& b, const Pose& ab) {
  const std::optional<abut::SatResult> found = abut::hull_sat(a, b, ab, noise);
  EXPECT_TRUE(found.has_value());
  if (!found || found->separation > -1e-3) {
    return false;
  }
  const abut::EpaResult expected = abut::with_difference(
      a, b, ab, 8, [](const abut::Difference& cores) { return abut::epa(cores, 1e-12, abut::Simplex{}); });
  EXPECT_NEAR(-found->separation, expected.depth, 1e-11);
  return true;
}

TEST(HullSat, DepthIsThatOfTheExpandingPolytope) {
  test::Random random(305);
  int deep = 0;
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Hull a = hull_of(on_ellipsoid(24, random)), b = hull_of(on_ellipsoid(48, random));
    deep += expect_depth_of_polytope(a, b, {random.rotation(), random.point(1)}) ? 1 : 0;
  }
  EXPECT_GT(deep, 500);
}

// As many points on an ellipsoid have three edges each, but for six.
TEST(HullSat, TakesHullsOfAThousandEdges) {
  test::Random random(308);
  const auto box = test::made<abut::Box>({0.4, 0.5, 0.6});
  const auto rod = test::made<abut::Capsule>({1, 0.5});
  int deep = 0;
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    const Hull hull = hull_of(on_ellipsoid(343, random));
    ASSERT_EQ(hull.facets().lines.size(), 1023u);
    std::vector<double> numbers;
    for (const Vec3& p : cloud(3, {1, 1, 1}, random)) {
      numbers.insert(numbers.end(), {p.x, p.y, p.z});
    }
    const Pose ab{random.rotation(), random.point(1)};
    deep += expect_depth_of_polytope(hull, box, ab) ? 1 : 0;
    deep += expect_depth_of_polytope(hull, rod, ab) ? 1 : 0;
    deep += expect_depth_of_polytope(test::made<abut::FreeTriangle>(numbers), hull, ab) ? 1 : 0;
  }
  EXPECT_GT(deep, 45);
  EXPECT_FALSE(abut::hull_sat(hull_of(on_ellipsoid(344, random)), box, Pose::identity(), noise).has_value());
}

// Points of both bodies, and an interval that holds the depth, whatever way found them.
TEST(HullSat, SeparationHasPointsOfBothBodies) {
  test::Random random(306);
  int deep = 0;
  for (int i = 0; i < 2 * forms * forms; ++i) {
    SCOPED_TRACE(i);
    const Points a = random_points(i % forms, random), b = random_points(i / forms % forms, random);
    const Hull hull_a = hull_of(a), hull_b = hull_of(b);
    const Pose ab = random_pose(i, random);
    abut::CoreSeparation found = abut::separate_cores(hull_a, hull_b, ab, {}, abut::infinity);
    if (!found.overlap) {
      continue;
    }
    ++deep;
    const double exact = -ExactDepth(a, b, ab).find();
    EXPECT_LE(found.lower - found.rounding, exact);
    EXPECT_GE(found.upper + found.rounding, exact);
    EXPECT_LE(found.upper - found.lower, 1e-11);
    abut::find_points(hull_a, hull_b, ab, found);
    EXPECT_NEAR(dot(found.point_b - found.point_a, found.normal), found.distance, 1e-13);
    if (found.algorithm == abut::Algorithm::sat && hull_a.data().faces.size() > 2 && hull_b.data().faces.size() > 2) {
      EXPECT_LE(norm(found.point_b - found.point_a - found.distance * found.normal), 1e-12);
      EXPECT_TRUE(abut::holds(hull_a, found.point_a, 1e-12));
      EXPECT_TRUE(abut::holds(hull_b, ab.undo(found.point_b), 1e-12));
    }
  }
  EXPECT_GT(deep, 50);
}

TEST(HullSat, WithoutFacesThereIsNoAnswer) {
  const Hull segment = hull_of({{0, 0, 0}, {1, 0, 0}}), point = hull_of({{0, 0, 0}});
  const Hull cube = hull_of(test::corners_of({1, 1, 1}, Pose::identity()));
  for (const Hull& thin : {segment, point}) {
    EXPECT_FALSE(abut::hull_sat(thin, cube, Pose::identity(), noise).has_value());
    EXPECT_FALSE(abut::hull_sat(cube, thin, Pose::identity(), noise).has_value());
    EXPECT_FALSE(abut::hull_sat(test::made<abut::Box>({1, 1, 1}), thin, Pose::identity(), noise).has_value());
  }
}

TEST(HullSat, HoldsPointsUpToTheSlack) {
  const Hull cube = hull_of(test::corners_of({1, 2, 3}, Pose::identity()));
  const auto box = test::made<abut::Box>({1, 2, 3});
  for (const auto& [point, is_held] : {std::pair(Vec3{1, 2, 3}, true), std::pair(Vec3{1 + 1e-9, 0, 0}, true),
                                       std::pair(Vec3{1 + 1e-7, 0, 0}, false), std::pair(Vec3{0, 0, -3.1}, false)}) {
    EXPECT_EQ(abut::holds(cube, point, 1e-8), is_held);
    EXPECT_EQ(abut::holds(box, point, 1e-8), is_held);
  }
}

}  // namespace
