// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
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

struct Buffers {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;

  std::uint32_t add(const Vec3& p) {
    xyz.insert(xyz.end(), {p.x, p.y, p.z});
    return static_cast<std::uint32_t>(xyz.size() / 3 - 1);
  }
};

constexpr std::uint32_t side = 13;

// Uneven terrain with a bridge, a wall that stands upright, a heap of small triangles in one place, and one triangle
// that spans everything.
Buffers landscape(std::uint64_t seed) {
  test::Random random(seed);
  Buffers out;
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      out.add({0.25 * i - 1.5, 0.25 * j - 1.5, 0.125 * std::floor(random.uniform(-3, 3))});
      if (i + 1 < side && j + 1 < side) {
        const std::uint32_t k = j * side + i;
        out.triangles.insert(out.triangles.end(), {k, k + 1, k + side + 1, k, k + side + 1, k + side});
      }
    }
  }
  const std::uint32_t a = out.add({-1.2, -0.3, 0.8}), b = out.add({1.2, -0.3, 0.8}), c = out.add({1.2, 0.3, 0.9}),
                      d = out.add({-1.2, 0.3, 0.9});
  out.triangles.insert(out.triangles.end(), {a, b, c, a, c, d});
  const std::uint32_t low = out.add({0.4, -1.3, -0.9}), far = out.add({0.4, 1.3, -0.9}), top = out.add({0.4, 0, 0.7});
  out.triangles.insert(out.triangles.end(), {low, far, top});
  for (std::uint32_t k = 0; k < 60; ++k) {
    const Vec3 at = Vec3{0.7, 0.7, 0.3} + random.point(0.05);
    const std::uint32_t first = out.add(at);
    out.add(at + random.point(0.02));
    out.add(at + random.point(0.02));
    out.triangles.insert(out.triangles.end(), {first, first + 1, first + 2});
  }
  const std::uint32_t whole = out.add({-1.5, -1.5, -0.95});
  out.add({1.5, -1.5, -0.95});
  out.add({1.5, 1.5, -0.95});
  out.triangles.insert(out.triangles.end(), {whole, whole + 1, whole + 2});
  return out;
}
constexpr Vec3 middle{0, 0, 0}, extent{1.5, 1.5, 1};

// By axes and cells.
class UvGridOf : public testing::TestWithParam<std::vector<double>> {
 protected:
  [[nodiscard]] static Mesh grid(std::uint64_t seed) {
    const Buffers buffers = landscape(seed);
    return test::made<UvGrid>(GetParam(), buffers.xyz, buffers.triangles);
  }
};
INSTANTIATE_TEST_SUITE_P(Settings, UvGridOf,
                         testing::Values(std::vector<double>{0, 0, 1, 0, 0}, std::vector<double>{0, 0, 1, 100, 100},
                                         std::vector<double>{1, 1, 2, 7, 1}, std::vector<double>{0, 2, 0, 0, 3},
                                         std::vector<double>{0, 0, 1, 1, 1}),
                         [](const auto& given) { return "Plan" + std::to_string(given.index); });

TEST_P(UvGridOf, PartsAreThoseWhoseBoxesOverlap) { test::expect_parts(grid(601), middle, extent, 602); }
TEST_P(UvGridOf, PartsBelowAreThoseThatReachDown) { test::expect_below(grid(603), 3, 604); }
TEST_P(UvGridOf, RaysMeetTheFirstTriangle) { test::expect_first_triangle(grid(605), middle, extent, 606, 500); }
TEST_P(UvGridOf, CrestsAreWhereNothingAroundRises) { test::expect_crests(grid(607), 608, 300); }
TEST_P(UvGridOf, RaysSlipThroughNoEdgeOrVertex) { test::expect_no_gaps(grid(609), 10, 610); }
TEST_P(UvGridOf, BoxHoldsTheSurface) { test::expect_boxes_hold(grid(611), 612); }
TEST_P(UvGridOf, KeepsItsParameters) { EXPECT_EQ(grid(613).parameters(), GetParam()); }
TEST_P(UvGridOf, PartNearAPointIsNearerThanMost) {
  const Mesh some = grid(614);
  for (std::uint32_t k = 0; k < some.triangle_count(); ++k) {
    const Vec3 centre = some.part(k).centre();
    const abut::Aabb found = some.part_near(centre).box();
    const Vec3 beyond = maximum(maximum(found.low - centre, centre - found.high), {0, 0, 0});
    EXPECT_LT(norm(beyond), 3.5);
  }
}

TEST(UvGrid, BadInputIsRefusedByName) {
  const std::vector<double> xyz{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<std::uint32_t> one{0, 1, 2};
  test::expect_refused<UvGrid>({3, 0, 1, 0, 0}, xyz, one, Errc::unknown_value, "sides is 3;");
  test::expect_refused<UvGrid>({0, 3, 1, 0, 0}, xyz, one, Errc::unknown_value, "axis_u is 3;");
  test::expect_refused<UvGrid>({0, 0, 0.5, 0, 0}, xyz, one, Errc::unknown_value, "axis_v is 0.5;");
  test::expect_refused<UvGrid>({0, 1, 1, 0, 0}, xyz, one, Errc::out_of_range, "axis_v is 1;");
  test::expect_refused<UvGrid>({0, 0, 1, -1, 0}, xyz, one, Errc::out_of_range, "cells_u is -1;");
  test::expect_refused<UvGrid>({0, 0, 1, 0, 65536}, xyz, one, Errc::out_of_range, "cells_v is 65536;");
  test::expect_refused<UvGrid>({0, 0, 1, 5000, 5000}, xyz, one, Errc::out_of_range, "cells_u * cells_v is");
  test::expect_refused<UvGrid>({0, 0, 1, 0, 0}, xyz, {0, 1, 3}, Errc::index_out_of_range, "triangles[2] is 3;");
  test::expect_refused<UvGrid>({0, 0, 1, 0, 0}, {}, one, Errc::empty, "vertex_count is 0;");
  test::expect_refused<UvGrid>({0, 0, 1, 0}, xyz, one, Errc::invalid_argument, "parameter_count is 4;");
}

// All triangles stand upright over one line, or are one point. A triangle that names one vertex three times is not
// there.
TEST(UvGrid, WithoutExtentAcrossItsAxesAnswersToo) {
  const Mesh wall = test::made<UvGrid>({0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1}, {0, 1, 2, 1, 3, 2});
  EXPECT_TRUE(wall.cast_ray({-1, 0.5, 0.25}, abut::UnitVec3::make({1, 0, 0}).value(), 10).has_value());
  const Mesh point = test::made<UvGrid>({0, 0, 1, 100, 100}, {1, 2, 3, 1, 2, 3, 1, 2, 3}, {0, 1, 2});
  abut::Aabb box{{0, 0, 0}, {4, 4, 4}};
  int parts = 0;
  point.visit_parts(box, [&](const abut::Triangle&, std::uint32_t) { ++parts; });
  EXPECT_EQ(parts, 1);
  const Mesh gap = test::made<UvGrid>({0, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2, 1, 1, 1});
  parts = 0;
  gap.visit_parts(box, [&](const abut::Triangle&, std::uint32_t) { ++parts; });
  EXPECT_EQ(parts, 1);
}

// A tetrahedron that is declared solid encloses as its mesh does.
TEST(UvGrid, MayBeSolid) {
  const Mesh solid =
      test::made<UvGrid>({2, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  EXPECT_TRUE(solid.is_solid());
  EXPECT_TRUE(solid.contains({0.2, 0.2, 0.2}));
  EXPECT_FALSE(solid.contains({0.5, 0.5, 0.5}));
  EXPECT_EQ(solid.parameters().front(), 2);
  EXPECT_FALSE(test::made<UvGrid>({0, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 2}).is_solid());
}

}  // namespace
