// SPDX-License-Identifier: Apache-2.0
// On which stretch of a way two triangles overlap: edges of one of them cross the other one then, and not before or
// after. Segments through triangles judge that.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.ways.leaving_four;
import abut.narrow.two_surfaces.leaving_pairs;

namespace {

using abut::TriangleCorners;
using abut::Vec3;

TriangleCorners random_triangle(test::Random& random) { return {random.point(1), random.point(1), random.point(1)}; }
TriangleCorners moved(const TriangleCorners& t, const Vec3& move) { return {t[0] + move, t[1] + move, t[2] + move}; }

// Whether a segment passes a triangle, by the signs of volumes.
bool passes(const Vec3& from, const Vec3& to, const TriangleCorners& t) {
  const auto volume = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(cross(b - a, c - a), d - a);
  };
  if (volume(t[0], t[1], t[2], from) * volume(t[0], t[1], t[2], to) > 0) {
    return false;
  }
  const double a = volume(from, to, t[0], t[1]), b = volume(from, to, t[1], t[2]), c = volume(from, to, t[2], t[0]);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}
bool do_cross(const TriangleCorners& a, const TriangleCorners& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (passes(a[i], a[(i + 1) % 3], b) || passes(b[i], b[(i + 1) % 3], a)) {
      return true;
    }
  }
  return false;
}

abut::FourFaces in_all(const TriangleCorners& corners) {
  abut::FourFaces faces{abut::FourTriangles::all(corners), {}, {}};
  faces.set_planes(15);
  return faces;
}

TEST(LeavingPairs, OverlapOnTheStretchAndNowhereElse) {
  constexpr std::uint64_t seed = 5;
  constexpr double step = 1e-6, touching = 1e-13;
  test::Random random(seed);
  int met = 0;
  for (int scene = 0; scene < 4000; ++scene) {
    const TriangleCorners a = random_triangle(random), b = random_triangle(random);
    const Vec3 way = random.point(1), d = (1 / norm(way)) * way;
    const abut::PairStretches found =
        stretches_of(in_all(a), in_all(b), {d, abut::infinity, -abut::infinity, touching});
    const auto crosses_at = [&](double length) { return do_cross(a, moved(b, length * d)); };
    if (!(found.end[0] > -abut::infinity)) {
      for (double length = -4; length < 4; length += 0.05) {
        EXPECT_FALSE(crosses_at(length)) << "seed " << seed << " scene " << scene << " at " << length;
      }
      continue;
    }
    ++met;
    const double begin = found.begin[0], end = found.end[0];
    EXPECT_NEAR(found.last[0], end, 1e-6);
    EXPECT_FALSE(crosses_at(begin - step)) << "seed " << seed << " scene " << scene;
    EXPECT_FALSE(crosses_at(end + step)) << "seed " << seed << " scene " << scene;
    if (end - begin > 4 * step) {
      EXPECT_TRUE(crosses_at(begin + step)) << "seed " << seed << " scene " << scene;
      EXPECT_TRUE(crosses_at(0.5 * (begin + end))) << "seed " << seed << " scene " << scene;
      EXPECT_TRUE(crosses_at(end - step)) << "seed " << seed << " scene " << scene;
    }
    // The last point lies on b, and on a once it has moved.
    const Vec3 point = last_point_of(a, b, d, end), normal = normal_at_end(in_all(a), in_all(b), 0, d, found.axis[0]);
    const auto off_plane = [](const TriangleCorners& t, const Vec3& p) {
      const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
      return std::fabs(dot(n, p - t[0])) / norm(n);
    };
    EXPECT_LT(off_plane(b, point), 1e-6) << "seed " << seed << " scene " << scene;
    EXPECT_LT(off_plane(a, point + end * d), 1e-6) << "seed " << seed << " scene " << scene;
    EXPECT_GT(dot(normal, d), 0);
  }
  EXPECT_GT(met, 1000);
}

// Triangles in one plane only touch, however far they slide on each other.
TEST(LeavingPairs, OfTrianglesInOnePlaneHaveNone) {
  constexpr std::uint64_t seed = 6;
  test::Random random(seed);
  for (int scene = 0; scene < 1000; ++scene) {
    const abut::Pose pose{random.rotation(), random.point(3)};
    const auto flat = [&] { return pose * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 0}; };
    const TriangleCorners a{flat(), flat(), flat()}, b{flat(), flat(), flat()};
    const Vec3 in_plane = pose.rotation.x;
    const abut::PairStretches found =
        stretches_of(in_all(a), in_all(b), {in_plane, abut::infinity, -abut::infinity, 1e-12});
    EXPECT_EQ(found.end[0], -abut::infinity) << "seed " << seed << " scene " << scene;
  }
}

}  // namespace
