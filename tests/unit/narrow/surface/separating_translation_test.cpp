// SPDX-License-Identifier: Apache-2.0
// The shortest translation out of a surface: nothing is overlapped after it, and no other direction is shorter.
// The numbers of triangles do not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../../made.hpp"
#include "../../random_boxes.hpp"

import abut.capability;
import abut.math;
import abut.narrow.convex;
import abut.narrow.surface.separating_translation;
import abut.narrow.surface.triangle_source;
import abut.shapes.box;
import abut.shapes.capsule;
import abut.shapes.ellipsoid;
import abut.shapes.mesh;
import abut.shapes.sphere;

namespace {

using abut::Mesh;
using abut::Pose;
using abut::Triangle;
using abut::Vec3;

constexpr int cells = 12;

// Waves over [-2, 2]^2, whose triangles come in an order of their own.
Mesh waves(test::Random& random, bool is_shuffled) {
  std::vector<double> xyz;
  std::vector<std::uint32_t> indices;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const double x = -2 + 4.0 * i / cells, y = -2 + 4.0 * j / cells;
      xyz.insert(xyz.end(), {x, y, 0.3 * std::sin(2 * x) * std::cos(1.5 * y)});
    }
  }
  std::vector<std::uint32_t> order;
  for (std::uint32_t cell = 0; cell < cells * cells; ++cell) {
    order.push_back(cell);
  }
  if (is_shuffled) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)))]);
    }
  }
  for (const std::uint32_t cell : order) {
    const std::uint32_t k = cell / cells * (cells + 1) + cell % cells;
    indices.insert(indices.end(), {k, k + 1, k + cells + 2, k, k + cells + 2, k + cells + 1});
  }
  return test::made<Mesh>({0}, xyz, indices);
}

template <class B>
double deepest_overlap(const Mesh& mesh, const B& b, const Pose& at) {
  double least = 0;
  for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) {
    abut::Distance found{};
    EXPECT_EQ(convex_distance(mesh.part(i), b, at, abut::QuerySettings{}, found), abut::Outcome::ok);
    least = std::min(least, found.distance);
  }
  return least;
}

// The first multiple of a hundredth along a direction after which nothing is overlapped: no translation found may be
// longer.
template <class B>
double walked(const Mesh& mesh, const B& b, const Pose& ab, const Vec3& direction, double most) {
  const auto overlaps = [&](double length) {
    return deepest_overlap(mesh, b, {ab.rotation, ab.position + length * direction}) < -1e-7;
  };
  for (double length = 0; length < most; length += 0.01) {
    if (!overlaps(length)) {
      return length;
    }
  }
  return most;
}

template <class B>
void check(const B& b, std::uint64_t seed) {
  test::Random random(seed);
  const Mesh mesh = waves(random, false), shuffled = waves(random, true);
  const abut::SourceOf<Mesh> source(mesh), other(shuffled);
  const abut::QuerySettings settings;
  int overlapping = 0;
  for (int scene = 0; scene < 12; ++scene) {
    const Pose ab{random.rotation(), {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.2, 0.6)}};
    abut::SurfaceSearch<B> search(source, b, ab, settings, 0, abut::StoppingSides::both),
        again(other, b, ab, settings, 0, abut::StoppingSides::both);
    ASSERT_EQ(search.is_overlapped(), again.is_overlapped());
    if (!search.is_overlapped()) {
      continue;
    }
    ++overlapping;
    const auto about = [&] { return testing::Message() << "scene " << scene << " of seed " << seed; };
    const abut::SeparatingTranslation found = search.find();
    const Pose after{ab.rotation, ab.position + found.length * found.direction};
    EXPECT_GE(deepest_overlap(mesh, b, after), -1e-9) << about();
    EXPECT_GE(found.length, found.least - 1e-9) << about();
    EXPECT_FALSE(found.touches.empty()) << about();
    EXPECT_NEAR(again.find().length, found.length, 1e-9) << about();
    for (int i = 0; i < 8; ++i) {
      const Vec3 d = random.point(1) + found.direction;
      EXPECT_LE(found.length, walked(mesh, b, ab, (1 / norm(d)) * d, 2 * found.length) + 1e-6) << about();
    }
  }
  EXPECT_GT(overlapping, 4) << "seed " << seed;
}

TEST(SeparatingTranslation, LeavesNothingOverlapped) {
  check(core_of(test::made<abut::Sphere>({0.5})), 1);
  check(core_of(test::made<abut::Capsule>({0.2, 0.5})), 2);
  check(core_of(test::made<abut::Box>({0.5, 0.35, 0.02})), 3);
  check(core_of(test::made<abut::Ellipsoid>({0.5, 0.3, 0.2})), 4);
}

}  // namespace
