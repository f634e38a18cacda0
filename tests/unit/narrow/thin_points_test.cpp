// SPDX-License-Identifier: Apache-2.0
// The closest and deepest points of bodies that are thin up to rounding lie on these bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../made.hpp"
#include "../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.convex.separation;
import abut.shapes.box;
import abut.shapes.cylinder;
import abut.shapes.hull;
import abut.shapes.triangle;

namespace {

using abut::Pose;
using abut::Real;
using abut::Vec3;

constexpr Real allowed = 1e-9;  // of lengths about one

// How far a point of the plane z = 0 is from a segment there.
Real distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Real x = to.x - from.x, y = to.y - from.y, square = x * x + y * y;
  const Real t = square > 0 ? std::clamp(((p.x - from.x) * x + (p.y - from.y) * y) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - from.x - t * x, p.y - from.y - t * y);
}

// How far a point is from the hull of points next to the plane z = 0: in one of the triangles of these, or near one of
// their sides.
Real distance_to_plate(const std::vector<Vec3>& points, const Vec3& p) {
  Real least = abut::infinity, half = 0;
  for (const Vec3& u : points) {
    half = std::max(half, std::fabs(u.z));
  }
  const auto turn = [](const Vec3& u, const Vec3& v, const Vec3& w) {
    return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
  };
  for (const Vec3& u : points) {
    for (const Vec3& v : points) {
      least = std::min(least, distance_to_segment(p, u, v));
      for (const Vec3& w : points) {
        if (turn(u, v, p) >= 0 && turn(v, w, p) >= 0 && turn(w, u, p) >= 0 && turn(u, v, w) > 0) {
          least = 0;
        }
      }
    }
  }
  return std::max(least, std::fabs(p.z) - half);
}

std::vector<Real> flat(const std::vector<Vec3>& points) {
  std::vector<Real> numbers;
  for (const Vec3& p : points) {
    numbers.insert(numbers.end(), {p.x, p.y, p.z});
  }
  return numbers;
}

Real tenth(test::Random& random) { return std::round(random.uniform(-10, 10)) / 10; }

template <class A, class B>
abut::CoreSeparation answer(const A& a, const B& b, const Pose& ab) {
  abut::CoreSeparation core = separate_cores(a, b, ab, abut::QuerySettings{}, abut::infinity);
  find_points(a, b, ab, core);
  const Vec3 beside = core.point_b - core.point_a - core.distance * core.normal;
  EXPECT_LE(norm(beside), core.overlap ? 4.0 : allowed);
  EXPECT_NEAR(dot(beside, core.normal), 0, 1e-12);
  return core;
}

// A plate of some thickness in a body that is thick, both turned.
template <class B, class Off>
void check_plates(const B& body, const Off& off_body, std::uint64_t seed) {
  test::Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const Real thickness = std::pow(Real{10}, -16 + i % 8);
    std::vector<Vec3> points;
    for (int k = 0; k < 4 + i % 3; ++k) {
      points.push_back({tenth(random), tenth(random), thickness * std::round(random.uniform(-4, 4))});
    }
    const auto plate = test::made<abut::Hull>({}, flat(points));
    const abut::Rotation about_z = abut::Rotation::from({0.6, 0, 0, 0.8});
    const Pose ab{i % 3 == 0   ? abut::Rotation::identity()
                  : i % 3 == 1 ? about_z
                               : random.rotation(),
                  i % 2 == 0 ? Vec3{0, 0, 0} : random.point(0.5)};
    const abut::CoreSeparation core = answer(plate, body, ab);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", plate " << i << ", thickness " << thickness);
    EXPECT_LE(distance_to_plate(points, core.point_a), allowed);
    EXPECT_LE(off_body(ab.undo(core.point_b)), allowed);
  }
}

TEST(ThinPoints, OfAPlateInABoxLieOnIt) {
  check_plates(
      test::made<abut::Box>({2, 1, 1}),
      [](const Vec3& p) { return std::max({std::fabs(p.x) - 2, std::fabs(p.y) - 1, std::fabs(p.z) - 1}); }, 41);
}

TEST(ThinPoints, OfAPlateInACylinderLieOnIt) {
  check_plates(
      test::made<abut::Cylinder>({1.5, 1}),
      [](const Vec3& p) { return std::max(std::hypot(p.x, p.y) - 1.5, std::fabs(p.z) - 1); }, 42);
}

// A triangle whose corners lie on a line but for rounding, and the same one turned about a corner of it.
TEST(ThinPoints, OfTrianglesThatAreSegmentsAreAsFarApartAsTheDistance) {
  test::Random random(43);
  for (int i = 0; i < 4000; ++i) {
    const Vec3 from = random.point(1), along = random.point(1);
    std::vector<Vec3> corners;
    for (int k = 0; k < 3; ++k) {
      corners.push_back(from + random.uniform(-1, 1) * along + 1e-16 * random.point(1));
    }
    const auto triangle = test::made<abut::FreeTriangle>(flat(corners));
    const Real turn = std::pow(Real{10}, -6 - i % 4);
    const Vec3 axis = turn * random.point(1);
    const Pose ab{abut::Rotation::from({1, axis.x, axis.y, axis.z}), turn * random.point(0.1)};
    SCOPED_TRACE(::testing::Message() << "seed 43, triangle " << i);
    const abut::CoreSeparation core = answer(triangle, triangle, ab);
    const auto off = [&](const Vec3& p) {
      Real least = abut::infinity;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 edge = corners[k == 2 ? 0 : k + 1] - corners[k];
        const Real t = std::clamp(dot(p - corners[k], edge) / dot(edge, edge), 0.0, 1.0);
        least = std::min(least, norm(p - corners[k] - t * edge));
      }
      return least;
    };
    EXPECT_LE(off(core.point_a), allowed);
    EXPECT_LE(off(ab.undo(core.point_b)), allowed);
  }
}

}  // namespace
