// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "../surfaces.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.mesh;

namespace {

using abut::Errc;
using abut::Mesh;
using abut::Vec3;

// A bumpy sheet over [-1, 1] squared, front up.
Mesh sheet(int cells, bool one_sided, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<double> numbers;
  std::vector<std::uint32_t> indices;
  const auto side = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      // Heights in eighths, so that some neighbours are exactly flat and none nearly so.
      const double height = 0.125 * std::floor(random.uniform(0, 4));
      numbers.insert(numbers.end(), {2.0 * i / cells - 1, 2.0 * j / cells - 1, height});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t k = j * side + i;
        indices.insert(indices.end(), {k, k + 1, k + side, k + 1, k + side + 1, k + side});
      }
    }
  }
  return test::made<Mesh>({one_sided ? 1.0 : 0.0}, numbers, indices);
}

TEST(Mesh, BadInputIsRefusedByName) {
  const std::vector<double> xyz{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> indices{0, 1, 2};
  test::expect_refused<Mesh>({3}, xyz, indices, Errc::unknown_value, "sides is 3;");
  test::expect_refused<Mesh>({0.5}, xyz, indices, Errc::unknown_value, "sides is 0.5;");
  test::expect_refused<Mesh>({}, xyz, indices, Errc::invalid_argument, "parameter_count is 0;");
  test::expect_refused<Mesh>({0}, {}, indices, Errc::empty, "vertex_count is 0;");
  test::expect_refused<Mesh>({0}, xyz, {}, Errc::empty, "triangle_count is 0;");
  test::expect_refused<Mesh>({0}, {1, 2, 3, 4}, indices, Errc::invalid_argument, "real_count is 4;");
  test::expect_refused<Mesh>({0}, xyz, {0, 1}, Errc::invalid_argument, "index_count is 2;");
  test::expect_refused<Mesh>({0}, xyz, {0, 1, 3}, Errc::index_out_of_range, "triangles[2] is 3;");
  test::expect_refused<Mesh>({0}, {0, 0, 0, 1, 0, std::numeric_limits<double>::infinity()}, {0, 1, 0}, Errc::not_finite,
                             "xyz[5] is inf;");
  test::expect_refused<Mesh>({0}, {0, 1e71, 0}, {0, 0, 0}, Errc::out_of_range, "xyz[1] is 1e+71;");
}

TEST(Mesh, KeepsItsTriangles) {
  const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
  const Mesh mesh = test::made<Mesh>({1}, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, indices);
  EXPECT_EQ(mesh.parameters(), (std::vector{1.0}));
  EXPECT_EQ(mesh.triangle_count(), 2u);
  EXPECT_EQ(mesh.triangles().indices, indices);
  EXPECT_EQ(mesh.triangles().vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_TRUE(mesh.part(1).is_one_sided());
  EXPECT_EQ(mesh.part(1).corners()[2], (Vec3{0, 1, 0}));
}

TEST(Mesh, BoxHoldsTheSurface) { test::expect_boxes_hold(sheet(6, false, 171), 172); }

TEST(Mesh, BoxLeavesOutVerticesOfNoTriangle) {
  const Mesh mesh = test::made<Mesh>({0}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 50, 50, 50}, {0, 1, 2});
  EXPECT_EQ(mesh.aabb(abut::Pose::identity()).high, (Vec3{1, 1, 0}));
}

TEST(Mesh, RaysSlipThroughNoEdgeOrVertex) {
  for (const double distance : {1.0, 1e3, 1e6}) {
    test::expect_no_gaps(sheet(12, false, 175), distance, 176);
  }
}

TEST(Mesh, PartsAreThoseWhoseBoxesOverlap) { test::expect_parts(sheet(12, false, 173), {0, 0, 0.2}, {1, 1, 0.3}, 174); }

TEST(Mesh, RaysMeetTheFirstTriangle) {
  test::expect_first_triangle(sheet(12, false, 175), {0, 0, 0.2}, {1, 1, 0.5}, 176, 500);
  test::expect_first_triangle(sheet(12, true, 177), {0, 0, 0.2}, {1, 1, 0.5}, 178, 500);
}

TEST(Mesh, CrestsAreWhereNothingAroundRises) {
  test::expect_crests(sheet(10, false, 179), 279, 300);
  test::expect_crests(
      test::made<Mesh>({0}, {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1}, {0, 1, 3, 0, 3, 2, 0, 2, 1, 1, 2, 3}), 280, 5);
}

// All three triangles at the edge count: the third one rises.
TEST(Mesh, CrestOfThreeTrianglesLooksAtAll) {
  const Mesh mesh = test::made<Mesh>({0}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -1, 0, 0, 0, 1}, {0, 1, 2, 1, 0, 3, 0, 1, 4});
  EXPECT_FALSE(mesh.is_crest(0, 3, {0, 0, 1}, 1e-12));
  EXPECT_FALSE(mesh.is_crest(1, 3, {0, 0, 1}, 1e-12));
  EXPECT_TRUE(mesh.is_crest(0, 3, {0, 0, -1}, 1e-12));
  EXPECT_TRUE(mesh.is_crest(2, 4, {0, 0, 1}, 1e-12));
  const Mesh before =
      test::made<Mesh>({0}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, -1, 0, 0, 0, 1}, {0, 1, 2, 0, 1, 4, 1, 0, 3});
  EXPECT_FALSE(before.is_crest(0, 3, {0, 0, 1}, 1e-12));
  EXPECT_FALSE(before.is_crest(2, 3, {0, 0, 1}, 1e-12));
}

TEST(Mesh, TreeIsMadeWhenItIsNeeded) {
  const Mesh mesh = sheet(4, false, 180), copy = mesh;
  static_cast<void>(mesh.aabb(abut::Pose::identity()));
  EXPECT_FALSE(mesh.has_tree());
  static_cast<void>(mesh.cast_ray({0, 0, 5}, abut::UnitVec3::axis_z(), 1));
  EXPECT_TRUE(mesh.has_tree());
  EXPECT_TRUE(copy.has_tree());  // copies share what was made
}

TEST(Mesh, PartNearAPointOnATriangleIsNear) {
  const Mesh mesh = sheet(8, false, 181);
  for (std::uint32_t k = 0; k < mesh.triangle_count(); ++k) {
    const Vec3 point = mesh.part(k).centre();
    const abut::Triangle near = mesh.part_near(point);
    EXPECT_LE(norm(near.centre() - point), 1.0);  // four cells
  }
}

TEST(Mesh, TrianglesWithoutAreaAreKeptAndNeverHit) {
  const Mesh mesh = test::made<Mesh>({0}, {0, 0, 0, 1, 0, 0, 2, 0, 0}, {0, 1, 2});
  EXPECT_EQ(mesh.triangle_count(), 1u);
  EXPECT_FALSE(mesh.part(0).has_area());
  EXPECT_FALSE(mesh.cast_ray({0.5, 0, 3}, -abut::UnitVec3::axis_z(), 10).has_value());
}

TEST(Mesh, RaysAlongAnAxisMeetTheWholeSheetWithItsBorder) {
  const Mesh mesh = test::made<Mesh>({0}, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, {0, 1, 2, 0, 2, 3});
  for (const double x : {0.0, 0.5, 1.0}) {
    for (const double y : {0.0, 0.25, 1.0}) {
      EXPECT_TRUE(mesh.cast_ray({x, y, 3}, -abut::UnitVec3::axis_z(), 10).has_value()) << x << " " << y;
      EXPECT_TRUE(mesh.cast_ray({x, y, -3}, abut::UnitVec3::axis_z(), 10).has_value()) << x << " " << y;
    }
  }
}

}  // namespace
