// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>

import abut.elements.nearest;
import abut.math;

namespace {

using abut::Vec3;
using Long = long double;
using LongVec = std::array<Long, 3>;

LongVec minus(const Vec3& a, const Vec3& b) {
  const auto apart = [](double x, double y) { return static_cast<Long>(x) - static_cast<Long>(y); };
  return {apart(a.x, b.x), apart(a.y, b.y), apart(a.z, b.z)};
}
LongVec along(const LongVec& start, Long share, const LongVec& way) {
  return {start[0] + share * way[0], start[1] + share * way[1], start[2] + share * way[2]};
}
Long dot(const LongVec& a, const LongVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Long norm(const LongVec& a) { return std::sqrt(dot(a, a)); }

Long distance_to_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const LongVec at = minus(p, from), way = minus(to, from);
  const Long square = dot(way, way), share = square > 0 ? std::clamp(dot(at, way) / square, Long{0}, Long{1}) : 0;
  return norm(along(at, -share, way));
}

// By least squares over the triangle where their answer lies in it, else the nearest edge.
Long distance_to_face(const Vec3& p, const std::array<Vec3, 3>& t) {
  const LongVec u = minus(t[1], t[0]), v = minus(t[2], t[0]), at = minus(p, t[0]);
  const Long uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  Long least = std::min(
      {distance_to_segment(p, t[0], t[1]), distance_to_segment(p, t[1], t[2]), distance_to_segment(p, t[2], t[0])});
  if (determinant > 1e-15L * uu * vv) {
    const Long i = (vv * dot(u, at) - uv * dot(v, at)) / determinant,
               j = (uu * dot(v, at) - uv * dot(u, at)) / determinant;
    if (i >= 0 && j >= 0 && i + j <= 1) {
      least = std::min(least, norm(along(along(at, -i, u), -j, v)));
    }
  }
  return least;
}

Vec3 anywhere(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> share(-1, 1);
  return size * Vec3{share(random), share(random), share(random)};
}

// Round, narrow and flat triangles, and some without extent.
std::array<Vec3, 3> some_face(std::mt19937& random, int kind) {
  const Vec3 a = anywhere(random, 1), b = a + anywhere(random, kind % 3 == 0 ? 0.02 : 0.5);
  switch (kind % 5) {
    case 0: return {a, b, a + 0.3 * (b - a)};
    case 1: return {a, b, b};
    case 2: return {a, b, a + 0.4 * (b - a) + anywhere(random, 1e-4)};
    default: return {a, b, a + anywhere(random, 0.5)};
  }
}

TEST(NearestOnFace, DistanceIsThatOfTheTriangle) {
  constexpr std::uint32_t seed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int kind = 0; kind < 20000; ++kind) {
    const std::array<Vec3, 3> face = some_face(random, kind);
    const Vec3 near = face[0] + 0.3 * (face[1] - face[0]) + 0.3 * (face[2] - face[0]);
    const Vec3 p = kind % 7 == 0 ? face.at(static_cast<std::size_t>(kind) % 3) : near + anywhere(random, 0.3);
    const abut::NearestOnFace got = abut::nearest_on_face(p, face);
    ASSERT_NEAR(std::sqrt(got.square), static_cast<double>(distance_to_face(p, face)), 1e-12) << kind;
    Vec3 sum{0, 0, 0};
    double of_weights = 0;
    for (std::size_t i = 0; i < got.count; ++i) {
      ASSERT_TRUE(got.weights.at(i) > 0);
      sum += got.weights.at(i) * face.at(got.corners.at(i));
      of_weights += got.weights.at(i);
    }
    ASSERT_NEAR(of_weights, 1, 1e-12);
    ASSERT_NEAR(abut::norm(got.point - p), std::sqrt(got.square), 1e-12);
    if (kind % 5 > 2) {
      ASSERT_NEAR(abut::norm(sum - got.point), 0, 1e-11);
    }
  }
}

TEST(NearestOnFace, OrderOfCornersChangesNoBit) {
  constexpr std::uint32_t seed = 4;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (int kind = 0; kind < 5000; ++kind) {
    const std::array<Vec3, 3> face = some_face(random, kind);
    const Vec3 p = anywhere(random, 1);
    std::array<std::size_t, 3> order{0, 1, 2};
    const abut::NearestOnFace first = abut::nearest_on_face(p, face);
    do {
      const abut::NearestOnFace got = abut::nearest_on_face(p, {face[order[0]], face[order[1]], face[order[2]]});
      ASSERT_EQ(got.count, first.count);
      ASSERT_EQ(got.point, first.point);
      ASSERT_EQ(got.square, first.square);
      for (std::size_t i = 0; i < got.count; ++i) {
        ASSERT_EQ(face.at(order.at(got.corners.at(i))), face.at(first.corners.at(i)));
        ASSERT_EQ(got.weights.at(i), first.weights.at(i));
      }
    } while (std::ranges::next_permutation(order).found);
  }
}

// What two faces share has the same bits, whichever face it is seen from.
TEST(NearestOnFace, FacesAroundAnEdgeAgree) {
  constexpr std::uint32_t seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int edges = 0, corners = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = anywhere(random, 1), b = anywhere(random, 1), p = anywhere(random, 2);
    const abut::NearestOnFace first = abut::nearest_on_face(p, {a, b, a + anywhere(random, 1)});
    const abut::NearestOnFace second = abut::nearest_on_face(p, {b, a, b + anywhere(random, 1)});
    const bool is_edge = first.count == 2 && second.count == 2 && first.corners[0] + first.corners[1] == 1 &&
                         second.corners[0] + second.corners[1] == 1;
    const bool is_corner = first.count == 1 && second.count == 1 && first.point == second.point;
    edges += is_edge ? 1 : 0;
    corners += is_corner ? 1 : 0;
    if (is_edge || is_corner) {
      ASSERT_EQ(first.point, second.point);
      ASSERT_EQ(first.square, second.square);
    }
  }
  EXPECT_GT(edges, 100);
  EXPECT_GT(corners, 100);
}

// The least distance of two segments: of all ends to the other segment, and of the lines where it lies inside both.
struct Closest {
  Long distance, ends;
};
Closest closest_of_edges(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  const LongVec u = minus(a[1], a[0]), v = minus(b[1], b[0]), w = minus(a[0], b[0]);
  const Long ends = std::min({distance_to_segment(a[0], b[0], b[1]), distance_to_segment(a[1], b[0], b[1]),
                              distance_to_segment(b[0], a[0], a[1]), distance_to_segment(b[1], a[0], a[1])});
  const Long uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  if (determinant > 1e-17L * uu * vv) {
    const Long s = (uv * dot(v, w) - vv * dot(u, w)) / determinant, t = (uu * dot(v, w) - uv * dot(u, w)) / determinant;
    if (s > 0 && s < 1 && t > 0 && t < 1) {
      return {std::min(ends, norm(along(along(w, s, u), -t, v))), ends};
    }
  }
  return {ends, ends};
}

TEST(NearestOfEdges, DistanceIsThatOfTheSegments) {
  constexpr std::uint32_t seed = 6;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int inside = 0;
  for (int kind = 0; kind < 20000; ++kind) {
    const Vec3 centre = anywhere(random, 1), way = anywhere(random, 0.5);
    const Vec3 turned = kind % 3 == 0 ? way + anywhere(random, 1e-5) : anywhere(random, 0.5);
    const Vec3 aside = anywhere(random, kind % 4 == 0 ? 0 : kind % 4 == 1 ? 1e-4 : 0.3);
    const std::array<Vec3, 2> a{centre - way, centre + way}, b{centre + aside - turned, centre + aside + 0.7 * turned};
    const auto got = abut::nearest_of_edges(a, b);
    const Closest wanted = closest_of_edges(a, b);
    if (got) {
      ++inside;
      ASSERT_NEAR(std::sqrt(got->square), static_cast<double>(wanted.distance), 1e-12) << kind;
      ASSERT_NEAR(abut::norm(a[0] + got->shares[0] * (a[1] - a[0]) - got->points[0]), 0, 1e-14);
      ASSERT_NEAR(abut::norm(b[0] + got->shares[1] * (b[1] - b[0]) - got->points[1]), 0, 1e-14);
      const auto mirrored = abut::nearest_of_edges({b[1], b[0]}, a);
      ASSERT_TRUE(mirrored);
      ASSERT_EQ(mirrored->square, got->square);
      ASSERT_EQ(mirrored->points[0], got->points[1]);
      ASSERT_EQ(mirrored->points[1], got->points[0]);
    } else {
      // An end is as near, but for edges that count as parallel.
      ASSERT_NEAR(static_cast<double>(wanted.ends), static_cast<double>(wanted.distance), 1e-6) << kind;
    }
  }
  EXPECT_GT(inside, 5000);
}

TEST(NearestOfEdges, ParallelEdgesHaveNone) {
  EXPECT_FALSE(abut::nearest_of_edges({Vec3{0, 0, 0}, Vec3{1, 0, 0}}, {Vec3{0.2, 1, 0}, Vec3{0.8, 1, 0}}));
  EXPECT_FALSE(abut::nearest_of_edges({Vec3{0, 0, 0}, Vec3{0, 0, 0}}, {Vec3{0.2, 1, 0}, Vec3{0.8, 1, 0}}));
  EXPECT_FALSE(abut::nearest_of_edges({Vec3{0, 0, 0}, Vec3{1, 0, 0}}, {Vec3{1, -1, 0}, Vec3{1, 1, 0}}));
}

}  // namespace
