// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

import abut.math;
import abut.trees.inside.nearest_triangle;

namespace {

using abut::NearestTriangle;
using abut::TriangleAt;
using abut::Vec3;
using Long = long double;
using LongVec = std::array<Long, 3>;

LongVec minus(const Vec3& a, const Vec3& b) {
  const auto apart = [](double x, double y) { return static_cast<Long>(x) - static_cast<Long>(y); };
  return {apart(a.x, b.x), apart(a.y, b.y), apart(a.z, b.z)};
}
Long dot(const LongVec& a, const LongVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Long distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const LongVec at = minus(p, from), way = minus(to, from);
  const Long square = dot(way, way), share = square > 0 ? std::clamp(dot(at, way) / square, Long{0}, Long{1}) : 0;
  const LongVec away{at[0] - share * way[0], at[1] - share * way[1], at[2] - share * way[2]};
  return std::sqrt(dot(away, away));
}

// The foot of the perpendicular by least squares where it lies in the triangle, else the nearest edge.
Long distance_to_triangle(const Vec3& p, const TriangleAt& t) {
  const LongVec u = minus(t.b, t.a), v = minus(t.c, t.a), at = minus(p, t.a);
  const Long uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  if (determinant > 1e-15L * uu * vv) {
    const Long i = (vv * dot(u, at) - uv * dot(v, at)) / determinant,
               j = (uu * dot(v, at) - uv * dot(u, at)) / determinant;
    if (i >= 0 && j >= 0 && i + j <= 1) {
      const LongVec away{at[0] - i * u[0] - j * v[0], at[1] - i * u[1] - j * v[1], at[2] - i * u[2] - j * v[2]};
      return std::sqrt(dot(away, away));
    }
  }
  return std::min(
      {distance_to_segment(p, t.a, t.b), distance_to_segment(p, t.b, t.c), distance_to_segment(p, t.c, t.a)});
}

// Triangles of all sizes: round ones, narrow ones, and ones without extent.
std::vector<TriangleAt> random_triangles(std::mt19937& random, std::size_t count) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto anywhere = [&](double size) { return size * Vec3{share(random), share(random), share(random)}; };
  std::vector<TriangleAt> out;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 a = anywhere(1), b = a + anywhere(i % 7 == 0 ? 0.8 : 0.1);
    const Vec3 on_edge = a + (0.5 + 0.5 * share(random)) * (b - a);
    out.push_back({a, b,
                   i % 4 == 0   ? on_edge + anywhere(1e-9)
                   : i % 4 == 1 ? on_edge
                   : i % 4 == 2 ? a + anywhere(0.1)
                                : (i % 8 == 3 ? a : a + anywhere(0.5))});
  }
  return out;
}

TEST(NearestTriangle, IsThatOfAllTriangles) {
  constexpr std::uint32_t seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const std::size_t count : {1u, 3u, 50u, 700u}) {
    const NearestTriangle tree(random_triangles(random, count));
    for (int group = 0; group < 60; ++group) {
      const double apart = group % 3 == 0 ? 0.01 : group % 3 == 1 ? 0.3 : 0;
      const Vec3 middle = 1.5 * Vec3{share(random), share(random), share(random)};
      std::vector<Vec3> points(static_cast<std::size_t>(1 + group % 32), middle);
      for (Vec3& point : points) {
        point = point + apart * Vec3{share(random), share(random), share(random)};
      }
      const std::vector<std::uint32_t> close(static_cast<std::size_t>(group % 3),
                                             static_cast<std::uint32_t>(random() % count));
      std::vector<NearestTriangle::Found> found(points.size());
      tree.find(points, close, found);
      for (std::size_t i = 0; i < points.size(); ++i) {
        Long least = 1e9L;
        for (const TriangleAt& triangle : tree.triangles()) {
          least = std::min(least, distance_to_triangle(points[i], triangle));
        }
        EXPECT_NEAR(std::sqrt(found[i].squared), static_cast<double>(least), 1e-9)
            << count << " triangles, point " << i;
        EXPECT_NEAR(static_cast<double>(distance_to_triangle(points[i], tree.triangles()[found[i].triangle])),
                    static_cast<double>(least), 1e-9);
      }
    }
  }
}

}  // namespace
