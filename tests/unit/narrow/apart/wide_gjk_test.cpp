// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.narrow.apart.gjk;
import abut.narrow.apart.wide_gjk;
import abut.narrow.cores.difference;
import abut.shapes.cylinder;
import abut.shapes.triangle;

namespace {

using abut::Pose;
using abut::Vec3;

constexpr double giant = 0x1p20, error = 1e-12 * giant, size = 4 * giant;

// Of cores in one frame.
template <class A, class B>
abut::WideGjkResult separated(const A& a, const B& b, const Vec3& toward, double size_of_both, double bound,
                              double limit, double unproven) {
  return abut::with_difference(a, b, Pose::identity(), size_of_both, [&](const abut::Difference& cores) {
    return abut::wide_gjk(cores, toward, bound, limit, unproven);
  });
}

abut::FreeTriangle triangle_of(const std::array<Vec3, 3>& corners) {
  const auto& [p, q, r] = corners;
  return test::made<abut::FreeTriangle>({p.x, p.y, p.z, q.x, q.y, q.z, r.x, r.y, r.z});
}

// A slender triangle a million times as long as others, one corner of which is near the origin.
std::array<Vec3, 3> random_sliver(test::Random& random) {
  const Vec3 near = random.point(1), far = giant * random.point(1);
  const double width = random.uniform(0, 1) < 0.5 ? 1e-6 : 1;
  const Vec3 aside = width * random.point(1);
  return random.uniform(0, 1) < 0.5 ? std::array{near, far, far + aside} : std::array{near, near + aside, far};
}
std::array<Vec3, 3> random_triangle(test::Random& random) {
  const Vec3 first = random.point(1), second = random.point(1);
  return random.uniform(0, 1) < 0.5 ? std::array{first, second, random.point(1)}
                                    : std::array{first, second, second + 1e-6 * random.point(1)};
}

// How far a point is from a triangle, in 113 bits: Gram's matrix of the sides gives the weights of its foot.
double distance_to(const std::array<Vec3, 3>& corners, const Vec3& point) {
  using Quad = __float128;
  using Three = std::array<Quad, 3>;
  const auto from = [](const Vec3& a, const Vec3& b) {
    return Three{static_cast<Quad>(b.x) - static_cast<Quad>(a.x), static_cast<Quad>(b.y) - static_cast<Quad>(a.y),
                 static_cast<Quad>(b.z) - static_cast<Quad>(a.z)};
  };
  const auto product = [](const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Three u = from(corners[0], corners[1]), v = from(corners[0], corners[2]), p = from(corners[0], point);
  const Quad uu = product(u, u), uv = product(u, v), vv = product(v, v), pu = product(p, u), pv = product(p, v);
  const Quad determinant = uu * vv - uv * uv, zero = 0, one = 1;
  const auto square_at = [&](Quad s, Quad t) {
    const Three off{p[0] - s * u[0] - t * v[0], p[1] - s * u[1] - t * v[1], p[2] - s * u[2] - t * v[2]};
    return product(off, off);
  };
  const auto held = [&](Quad weight) { return std::clamp(weight, zero, one); };
  Quad least = square_at(held(pu / uu), zero);
  least = std::min(least, square_at(zero, held(pv / vv)));
  // The third side, from the second corner to the third.
  const Quad length = uu - 2 * uv + vv, along = held((pv - pu - uv + uu) / length);
  least = std::min(least, square_at(one - along, along));
  if (determinant > 0) {
    const Quad s = (vv * pu - uv * pv) / determinant, t = (uu * pv - uv * pu) / determinant;
    if (s >= 0 && t >= 0 && s + t <= 1) {
      least = std::min(least, square_at(s, t));
    }
  }
  return std::sqrt(static_cast<double>(least));
}

TEST(WideGjk, SliversBesideSpecksAreProvenByTheirCorners) {
  test::Random random(71);
  int apart = 0, left_open = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::array<Vec3, 3> corners_a = random_triangle(random), corners_b = random_sliver(random);
    const abut::FreeTriangle a = triangle_of(corners_a), b = triangle_of(corners_b);
    const Vec3 toward = b.centre() - a.centre();
    const abut::GjkResult usual = abut::gjk(a, b, Pose::identity(), toward, size, error, abut::infinity);
    left_open += usual.overlap || usual.upper - usual.lower > 8 * error ? 1 : 0;
    const abut::WideGjkResult found = separated(a, b, toward, size, error, abut::infinity, error);
    if (found.gjk.overlap) {
      continue;
    }
    ++apart;
    EXPECT_LE(found.gjk.upper - found.gjk.lower, error) << i;
    const std::vector<Vec3> of_a(corners_a.begin(), corners_a.end()), of_b(corners_b.begin(), corners_b.end());
    EXPECT_LE(std::fabs(test::corners_overreach(of_a, of_b, found.gjk.normal, found.gjk.upper)), 2 * error) << i;
    EXPECT_LE(distance_to(corners_a, found.point_a), 1e-15) << i;
    EXPECT_LE(distance_to(corners_b, found.point_b), 2e-16 * giant) << i;
    EXPECT_NEAR(abut::norm(found.point_b - found.point_a), found.gjk.upper, 2e-16 * giant) << i;
  }
  EXPECT_GT(apart, 3000);
  EXPECT_GT(left_open, 20);
}

TEST(WideGjk, TrianglesThatCrossOverlap) {
  test::Random random(72);
  for (int i = 0; i < 1000; ++i) {
    const std::array<Vec3, 3> corners = random_sliver(random);
    // A side goes through the middle of the sliver, across it.
    const Vec3 middle = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    const Vec3 across = 1e3 * *abut::UnitVec3::make(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const abut::FreeTriangle a = triangle_of({middle + across, middle - across, random.point(1)}),
                             b = triangle_of(corners);
    EXPECT_TRUE(separated(a, b, {0, 0, 1}, size, error, abut::infinity, error).gjk.overlap) << i;
  }
}

TEST(WideGjk, EndsWhereTheLimitIsExceeded) {
  const abut::FreeTriangle a = triangle_of({Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                           b = triangle_of({Vec3{0, 0, 5}, {1, 0, 5}, {0, 1, 6}});
  const abut::WideGjkResult far = separated(a, b, {0, 0, 1}, 10, 1e-12, 4, 1e-12);
  EXPECT_TRUE(far.gjk.beyond);
  EXPECT_GT(far.gjk.lower, 4);
  EXPECT_FALSE(separated(a, b, {0, 0, 1}, 10, 1e-12, 5, 1e-12).gjk.beyond);
}

TEST(WideGjk, CornersBesideTheRimOfACylinder) {
  test::Random random(73);
  const auto cylinder = test::made<abut::Cylinder>({1, 0.75});
  for (int i = 0; i < 500; ++i) {
    // Outward of the rim, where its normals lead.
    const double angle = random.uniform(-3, 3), lean = random.uniform(0.05, 1.5),
                 gap = std::ldexp(1, -static_cast<int>(random.uniform(2, 40)));
    const Vec3 normal{std::sin(lean) * std::cos(angle), std::sin(lean) * std::sin(angle), std::cos(lean)};
    const Vec3 rim{std::cos(angle), std::sin(angle), 0.75}, corner = rim + gap * normal;
    const abut::FreeTriangle triangle =
        triangle_of({corner, corner + normal + 0.3 * random.point(1), corner + normal + 0.3 * random.point(1)});
    const abut::WideGjkResult found = separated(cylinder, triangle, {1, 0, 0}, 8, 1e-12, abut::infinity, 1e-12);
    ASSERT_FALSE(found.gjk.overlap) << i;
    EXPECT_NEAR(found.gjk.lower, gap, 2e-12) << i;
    EXPECT_NEAR(found.gjk.upper, gap, 2e-12) << i;
    EXPECT_LE(abut::norm(found.point_b - corner), 1e-15) << i;
  }
}

}  // namespace
