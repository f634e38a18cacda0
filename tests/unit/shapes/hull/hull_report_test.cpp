// SPDX-License-Identifier: Apache-2.0
// What a hull reports of its points. The error is judged by the method of Gilbert, Johnson and Keerthi in long double
// on the vertices alone: the hull is all convex combinations of them, and each answer is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../hull_of.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.shapes.hull;
import abut.shapes.hull.data;

namespace {

using abut::HullReport;
using abut::Vec3;
using test::hull_of;

using Wide = std::array<long double, 3>;

Wide minus(const Vec3& a, const Vec3& b) {
  return {static_cast<long double>(a.x) - static_cast<long double>(b.x),
          static_cast<long double>(a.y) - static_cast<long double>(b.y),
          static_cast<long double>(a.z) - static_cast<long double>(b.z)};
}
long double inner(const Wide& a, const Wide& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Weights, all positive, of the combination of corners that is nearest to the origin of their affine hull, if such
// exist: solves the bordered system of Gram's matrix by elimination with pivots.
std::optional<std::vector<long double>> weights_of(const std::vector<Wide>& corners) {
  const std::size_t n = corners.size() + 1;
  std::vector<std::vector<long double>> rows(n, std::vector<long double>(n + 1, 0));
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (std::size_t j = 0; j + 1 < n; ++j) rows[i][j] = inner(corners[i], corners[j]);
    rows[i][n - 1] = rows[n - 1][i] = 1;
  }
  rows[n - 1][n] = 1;
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < n; ++row) {
      if (std::fabs(rows[row][column]) > std::fabs(rows[pivot][column])) pivot = row;
    }
    if (rows[pivot][column] == 0) return std::nullopt;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == column) continue;
      const long double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= n; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  std::vector<long double> weights;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    weights.push_back(rows[i][n] / rows[i][i]);
    if (!(weights.back() > 0)) return std::nullopt;
  }
  return weights;
}

// The distance of a point from the convex hull of the vertices, or a little more.
double distance_to_hull(const std::vector<Vec3>& vertices, const Vec3& p) {
  std::vector<Wide> simplex;
  Wide nearest = minus(vertices[0], p);
  long double shortest = inner(nearest, nearest);
  for (int round = 0; round < 100; ++round) {
    Wide furthest = minus(vertices[0], p);
    for (const Vec3& vertex : vertices) {
      const Wide candidate = minus(vertex, p);
      if (inner(candidate, nearest) < inner(furthest, nearest)) furthest = candidate;
    }
    simplex.push_back(furthest);
    std::vector<Wide> kept;
    bool is_better = round == 0;
    for (unsigned subset = 1; subset < 1U << simplex.size(); ++subset) {
      std::vector<Wide> corners;
      for (std::size_t i = 0; i < simplex.size(); ++i) {
        if ((subset >> i & 1U) != 0) corners.push_back(simplex[i]);
      }
      const auto weights = weights_of(corners);
      if (corners.size() > 4 || !weights) continue;
      Wide at{};
      for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) at[k] += (*weights)[i] * corners[i][k];
      }
      const long double square = inner(at, at);
      if (square < shortest || (round == 0 && kept.empty())) {
        is_better = true;
        shortest = square;
        nearest = at;
        kept = corners;
      }
    }
    if (!is_better || shortest == 0) break;
    simplex = kept;
  }
  return static_cast<double>(std::sqrt(shortest));
}

std::vector<Vec3> vertices_of(const abut::Hull& hull) {
  return {hull.data().vertices.begin(), hull.data().vertices.end()};
}

void expect_counts(const HullReport& report, std::uint32_t dimension, std::size_t points, std::size_t vertices,
                   std::size_t edges, std::size_t faces) {
  EXPECT_EQ(report.dimension, dimension);
  EXPECT_EQ(report.point_count, points);
  EXPECT_EQ(report.vertex_count, vertices);
  EXPECT_EQ(report.edge_count, edges);
  EXPECT_EQ(report.face_count, faces);
}

// No given point is further out than the report says.
void expect_within_error(const abut::Hull& hull, const std::vector<Vec3>& points, double rounding) {
  const std::vector<Vec3> vertices = vertices_of(hull);
  for (const Vec3& p : points) {
    EXPECT_LE(distance_to_hull(vertices, p), hull.report().error + rounding);
  }
}

const std::vector<Vec3> cube = test::corners_of({1, 1, 1}, abut::Pose::identity());

TEST(HullReport, Cube) {
  const HullReport report = hull_of(cube).report();
  expect_counts(report, 3, 8, 8, 12, 6);
  EXPECT_EQ(report.error, 0);
}

TEST(HullReport, DuplicatesAndPointsInsideAreNoError) {
  std::vector<Vec3> points = cube;
  points.insert(points.end(), cube.begin(), cube.end());
  points.insert(points.end(), {{0, 0, 0}, {0.5, -0.5, 0.25}, {1, 0, 0}, {1, 1, 0.5}});
  const HullReport report = hull_of(points).report();
  expect_counts(report, 3, 20, 8, 12, 6);
  EXPECT_EQ(report.error, 0);
}

TEST(HullReport, Polygon) {
  test::Random random(811);
  const abut::Pose pose{random.rotation(), {3, -2, 1}};
  std::vector<Vec3> points{pose * Vec3{0, 0, 0}};
  for (int i = 0; i < 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    points.push_back(pose * Vec3{std::cos(angle), std::sin(angle), 0});
    points.push_back(pose * Vec3{0.5 * std::cos(angle), 0.5 * std::sin(angle), 0});
  }
  const abut::Hull hull = hull_of(points);
  expect_counts(hull.report(), 2, 13, 6, 6, 2);
  EXPECT_EQ(hull.report().error, 0);
  expect_within_error(hull, points, 1e-14);
}

TEST(HullReport, SegmentAndPoint) {
  const HullReport segment = hull_of({{0, 0, 0}, {2, 2, 2}, {1, 1, 1}, {3, 3, 3}}).report();
  expect_counts(segment, 1, 4, 2, 1, 0);
  EXPECT_EQ(segment.error, 0);
  const HullReport point = hull_of({{1, 2, 3}, {1, 2, 3}}).report();
  expect_counts(point, 0, 2, 1, 0, 0);
  EXPECT_EQ(point.error, 0);
}

// Twins nearer than what the builder tells apart are dropped: the error is at most what parts them.
TEST(HullReport, NearDuplicates) {
  test::Random random(812);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random.rotation().x;
    points.push_back(p);
    points.push_back(p + 1e-13 * random.rotation().x);
  }
  const abut::Hull hull = hull_of(points);
  EXPECT_EQ(hull.report().point_count, 600U);
  EXPECT_LT(hull.report().vertex_count, 600U);
  EXPECT_LE(hull.report().error, 1.01e-13);
  expect_within_error(hull, points, 1e-14);
}

TEST(HullReport, PointsOnASphere) {
  test::Random random(813);
  std::vector<Vec3> points;
  for (int i = 0; i < 2000; ++i) points.push_back((i % 4 == 0 ? 0.999 : 1) * random.rotation().x);
  const abut::Hull hull = hull_of(points);
  const HullReport& report = hull.report();
  EXPECT_EQ(report.point_count, 2000U);
  EXPECT_GE(report.vertex_count, 1500U);
  EXPECT_EQ(report.vertex_count + report.face_count, report.edge_count + 2);  // Euler
  EXPECT_EQ(report.error, 0);
  expect_within_error(hull, points, 1e-14);
}

// A hull of other points than those that it is asked about.
double error_of(const std::vector<Vec3>& built_of, const std::vector<Vec3>& asked) {
  return abut::report_on(abut::build_hull(built_of), asked, 1e-15).error;
}

TEST(HullReport, ErrorIsTheDistanceOfTheWorstPoint) {
  EXPECT_DOUBLE_EQ(error_of(cube, {{0, 0.5, 1.25}, {0.5, 1.5, 0}, {1.25, 0, 0}}), 0.5);  // faces
  EXPECT_DOUBLE_EQ(error_of(cube, {{0.5, 4, 5}}), 5);                                    // an edge
  EXPECT_DOUBLE_EQ(error_of(cube, {{2, 3, 3}}), 3);                                      // a corner
  const std::vector<Vec3> square{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
  EXPECT_DOUBLE_EQ(error_of(square, {{0.5, 0.5, 2.25}, {0, 0, 1.5}}), 0.5);
  EXPECT_DOUBLE_EQ(error_of(square, {{0.5, 1.75, 2}}), 0.75);
  EXPECT_DOUBLE_EQ(error_of(square, {{4, 5, 2}}), 5);
  const std::vector<Vec3> segment{{0, 0, 0}, {0, 0, 1}};
  EXPECT_DOUBLE_EQ(error_of(segment, {{3, 4, 0.5}}), 5);
  EXPECT_DOUBLE_EQ(error_of(segment, {{0, 0, -2}, {0, 0, 2}}), 2);
  EXPECT_DOUBLE_EQ(error_of({{1, 1, 1}}, {{1, 1, 1}, {1, 4, 5}}), 5);
}

TEST(HullReport, ErrorOfRandomCloudsIsThatOfTheOracle) {
  test::Random random(814);
  for (const Vec3& size : {Vec3{1, 1, 1}, Vec3{100, 1, 0.01}, Vec3{1, 1, 0}, Vec3{5, 0.1, 0}}) {
    for (const double margin : {0.0, 1e-9, 1e-3, 0.5}) {
      SCOPED_TRACE(std::to_string(size.x) + " " + std::to_string(size.z) + " " + std::to_string(margin));
      const abut::Pose pose{random.rotation(), random.point(1)};
      std::vector<Vec3> inside, all;
      for (int i = 0; i < 80; ++i) {
        const Vec3 p = random.rotation().x;
        const Vec3 q{size.x * p.x, size.y * p.y, size.z * p.z};
        inside.push_back(pose * q);
        all.push_back(pose * (random.uniform(0, 1 + margin) * q));
      }
      const abut::HullData hull = abut::build_hull(inside);
      const std::vector<Vec3> vertices(hull.vertices.begin(), hull.vertices.end());
      double worst = 0;
      for (const Vec3& p : all) worst = std::max(worst, distance_to_hull(vertices, p));
      EXPECT_NEAR(abut::report_on(hull, all, 1e-15 * size.x).error, worst, 1e-14 * size.x);
    }
  }
}

}  // namespace
