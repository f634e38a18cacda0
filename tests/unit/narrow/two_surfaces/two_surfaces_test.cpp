// SPDX-License-Identifier: Apache-2.0
// Two surfaces are as far apart, and touch where and when, all their triangles taken two by two are and do. The oracle
// is the distance of corners from faces and of edges from edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "../../damaged_meshes.hpp"
#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.pairs.any_shape;
import abut.pairs.any_shape.casts.shape_cast;
import abut.pairs.registry;
import abut.shapes.height_field;
import abut.shapes.mesh;

namespace {

using abut::AnyShape;
using abut::HeightField;
using abut::Mesh;
using abut::Pose;
using abut::Triangles;
using abut::UvGrid;
using abut::Vec3;
using Corners = std::array<Vec3, 3>;

double clamped(double value) { return std::fmin(std::fmax(value, 0), 1); }

double point_to_face(const Vec3& p, const Corners& face) {
  const Vec3 u = face[1] - face[0], v = face[2] - face[0], w = p - face[0], n = cross(u, v);
  const double area = dot(n, n);
  if (area == 0) {
    return abut::infinity;
  }
  const double at_v = dot(cross(u, w), n) / area, at_u = dot(cross(w, v), n) / area;
  return at_u >= 0 && at_v >= 0 && at_u + at_v <= 1 ? std::fabs(dot(w, n)) / std::sqrt(area) : abut::infinity;
}

// The nearest point of either edge to the other, in turn: the square is convex in both places.
double edge_to_edge(const Vec3& p, const Vec3& along_p, const Vec3& q, const Vec3& along_q) {
  const double a = dot(along_p, along_p), b = dot(along_p, along_q), c = dot(along_q, along_q);
  const Vec3 r = p - q;
  const double d = dot(along_p, r), e = dot(along_q, r), determinant = a * c - b * b;
  double least = abut::infinity;
  const auto try_at = [&](double s, double t) {
    least = std::fmin(least, norm(r + clamped(s) * along_p - clamped(t) * along_q));
  };
  if (determinant > 1e-14 * a * c) {
    const double s = (b * e - c * d) / determinant, t = (a * e - b * d) / determinant;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
      try_at(s, t);
    }
  }
  for (const double end : {0.0, 1.0}) {
    try_at(end, (e + end * b) / c);
    try_at((end * b - d) / a, end);
  }
  return least;
}

double triangle_distance(const Corners& a, const Corners& b) {
  double least = abut::infinity;
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::fmin(least, std::fmin(point_to_face(a[i], b), point_to_face(b[i], a)));
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::fmin(least, edge_to_edge(a[i], a[(i + 1) % 3] - a[i], b[j], b[(j + 1) % 3] - b[j]));
    }
  }
  return least;
}

Corners corners_of(const Triangles& surface, std::size_t triangle, const Pose& pose) {
  const auto at = [&](std::size_t i) { return pose * surface.vertices[surface.indices[3 * triangle + i]]; };
  return {at(0), at(1), at(2)};
}

// Of surfaces that do not cross.
double least_distance(const Triangles& a, const Triangles& b, const Pose& ab) {
  double least = abut::infinity;
  for (std::size_t i = 0; i < a.indices.size() / 3; ++i) {
    const Corners one = corners_of(a, i, Pose::identity());
    if (one[0] == one[1] && one[1] == one[2]) {
      continue;  // missing
    }
    for (std::size_t j = 0; j < b.indices.size() / 3; ++j) {
      const Corners other = corners_of(b, j, ab);
      if (!(other[0] == other[1] && other[1] == other[2])) {
        least = std::fmin(least, triangle_distance(one, other));
      }
    }
  }
  return least;
}

Mesh ring(double wide, double thin) {
  const test::Surface torus = test::torus(wide, thin, 12, 6);
  return test::made<Mesh>({0}, torus.xyz, torus.triangles);
}
Mesh ring_in_cells() {
  const test::Surface torus = test::torus(1.7, 0.5, 11, 6);
  return test::made<UvGrid>({0, 0, 1, 0, 0}, torus.xyz, torus.triangles);
}
// Wavy ground, with holes where there is a share of them.
HeightField ground(std::uint32_t samples, double holes, test::Random& random) {
  std::vector<double> heights;
  for (std::uint32_t i = 0; i < samples * samples; ++i) {
    heights.push_back(random.uniform(0, 1) < holes ? std::numeric_limits<double>::quiet_NaN()
                                                   : random.uniform(-0.3, 0.3));
  }
  const double count = samples;
  return test::made<HeightField>({count, count, 0.4, 0.3, 2, 0}, heights);
}

template <class A, class B>
void expect_answers_of_all_pairs(const A& a, const B& b, std::uint64_t seed) {
  test::Random random(seed);
  const Triangles of_a = a.triangles(), of_b = b.triangles();
  const AnyShape any_a{a}, any_b{b};
  int judged = 0, hits = 0;
  for (int turn = 0; turn < 12; ++turn) {
    const Vec3 away = (turn % 3 == 0 ? 40.0 : 5.0) / norm(random.point(1)) * random.point(1);
    const Pose ab{random.rotation(), away + Vec3{0, 0, turn % 2 == 0 ? 6.0 : -6.0}};
    const double least = least_distance(of_a, of_b, ab);
    abut::Distance found{};
    ASSERT_EQ(abut::pair_distance(any_a, any_b, ab, {}, found), abut::Outcome::ok);
    if (found.distance <= 0) {
      continue;  // they may cross, which the oracle does not see
    }
    ++judged;
    const double rounding = 1e-12 * (10 + norm(ab.position));
    EXPECT_NEAR(found.distance, least, rounding);
    EXPECT_LE(found.lower, least + rounding);
    EXPECT_GE(found.upper, least - rounding);
    for (const double share : {0.999, 1.001}) {
      abut::Manifold contacts;
      ASSERT_EQ(abut::pair_contacts(any_a, any_b, ab, {.margin = share * least}, contacts), abut::Outcome::ok);
      // A height field stops from its front only.
      if (share < 1 || (!abut::Terrain<A> && !abut::Terrain<B>)) {
        EXPECT_EQ(contacts.empty(), share < 1);
      }
    }
    // b moves toward a; where it stops, they touch.
    const auto direction = abut::UnitVec3::make(-ab.position + random.point(1)).value();
    const double length = 2 * norm(ab.position);
    std::optional<abut::ShapeCastHit> hit;
    ASSERT_EQ(abut::cast_shapes(any_a, Pose::identity(), {0, 0, 0}, any_b, ab, length * direction.vec(), {}, 1, hit),
              abut::Outcome::ok);
    if (hit) {
      ++hits;
      const auto moved = [&](double way) { return Pose{ab.rotation, ab.position + way * direction.vec()}; };
      const double way = hit->fraction * length;
      EXPECT_NEAR(least_distance(of_a, of_b, moved(way)), 0, 1e-9);
      EXPECT_GT(least_distance(of_a, of_b, moved(0.98 * way)), 1e-6);
    }
  }
  EXPECT_GE(judged, 8);
  EXPECT_GE(hits, 2);
}

TEST(TwoSurfaces, OfMeshesAnswerAsAllPairsOfTriangles) { expect_answers_of_all_pairs(ring(2, 0.6), ring(1.5, 0.4), 1); }
TEST(TwoSurfaces, OfHeightFieldsAnswerAsAllPairsOfTriangles) {
  test::Random random(2);
  expect_answers_of_all_pairs(ground(8, 0, random), ground(7, 0.1, random), 2);
}
TEST(TwoSurfaces, OfAMeshAndAHeightFieldAnswerAsAllPairsOfTriangles) {
  test::Random random(3);
  expect_answers_of_all_pairs(ring(2, 0.6), ground(8, 0.2, random), 3);
}
TEST(TwoSurfaces, OfAGridOfCellsAnswerAsAllPairsOfTriangles) {
  test::Random random(4);
  expect_answers_of_all_pairs(ring_in_cells(), ring(2, 0.6), 4);
  expect_answers_of_all_pairs(ring_in_cells(), ground(7, 0, random), 5);
}

// Of parallel surfaces all parts are as near as the nearest one.
TEST(TwoSurfaces, ThatAreParallelAreAsFarApartAsTheirPlanes) {
  const std::vector<double> flat(100, 0.7);
  const HeightField field = test::made<HeightField>({10, 10, 0.1, 0.1, 0, 0}, flat);
  abut::Distance found{};
  const AnyShape any{field};
  ASSERT_EQ(abut::pair_distance(any, any, {abut::Rotation::identity(), {0.03, 0.02, 30}}, {}, found),
            abut::Outcome::ok);
  EXPECT_NEAR(found.distance, 30, 1e-12);
}

}  // namespace
