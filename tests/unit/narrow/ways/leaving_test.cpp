// SPDX-License-Identifier: Apache-2.0
// Where a convex shape leaves a triangle on its way: it overlaps the triangle just before, and not after. The distance
// of the two judges that.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.convex;
import abut.narrow.ways.leaving;
import abut.narrow.ways.leaving_four;
import abut.narrow.ways.leaving_portal;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.cylinder;
import abut.shapes.hull;
import abut.shapes.sphere;

namespace {

using abut::Pose;
using abut::Triangle;
using abut::Vec3;

template <class B>
double distance_after(const Triangle& triangle, const B& b, const Pose& ab, const Vec3& direction, double length) {
  abut::Distance found{};
  const Pose at{ab.rotation, ab.position + length * direction};
  EXPECT_EQ(convex_distance(triangle, b, at, abut::QuerySettings{}, found), abut::Outcome::ok);
  return found.distance;
}

Triangle random_triangle(test::Random& random) {
  const Vec3 near = random.point(0.3);
  return {near + random.point(1), near + random.point(1), near + random.point(1), 0, false};
}
Vec3 random_direction(test::Random& random) {
  const Vec3 d = random.point(1);
  return (1 / norm(d)) * d;
}

template <class B>
void check(const B& b, std::uint64_t seed) {
  test::Random random(seed);
  constexpr double tolerance = 1e-11, step = 1e-6;
  int overlapping = 0;
  for (int scene = 0; scene < 300; ++scene) {
    const Triangle triangle = random_triangle(random);
    const Pose ab{random.rotation(), random.point(0.6)};
    const Vec3 d = random_direction(random);
    if (!(distance_after(triangle, b, ab, d, 0) < -1e-4)) {
      continue;
    }
    ++overlapping;
    const double bound =
        -least_along(triangle.corners(), -d) - abut::lowest_point_along(b, ab, d);  // then a plane across parts them
    const abut::Leaving found = leave(triangle, b, ab, d, abut::QuerySettings{}, {.bound = bound}, tolerance);
    const auto about = [&] { return testing::Message() << "scene " << scene << " of seed " << seed; };
    EXPECT_LE(found.length, bound + 1e-9) << about();
    EXPECT_GE(distance_after(triangle, b, ab, d, found.length), -1e-9) << about();
    EXPECT_LT(distance_after(triangle, b, ab, d, found.length - step), 0) << about();
    EXPECT_GE(dot(found.normal, d), -1e-9) << about();
    if constexpr (abut::leaves_in_fours<B>) {
      const abut::FourTriangles four = abut::FourTriangles::all(triangle.corners());
      const abut::Columns normals = abut::Columns::all(triangle.normal());
      const abut::FourStretches at_once = stretches_of(abut::FourFaces{four, normals, dot(normals, four.a)}, b, ab, d);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        EXPECT_NEAR(at_once.end[lane], found.length, 1e-8) << about();
        EXPECT_LT(at_once.begin[lane], 0) << about();
      }
    }
  }
  EXPECT_GT(overlapping, 30) << "seed " << seed;
}

std::vector<double> random_corners(test::Random& random, int count) {
  std::vector<double> xyz;
  for (int i = 0; i < count; ++i) {
    const Vec3 p = random.point(0.5);
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
  }
  return xyz;
}

TEST(Leaving, EndsWhereNothingOverlaps) {
  check(core_of(test::made<abut::Sphere>({0.5})), 1);
  check(core_of(test::made<abut::Capsule>({0.2, 0.5})), 2);
  check(core_of(test::made<abut::Box>({0.5, 0.3, 0.2})), 3);
  check(core_of(test::made<abut::Cylinder>({0.3, 0.4})), 4);
  test::Random random(5);
  for (std::uint64_t seed = 6; seed < 12; ++seed) {
    check(test::made<abut::Hull>({}, random_corners(random, 8 << (seed % 3))), seed);
  }
}

TEST(Leaving, TellsOnWhichSideOfWhatIsAskedItEnds) {
  constexpr std::uint64_t seed = 12;
  test::Random random(seed);
  int inexact = 0;
  for (int scene = 0; scene < 500; ++scene) {
    const auto hull = test::made<abut::Hull>({}, random_corners(random, 32));
    const Triangle triangle = random_triangle(random);
    const Pose ab{random.rotation(), random.point(0.4)};
    const Vec3 d = random_direction(random);
    if (!(distance_after(triangle, hull, ab, d, 0) < -1e-3)) {
      continue;
    }
    const auto ask = [&](double least, double enough) {
      return leave_by_portal(triangle, hull, ab, d, least, enough, 1e-12);
    };
    const auto about = [&] { return testing::Message() << "scene " << scene << " of seed " << seed; };
    const auto exact = ask(-abut::infinity, abut::infinity);
    ASSERT_TRUE(exact) << about();
    const double half = 0.5 * exact->length, twice = 2 * exact->length;
    EXPECT_GE(ask(-abut::infinity, half)->length, half) << about();
    EXPECT_LE(ask(-abut::infinity, half)->length, exact->length + 1e-11) << about();
    EXPECT_LT(ask(twice, abut::infinity)->length, twice) << about();
    EXPECT_GE(ask(twice, abut::infinity)->length, exact->length - 1e-11) << about();
    inexact += ask(twice, abut::infinity)->length > exact->length + 1e-9 ? 1 : 0;
    inexact += ask(-abut::infinity, half)->length < exact->length - 1e-9 ? 1 : 0;
  }
  EXPECT_GT(inexact, 50) << "seed " << seed;  // then less was done
}

}  // namespace
