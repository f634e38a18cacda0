// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.cores.simplex;

namespace {

using abut::Vec3;
using Wide = std::array<long double, 3>;

constexpr long double nowhere = std::numeric_limits<long double>::infinity();
long double wide(double value) { return static_cast<long double>(value); }

long double dot(const Wide& a, const Wide& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The least distance from the origin to the affine hull of some points, where its foot lies among them:
// normal equations by Gauss in long double.
std::optional<long double> distance_to_hull(const std::vector<Wide>& points) {
  const std::size_t count = points.size() - 1;
  std::array<std::array<long double, 4>, 3> rows{};
  std::vector<Wide> edges;
  for (std::size_t i = 0; i < count; ++i) {
    edges.push_back(
        {points[i][0] - points[count][0], points[i][1] - points[count][1], points[i][2] - points[count][2]});
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      rows[i][j] = dot(edges[i], edges[j]);
    }
    rows[i][3] = -dot(edges[i], points[count]);
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) {
      if (std::fabs(rows[k][i]) > std::fabs(rows[i][i])) {
        std::swap(rows[i], rows[k]);
      }
    }
    if (rows[i][i] == 0) {
      return std::nullopt;
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (k != i) {
        const long double factor = rows[k][i] / rows[i][i];
        for (std::size_t j = 0; j < 4; ++j) {
          rows[k][j] -= factor * rows[i][j];
        }
      }
    }
  }
  Wide foot = points[count];
  long double rest = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const long double weight = rows[i][3] / rows[i][i];
    if (weight < 0) {
      return std::nullopt;
    }
    rest -= weight;
    for (std::size_t c = 0; c < 3; ++c) {
      foot[c] += weight * edges[i][c];
    }
  }
  return rest < 0 ? std::nullopt : std::optional(std::sqrt(dot(foot, foot)));
}

// Over all faces of the simplex.
long double brute_force(const std::vector<Vec3>& vertices) {
  long double best = nowhere;
  for (unsigned subset = 1; subset < 1u << vertices.size(); ++subset) {
    std::vector<Wide> points;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if ((subset >> i & 1u) != 0) {
        points.push_back({wide(vertices[i].x), wide(vertices[i].y), wide(vertices[i].z)});
      }
    }
    best = std::fmin(best, distance_to_hull(points).value_or(nowhere));
  }
  return best;
}

abut::Simplex simplex_of(const std::vector<Vec3>& vertices) {
  abut::Simplex simplex;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    simplex.push({vertices[i], 2 * vertices[i], i, i});
  }
  return simplex;
}

TEST(Simplex, ClosestPointOfRandomSimplices) {
  test::Random random(31);
  std::array<int, 16> faces_seen{};
  for (int i = 0; i < 8000; ++i) {
    std::vector<Vec3> vertices;
    const Vec3 offset = random.point(0.6);
    for (int k = 0; k <= i % 4; ++k) {
      vertices.push_back(random.point(1) + offset);
    }
    const abut::ClosestPoint found = abut::closest_to_origin(simplex_of(vertices));
    EXPECT_NEAR(abut::norm(found.point), static_cast<double>(brute_force(vertices)), 1e-13);
    ++faces_seen[found.vertices];
  }
  for (std::size_t face = 1; face < 16; ++face) {
    EXPECT_GT(faces_seen[face], 0) << face;
  }
}

// Without volume, area or length: whatever is named, its distance is right.
TEST(Simplex, ClosestPointOfDegenerateSimplices) {
  test::Random random(32);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.point(1), along = random.point(1), across = random.point(1);
    const double s = random.uniform(-2, 2), t = random.uniform(-2, 2);
    for (const std::vector<Vec3>& vertices : {
             std::vector<Vec3>{p, p},
             {p, p + along, p + s * along},
             {p, p, p + along},
             {p, p + along, p + across, p + s * along + t * across},
             {p, p + along, p + s * along, p + t * along},
             {p, p + along, p + across, p},
             {p, p, p, p},
         }) {
      const abut::ClosestPoint found = abut::closest_to_origin(simplex_of(vertices));
      EXPECT_NEAR(abut::norm(found.point), static_cast<double>(brute_force(vertices)), 1e-12);
    }
  }
}

// The distance of a plane is exact to the last digits even where the triangle is much larger.
TEST(Simplex, FootOnATriangleFarLargerThanItsDistance) {
  for (const double height : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const abut::ClosestPoint found =
        abut::closest_to_origin(simplex_of({{-3, -1, height}, {4, -1, height}, {0, 5, height}}));
    EXPECT_EQ(found.vertices, 7u);
    EXPECT_NEAR(abut::norm(found.point), height, 1e-15 * height);
  }
}

TEST(Simplex, KeepsTheVerticesThatSpanThePoint) {
  abut::Simplex simplex = simplex_of({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}});
  abut::keep(simplex, 0b1010);
  ASSERT_EQ(simplex.size, 2u);
  EXPECT_EQ(simplex.vertices[0].index_a, 1u);
  EXPECT_EQ(simplex.vertices[1].index_a, 3u);
}

TEST(Simplex, WitnessHasTheWeightsOfTheClosestPoint) {
  test::Random random(33);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Vec3> vertices;
    for (int k = 0; k <= i % 3; ++k) {
      vertices.push_back(random.point(1) + Vec3{0, 0, 2});
    }
    abut::Simplex simplex = simplex_of(vertices);
    const abut::ClosestPoint found = abut::closest_to_origin(simplex);
    abut::keep(simplex, found.vertices);
    // The points of a are twice those of the difference here.
    EXPECT_LE(abut::norm(abut::witness_on_a(simplex, found.point) - 2 * found.point), 1e-12);
  }
}

// Numbered vertices are told apart by their numbers; where a side has none, by their points.
TEST(Simplex, SameVerticesHaveTheSameNumbersOrPoints) {
  constexpr std::uint32_t none = abut::no_index;
  const auto at = [](const Vec3& w, std::uint32_t index_a, std::uint32_t index_b) {
    return abut::DifferenceVertex{w, {0, 0, 0}, index_a, index_b};
  };
  const Vec3 p{1, 2, 3}, q{1, 2, 3.0000000000000004};
  EXPECT_TRUE(at(p, 4, 7).is_same(at(p, 4, 7)));
  EXPECT_TRUE(at(p, 4, 7).is_same(at(q, 4, 7)));  // rounding of one point
  EXPECT_FALSE(at(p, 4, 7).is_same(at(p, 5, 7)));
  EXPECT_FALSE(at(p, 4, 7).is_same(at(p, 4, 8)));
  EXPECT_FALSE(at(p, 4, 7).is_same(at(p, 7, 4)));
  for (const auto& [a, b] : {std::pair{none, none}, std::pair{4u, none}, std::pair{none, 7u}}) {
    EXPECT_TRUE(at(p, a, b).is_same(at(p, a, b)));
    EXPECT_FALSE(at(p, a, b).is_same(at(q, a, b)));
    EXPECT_FALSE(at(p, a, b).is_same(at(p, 4, 7)));
    EXPECT_FALSE(at(p, 4, 7).is_same(at(p, a, b)));
  }
  abut::Simplex simplex;
  simplex.push(at(p, none, 7));
  EXPECT_TRUE(simplex.contains(at(p, none, 7)));
  EXPECT_FALSE(simplex.contains(at(q, none, 7)));
}

}  // namespace
