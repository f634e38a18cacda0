// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "surfaces.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.mesh;

namespace {

using abut::Errc;
using abut::Mesh;
using abut::UvGrid;
using abut::Vec3;

constexpr std::uint32_t side = 9;

// A sheet, with a second one over it, and a heap of triangles that share no vertex in one place.
struct Ground {
  std::vector<double> parameters, xyz;
  std::vector<std::uint32_t> triangles;

  explicit Ground(std::vector<double> settings) : parameters(std::move(settings)) {
    test::Random random(701);
    for (const double z : {0.0, 1.0}) {
      const auto first = static_cast<std::uint32_t>(xyz.size() / 3);
      for (std::uint32_t j = 0; j < side; ++j) {
        for (std::uint32_t i = 0; i < side; ++i) {
          xyz.insert(xyz.end(), {0.25 * i - 1, 0.25 * j - 1, z + 0.125 * std::floor(random.uniform(-4, 4))});
          if (i + 1 < side && j + 1 < side) {
            const std::uint32_t k = first + j * side + i;
            triangles.insert(triangles.end(), {k, k + 1, k + side + 1, k, k + side + 1, k + side});
          }
        }
      }
    }
    for (std::uint32_t k = 0; k < 40; ++k) {
      const auto first = static_cast<std::uint32_t>(xyz.size() / 3);
      for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const Vec3 p = Vec3{0.3, 0.4, 0.5} + random.point(0.05);
        xyz.insert(xyz.end(), {p.x, p.y, p.z});
        triangles.push_back(first + corner);
      }
    }
  }
  [[nodiscard]] Mesh make() const { return test::made<UvGrid>(parameters, xyz, triangles); }
};

template <class E>
void change(Mesh& grid, const E& edit) {
  ASSERT_FALSE(grid.check(edit).has_value());
  grid.own();
  grid.make_room(edit);
  static_cast<void>(grid.apply(edit));
}

void expect_as_its_triangles(const Mesh& grid, std::uint64_t seed) {
  test::expect_parts(grid, {0, 0, 0.5}, {1, 1, 1.5}, seed);
  test::expect_below(grid, 3, seed + 1);
  test::expect_first_triangle(grid, {0, 0, 0.5}, {1, 1, 1}, seed + 2, 100);
  test::expect_crests(grid, seed + 3, 100);
}

class UvGridEdits : public testing::TestWithParam<std::vector<double>> {};
INSTANTIATE_TEST_SUITE_P(Settings, UvGridEdits,
                         testing::Values(std::vector<double>{0, 0, 1, 0, 0}, std::vector<double>{1, 1, 0, 40, 40},
                                         std::vector<double>{0, 0, 1, 2, 2}),
                         [](const auto& given) { return "Plan" + std::to_string(given.index); });

TEST_P(UvGridEdits, AnswersAsItsTrianglesAfterTwoThousandChanges) {
  constexpr std::uint64_t seed = 702;
  test::Random random(seed);
  Ground ground(GetParam());
  Mesh grid = ground.make();
  const auto vertices = static_cast<double>(ground.xyz.size() / 3), all = static_cast<double>(grid.triangle_count());
  std::size_t removed = 0;
  for (int round = 0; round < 2000; ++round) {
    if (round % 20 == 0 && removed < grid.triangle_count() / 2) {
      const auto triangle = static_cast<std::uint32_t>(random.uniform(0, all));
      const auto own = std::span(ground.triangles).subspan(std::size_t{3} * triangle, 3);
      removed += own[0] == own[1] ? 0 : 1;
      change(grid, abut::RemovalEdit{std::array{triangle}});
      own[1] = own[2] = own[0];
    } else {
      const auto vertex = static_cast<std::uint32_t>(random.uniform(0, vertices));
      const double height = 0.125 * std::floor(random.uniform(-4, 12));
      const std::array place{ground.xyz[std::size_t{3} * vertex], ground.xyz[std::size_t{3} * vertex + 1], height};
      change(grid, abut::VertexEdit{vertex, {}, place});
      ground.xyz[std::size_t{3} * vertex + 2] = height;
    }
    if (round % 1000 == 999) {
      expect_as_its_triangles(grid, seed + static_cast<std::uint64_t>(round));
    }
  }
  EXPECT_EQ(grid.buffers().reals, ground.xyz);
  const Mesh anew = ground.make();
  EXPECT_EQ(grid.aabb(abut::Pose::identity()).low, anew.aabb(abut::Pose::identity()).low);
  EXPECT_EQ(grid.aabb(abut::Pose::identity()).high, anew.aabb(abut::Pose::identity()).high);
}

// Nothing outside of the box that a change answers with meets anything else.
TEST_P(UvGridEdits, TellWhereTheyChange) {
  test::Random random(703);
  Mesh grid = Ground(GetParam()).make();
  const std::uint32_t vertex = 4 * side + 4;
  const abut::Triangles before = grid.triangles();
  const std::array place{before.vertices[vertex].x, before.vertices[vertex].y, before.vertices[vertex].z + 0.01};
  const abut::VertexEdit edit{vertex, {}, place};
  grid.own();
  grid.make_room(edit);
  const abut::Aabb changed = grid.apply(edit);
  EXPECT_TRUE(changed.is_bounded());
  const abut::Triangles after = grid.triangles();
  for (const abut::Vec3& p : {before.vertices[vertex], after.vertices[vertex]}) {
    EXPECT_TRUE(changed.overlaps(abut::Aabb{p, p}));
  }
  EXPECT_LT(changed.high.x - changed.low.x, 1.01);
}

TEST_P(UvGridEdits, RefuseMotionsAcross) {
  const Ground ground(GetParam());
  Mesh grid = ground.make();
  const std::array places{ground.xyz[9], ground.xyz[10], 4.0, ground.xyz[12], ground.xyz[13] + 0.5, 4.0};
  const abut::Fault fault = grid.check(abut::VertexEdit{3, {}, places});
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code, Errc::out_of_range);
  EXPECT_NE(fault->message.find("xyz[4] is"), std::string::npos) << fault->message;
  EXPECT_NE(fault->message.find("along Z only"), std::string::npos) << fault->message;
}

// All triangles over one place, and all of the heap.
TEST_P(UvGridEdits, EmptyCells) {
  Mesh grid = Ground(GetParam()).make();
  std::vector<std::uint32_t> going;
  abut::Aabb place{{0, 0, -5}, {0.6, 0.6, 5}};
  grid.visit_parts(place, [&](const abut::Triangle&, std::uint32_t index) { going.push_back(index); });
  ASSERT_GT(going.size(), 40u);
  change(grid, abut::RemovalEdit{going});
  int left = 0;
  grid.visit_parts(place, [&](const abut::Triangle&, std::uint32_t) { ++left; });
  EXPECT_EQ(left, 0);
  EXPECT_FALSE(grid.cast_ray({0.3, 0.3, 9}, -abut::UnitVec3::axis_z(), 20).has_value());
  EXPECT_TRUE(grid.cast_ray({-0.7, -0.7, 9}, -abut::UnitVec3::axis_z(), 20).has_value());
  expect_as_its_triangles(grid, 704);
}

TEST_P(UvGridEdits, KeepOneTriangle) {
  Mesh grid = Ground(GetParam()).make();
  std::vector<std::uint32_t> all(grid.triangle_count());
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    all[k] = k;
  }
  const abut::Fault fault = grid.check(abut::RemovalEdit{all});
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->code, Errc::empty);
}

TEST_P(UvGridEdits, MakeItAnew) {
  Mesh grid = Ground(GetParam()).make();
  const std::array<double, 9> xyz{0, 0, 1, 2, 0, 1, 0, 2, 1};
  const std::array<std::uint32_t, 3> triangle{0, 1, 2};
  change(grid, abut::RecreationEdit{xyz, triangle});
  EXPECT_EQ(grid.triangle_count(), 1u);
  EXPECT_EQ(grid.parameters(), GetParam());
  const auto hit = grid.cast_ray({0.5, 0.5, 4}, -abut::UnitVec3::axis_z(), 10);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->distance, 3);
}

// A copy is another holder: it stays as it was.
TEST_P(UvGridEdits, LeaveCopiesAsTheyWere) {
  Mesh grid = Ground(GetParam()).make();
  const Mesh copy = grid;
  change(grid, abut::RemovalEdit{std::array{std::uint32_t{0}}});
  EXPECT_NE(grid.triangles().indices, copy.triangles().indices);
  expect_as_its_triangles(copy, 705);
  expect_as_its_triangles(grid, 706);
}

}  // namespace
