// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "../../../oracle/winding.hpp"
#include "../../damaged_meshes.hpp"

import abut.math;
import abut.trees.inside.winding_number;

namespace {

using abut::Vec3;
using abut::WindingNumber;

std::vector<Vec3> vertices_of(const test::Surface& surface) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < surface.xyz.size(); i += 3) {
    out.push_back({surface.xyz[i], surface.xyz[i + 1], surface.xyz[i + 2]});
  }
  return out;
}

WindingNumber tree_of(const test::Surface& surface) { return {vertices_of(surface), surface.triangles}; }

long double true_number(const test::Surface& surface, const Vec3& p) {
  return oracle::winding_number(surface.xyz, surface.triangles,
                                {oracle::quad(p.x), oracle::quad(p.y), oracle::quad(p.z)});
}

// Points of three kinds: anywhere in a box around a surface, near it, and next to its edges.
std::vector<Vec3> points_about(const test::Surface& surface, std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const std::vector<Vec3> vertices = vertices_of(surface);
  Vec3 low = vertices[0], high = vertices[0];
  for (const Vec3& vertex : vertices) {
    low = abut::minimum(low, vertex);
    high = abut::maximum(high, vertex);
  }
  const Vec3 size = high - low;
  const auto anywhere = [&](double scale) {
    return scale * Vec3{size.x * (share(random) - 0.5), size.y * (share(random) - 0.5), size.z * (share(random) - 0.5)};
  };
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto triangle = static_cast<std::size_t>(share(random) * static_cast<double>(surface.triangle_count()));
    const Vec3 a = vertices[surface.triangles[3 * triangle]], b = vertices[surface.triangles[3 * triangle + 1]];
    const double along = share(random);
    points.push_back(i % 3 == 0   ? 0.5 * (low + high) + anywhere(1.2)
                     : i % 3 == 1 ? a + anywhere(0.02)
                                  : a + along * (b - a) + anywhere(1e-9));
  }
  return points;
}

// Where the true number is not at one half, the side is right; the estimate keeps its error.
void expect_numbers(const test::Surface& surface, std::size_t count, std::uint32_t seed) {
  const WindingNumber tree = tree_of(surface);
  std::size_t inside = 0;
  for (const Vec3& point : points_about(surface, count, seed)) {
    const auto number = static_cast<double>(true_number(surface, point));
    SCOPED_TRACE(::testing::Message() << "seed " << seed << " at " << point.x << ' ' << point.y << ' ' << point.z);
    if (std::abs(number - 0.5) > 1e-6) {
      EXPECT_EQ(tree.contains(point), number > 0.5) << number;
    }
    for (const double most_error : {1.0, 1e-2, 1e-5}) {
      const auto [found, error] = tree.at(point, most_error);
      EXPECT_LE(error, most_error);
      EXPECT_LE(std::abs(found - number), error);
    }
    EXPECT_NEAR(tree.at(point, 0).number, number, 1e-8);
    inside += number > 0.5;
  }
  EXPECT_GT(inside, count / 10);
  EXPECT_LT(inside, count);
}

TEST(WindingNumber, IsThatOfAllSolidAnglesTogether) { expect_numbers(test::torus(2, 0.7, 40, 20), 150, 1); }

TEST(WindingNumber, TellsInsideOfDamagedSurfaces) {
  const test::Surface whole = test::torus(2, 0.7, 32, 16);
  for (const double share : {0.005, 0.02, 0.05}) {
    for (std::uint32_t seed = 1; seed <= 2; ++seed) {
      expect_numbers(test::damaged(whole, share, seed), 60, seed);
    }
  }
}

TEST(WindingNumber, KeepsItsDigitsAtAnySizeAndPlace) {
  for (const double scale : {1e-6, 1e-3, 1e6}) {
    test::Surface surface = test::torus(2, 0.7, 24, 12);
    for (double& number : surface.xyz) {
      number = scale * number + 1000 * scale;
    }
    expect_numbers(surface, 90, 7);
  }
}

// Few triangles do not fill a block.
TEST(WindingNumber, CountsFewTriangles) {
  EXPECT_FALSE(WindingNumber().contains({0, 0, 0}));
  test::Surface surface{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  expect_numbers(surface, 300, 3);
  surface.triangles.resize(6);
  const WindingNumber open = tree_of(surface);
  EXPECT_NEAR(open.at({0.1, 0.1, 0.1}, 0).number, static_cast<double>(true_number(surface, {0.1, 0.1, 0.1})), 1e-14);
  EXPECT_FALSE(open.contains({1e12, 0, 0}));
}

// From a face half of it is seen on either side, from a vertex or an edge as much as the angle there leaves.
TEST(WindingNumber, IsOneHalfOnAFace) {
  const test::Surface surface{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  const WindingNumber tree = tree_of(surface);
  EXPECT_DOUBLE_EQ(tree.at({0.25, 0.25, 0}, 0).number, 0.5);
  EXPECT_FALSE(tree.contains({0.25, 0.25, 0}));
  EXPECT_DOUBLE_EQ(tree.at({0, 0.25, 0}, 0).number, 0.25);
  EXPECT_DOUBLE_EQ(tree.at({0, 0, 0}, 0).number, 0.125);
}

// Exterior points close to the edges and vertices of a sharp tetrahedron, where normals of faces tell the wrong side.
TEST(WindingNumber, TellsTheOutsideOfSharpEdges) {
  const test::Surface surface{{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.4, 0.4, 0.05}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  const WindingNumber tree = tree_of(surface);
  for (const double beyond : {1e-2, 1e-6, 1e-12}) {
    EXPECT_FALSE(tree.contains({0.5 + beyond, 0.5 + beyond, 1e-13}));
    EXPECT_FALSE(tree.contains({0.5 + beyond, 0.5 + beyond, -1e-13}));
    EXPECT_FALSE(tree.contains({1 + beyond, 0, 0}));
    EXPECT_FALSE(tree.contains({1 + beyond, -beyond, beyond}));
    EXPECT_TRUE(tree.contains({0.4, 0.4, 0.05 - 0.06 * beyond}));
  }
}

// The tree after edits of a few vertices each, beside one that is made anew. Some throw a vertex far out, and some take
// the whole elsewhere.
TEST(WindingNumber, FollowsVerticesThatMove) {
  constexpr std::uint32_t seed = 11;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1, 1);
  test::Surface surface = test::torus(2, 0.7, 40, 20);
  WindingNumber moved = tree_of(surface);
  const auto follow = [&](std::size_t vertex) {
    const std::vector<Vec3> vertices = vertices_of(surface);
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (surface.triangles[3 * triangle + corner] == vertex) {
          moved.move(triangle, vertices);
        }
      }
    }
  };
  const auto check = [&] {
    moved.settle();
    const WindingNumber anew = tree_of(surface);
    for (const Vec3& point : points_about(surface, 60, seed)) {
      EXPECT_EQ(moved.contains(point), anew.contains(point));
      const auto number = static_cast<double>(true_number(surface, point));
      for (const double most_error : {1e-2, 1e-5}) {
        const auto [found, error] = moved.at(point, most_error);
        EXPECT_LE(std::abs(found - number), error);
      }
      EXPECT_NEAR(moved.at(point, 0).number, number, 1e-8);
    }
  };
  for (int edit = 0; edit < 12; ++edit) {
    const double reach = edit % 4 == 3 ? 100 : 0.2;
    for (int i = 0; i < 3; ++i) {
      const std::size_t vertex = random() % (surface.xyz.size() / 3);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        surface.xyz[3 * vertex + axis] += reach * share(random);
      }
      follow(vertex);
    }
    check();
  }
  for (std::size_t vertex = 0; vertex < surface.xyz.size() / 3; ++vertex) {
    surface.xyz[3 * vertex] = 300 * surface.xyz[3 * vertex] + 0.2 * surface.xyz[3 * vertex + 1] + 5000;
    follow(vertex);
  }
  check();
}

// Where all triangles change places, few groups are small any more.
TEST(WindingNumber, NoticesThatItIsWorn) {
  test::Surface surface = test::torus(2, 0.7, 40, 20);
  WindingNumber tree = tree_of(surface);
  EXPECT_FALSE(tree.is_worn());
  const std::vector<Vec3> before = vertices_of(surface);
  const auto place = [&](auto&& place_of) {
    std::vector<Vec3> vertices(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      vertices[i] = place_of(i);
    }
    for (std::uint32_t triangle = 0; triangle < surface.triangle_count(); ++triangle) {
      tree.move(triangle, vertices);
    }
    tree.settle();
  };
  place([&](std::size_t i) { return 3 * before[i] + Vec3{1, 2, 3}; });
  EXPECT_FALSE(tree.is_worn()) << "larger, but the same";
  std::vector<std::size_t> order(before.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  place([&](std::size_t i) { return before[order[i]]; });
  EXPECT_TRUE(tree.is_worn());
}

TEST(WindingNumber, IsReadByThreadsAtOnce) {
  const test::Surface surface = test::torus(2, 0.7, 40, 20);
  const WindingNumber tree = tree_of(surface);
  const std::vector<Vec3> points = points_about(surface, 600, 5);
  const auto numbers = [&] {
    std::vector<double> out;
    for (const Vec3& point : points) {
      out.push_back(tree.at(point, 1e-3).number);
    }
    return out;
  };
  const std::vector<double> alone = numbers();
  std::vector<double> first, second;
  std::thread one([&] { first = numbers(); }), two([&] { second = numbers(); });
  one.join();
  two.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

}  // namespace
