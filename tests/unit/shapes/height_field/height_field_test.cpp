// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../surfaces.hpp"

import abut.capability;
import abut.core;
import abut.math;
import abut.shapes.height_field;

namespace {

using abut::Errc;
using abut::HeightField;
using abut::Vec3;

constexpr std::uint32_t columns = 9, rows = 7;
constexpr double spacing_x = 0.5, spacing_y = 0.75;

// Heights in eighths: second differences are exact, and some of them zero.
HeightField hills(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<double> heights;
  for (std::uint32_t k = 0; k < columns * rows; ++k) {
    heights.push_back(0.125 * std::floor(random.uniform(-4, 4)));
  }
  return test::made<HeightField>({columns, rows, spacing_x, spacing_y}, heights);
}
constexpr Vec3 middle{0.5 * (columns - 1) * spacing_x, 0.5 * (rows - 1) * spacing_y, 0},
    extent{middle.x, middle.y, 0.5};

TEST(HeightField, BadInputIsRefusedByName) {
  const std::vector<double> four{0, 0, 0, 0};
  test::expect_refused<HeightField>({0, 2, 1, 1}, four, {}, Errc::empty, "columns is 0;");
  test::expect_refused<HeightField>({1, 2, 1, 1}, four, {}, Errc::out_of_range, "columns is 1;");
  test::expect_refused<HeightField>({2, 65536, 1, 1}, four, {}, Errc::out_of_range, "rows is 65536;");
  test::expect_refused<HeightField>({2, 2.5, 1, 1}, four, {}, Errc::out_of_range, "rows is 2.5;");
  test::expect_refused<HeightField>({2, 2, 0, 1}, four, {}, Errc::out_of_range, "spacing_x is 0;");
  test::expect_refused<HeightField>({2, 2, 1, -3}, four, {}, Errc::out_of_range, "spacing_y is -3;");
  test::expect_refused<HeightField>({2, 2, 1, std::numeric_limits<double>::infinity()}, four, {}, Errc::not_finite,
                                    "spacing_y is inf;");
  test::expect_refused<HeightField>({2, 2, 1}, four, {}, Errc::invalid_argument, "parameter_count is 3;");
  test::expect_refused<HeightField>({2, 3, 1, 1}, four, {}, Errc::invalid_argument, "real_count is 4;");
  test::expect_refused<HeightField>({2, 2, 1, 1}, {}, {}, Errc::empty, "heights is empty;");
  test::expect_refused<HeightField>({2, 2, 1, 1}, four, {1}, Errc::invalid_argument, "index_count is 1;");
  test::expect_refused<HeightField>({2, 2, 1, 1}, {0, 0, std::numeric_limits<double>::infinity(), 0}, {},
                                    Errc::not_finite, "heights[2] is inf;");
  test::expect_refused<HeightField>({2, 2, 1, 1, 3}, four, {}, Errc::unknown_value, "diagonal is 3;");
  const double nan = std::nan("");
  test::expect_refused<HeightField>({2, 2, 1, 1}, {nan, 0, 0, nan}, {}, Errc::empty, "heights is NaN");
}

TEST(HeightField, SamplesLieOnTheGridAndCellsAreSplitFromLowToHigh) {
  const HeightField field = test::made<HeightField>({3, 2, 2, 4}, {10, 11, 12, 13, 14, 15});
  EXPECT_EQ(field.parameters(), (std::vector<double>{3, 2, 2, 4, 0, 0}));
  const abut::Triangles surface = field.triangles();
  EXPECT_EQ(surface.vertices,
            (std::vector<Vec3>{{0, 0, 10}, {2, 0, 11}, {4, 0, 12}, {0, 4, 13}, {2, 4, 14}, {4, 4, 15}}));
  EXPECT_EQ(surface.indices, (std::vector<std::uint32_t>{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}));
}

TEST(HeightField, DiagonalsFallOrAlternate) {
  const std::vector<double> heights{10, 11, 12, 13, 14, 15};
  using Indices = std::vector<std::uint32_t>;
  EXPECT_EQ(test::made<HeightField>({3, 2, 2, 4, 1}, heights).triangles().indices,
            (Indices{0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4}));
  EXPECT_EQ(test::made<HeightField>({3, 2, 2, 4, 2}, heights).triangles().indices,
            (Indices{0, 1, 4, 0, 4, 3, 1, 2, 4, 2, 5, 4}));
}

// Fields of all diagonals, with and without holes, open and solid, answer as their triangles do one by one.
class HeightFieldOf : public testing::TestWithParam<std::tuple<double, bool, double>> {
 protected:
  [[nodiscard]] static HeightField field(std::uint64_t seed) {
    const auto [diagonal, has_holes, below] = GetParam();
    test::Random random(seed);
    std::vector<double> heights;
    for (std::uint32_t k = 0; k < columns * rows; ++k) {
      const bool is_inner = k % columns != 0 && k % columns != columns - 1;
      const bool is_hole = has_holes && (is_inner || below == 1) && random.uniform(0, 1) < 0.15;
      const double height = 0.125 * std::floor(random.uniform(-4, 4));
      heights.push_back(is_hole ? std::nan("") : height);
    }
    return test::made<HeightField>({columns, rows, spacing_x, spacing_y, diagonal, below}, heights);
  }
  // The middle and half of the extent, of a field of hills or of a solid.
  [[nodiscard]] static Vec3 centre() { return {middle.x, middle.y, std::get<2>(GetParam()) == 1 ? -2 : middle.z}; }
  [[nodiscard]] static Vec3 half() { return {extent.x, extent.y, std::get<2>(GetParam()) == 1 ? 2.5 : extent.z}; }
};
INSTANTIATE_TEST_SUITE_P(All, HeightFieldOf,
                         testing::Combine(testing::Values(0.0, 1.0, 2.0), testing::Bool(), testing::Values(0.0, 1.0)),
                         [](const auto& given) {
                           return std::string("Diagonal") + static_cast<char>('0' + std::get<0>(given.param)) +
                                  (std::get<1>(given.param) ? "WithHoles" : "Whole") +
                                  (std::get<2>(given.param) == 1 ? "Solid" : "");
                         });

TEST_P(HeightFieldOf, PartsAreThoseWhoseBoxesOverlap) { test::expect_parts(field(501), centre(), half(), 502); }
TEST_P(HeightFieldOf, PartsBelowAreThoseThatReachDown) { test::expect_below(field(503), 4, 504); }
TEST_P(HeightFieldOf, RaysMeetTheFirstTriangle) {
  test::expect_first_triangle(field(505), centre(), {half().x, half().y, 2 * half().z}, 506, 300);
}
TEST_P(HeightFieldOf, CrestsAreWhereNothingAroundRises) { test::expect_crests(field(507), 508, 200); }
TEST_P(HeightFieldOf, PartNearAPointIsThere) {
  const HeightField some = field(509);
  test::Random random(510);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = middle + 3 * random.point(1);
    const abut::Triangle part = some.part_near(p);
    EXPECT_FALSE(std::isnan(part.corners()[0].z + part.corners()[1].z + part.corners()[2].z));
  }
}

TEST(HeightField, RaysPassThroughHolesAndNextToThemMeet) {
  std::vector<double> heights(25, 1.0);
  heights[12] = std::nan("");
  const HeightField field = test::made<HeightField>({5, 5, 1, 1, 0}, heights);
  const auto meets = [&](double x, double y) {
    return field.cast_ray({x, y, 5}, -abut::UnitVec3::axis_z(), 10).has_value();
  };
  EXPECT_FALSE(meets(2, 2));
  EXPECT_FALSE(meets(1.6, 1.5));
  EXPECT_TRUE(meets(1.2, 2.5)) << "the triangle on the other side of the diagonal";
  EXPECT_TRUE(meets(0.5, 0.5));
}

void edit_at_random(double below) {
  std::vector<double> heights(36, 0.0);
  const std::vector<double> parameters{6, 6, 1, 1, 2, below};
  HeightField field = test::made<HeightField>(parameters, heights);
  test::Random random(511);
  for (int round = 0; round < 300; ++round) {
    const auto column = static_cast<std::uint32_t>(random.uniform(0, 5)),
               row = static_cast<std::uint32_t>(random.uniform(0, 5));
    const auto wide = static_cast<std::uint32_t>(random.uniform(1, 6 - column)),
               high = static_cast<std::uint32_t>(random.uniform(1, 6 - row));
    std::vector<double> changed;
    for (std::uint32_t k = 0; k < wide * high; ++k) {
      changed.push_back(random.uniform(0, 1) < 0.4 ? std::nan("") : std::floor(random.uniform(-3, 3)));
    }
    std::vector<double> after = heights;
    for (std::uint32_t k = 0; k < wide * high; ++k) {
      after[(row + k / wide) * 6 + column + k % wide] = changed[k];
    }
    const abut::HeightEdit edit{column, row, wide, high, changed};
    const auto anew = HeightField::make(parameters, after, {});
    const abut::Fault fault = field.check(edit);
    ASSERT_EQ(fault.has_value(), !static_cast<bool>(anew)) << "round " << round;
    if (fault) {
      EXPECT_EQ(fault->code, Errc::empty);
      continue;
    }
    heights = after;
    static_cast<void>(field.apply(edit));
    EXPECT_EQ(field.triangles().indices, anew.value().triangles().indices);
    EXPECT_EQ(field.triangles().vertices, anew.value().triangles().vertices);
    EXPECT_EQ(field.aabb(abut::Pose::identity()).low.z, anew.value().aabb(abut::Pose::identity()).low.z);
    EXPECT_EQ(field.aabb(abut::Pose::identity()).high.z, anew.value().aabb(abut::Pose::identity()).high.z);
    abut::Aabb box = abut::Aabb::everything();
    std::set<std::uint32_t> parts, parts_anew;
    field.visit_parts(box, [&](const abut::Triangle&, std::uint32_t index) { parts.insert(index); });
    anew.value().visit_parts(box, [&](const abut::Triangle&, std::uint32_t index) { parts_anew.insert(index); });
    EXPECT_EQ(parts, parts_anew);
  }
}
TEST(HeightField, EditsMakeAndFillHoles) { edit_at_random(0); }
TEST(HeightField, EditsMoveWallsAndFloors) { edit_at_random(1); }

TEST(HeightField, FrontIsUp) {
  const HeightField field = hills(191);
  for (std::uint32_t k = 0; k < 2 * (columns - 1) * (rows - 1); ++k) {
    EXPECT_GT(field.part(k).normal().z, 0);
    EXPECT_TRUE(field.part(k).is_one_sided());
  }
}

TEST(HeightField, BoxHoldsTheSurface) { test::expect_boxes_hold(hills(192), 193); }

TEST(HeightField, RaysSlipThroughNoEdgeOrVertex) {
  for (const double distance : {1.0, 1e3, 1e6}) {
    test::expect_no_gaps(hills(196), distance, 197);
  }
}

TEST(HeightField, PartsAreThoseWhoseBoxesOverlap) { test::expect_parts(hills(194), middle, extent, 195); }

TEST(HeightField, RaysMeetTheFirstTriangle) {
  test::expect_first_triangle(hills(196), middle, {extent.x, extent.y, 1}, 197, 500);
  // Nearly level rays pass many cells.
  test::expect_first_triangle(hills(198), middle, {extent.x, extent.y, 0.3}, 199, 500);
}

TEST(HeightField, RaysAlongTheAxesMeetEverySample) {
  const HeightField field = hills(200);
  const abut::Triangles surface = field.triangles();
  for (const Vec3& sample : surface.vertices) {
    const auto hit = field.cast_ray({sample.x, sample.y, 5}, -abut::UnitVec3::axis_z(), 10);
    ASSERT_TRUE(hit.has_value()) << sample.x << " " << sample.y;
    EXPECT_NEAR(hit->distance, 5 - sample.z, 1e-14);
    const auto from_below = field.cast_ray({sample.x, sample.y, -5}, abut::UnitVec3::axis_z(), 10);
    ASSERT_TRUE(from_below.has_value()) << sample.x << " " << sample.y;
    EXPECT_GT(from_below->normal.z, 0);
  }
}

TEST(HeightField, CrestsAreWhereNothingAroundRises) { test::expect_crests(hills(201), 281, 300); }

TEST(HeightField, PartNearAPointLiesInItsCell) {
  const HeightField field = hills(202);
  for (std::uint32_t k = 0; k < 2 * (columns - 1) * (rows - 1); ++k) {
    EXPECT_EQ(field.part_near(field.part(k).centre()).index() / 2, k / 2);
  }
  EXPECT_EQ(field.part_near({-100, -100, 0}).index() / 2, 0u);
  EXPECT_EQ(field.part_near({1e30, 1e30, 0}).index() / 2, (columns - 1) * (rows - 1) - 1);
}

// The boundaries of boxes belong to them: cells on both sides of a grid line touch it.
TEST(HeightField, BoxOnAGridLineMeetsTheCellsOnBothSides) {
  const HeightField field = test::made<HeightField>({4, 2, 1, 1}, std::vector<double>(8, 0.0));
  std::vector<std::uint32_t> cells;
  abut::Aabb box{{1, 0.25, -1}, {1.5, 0.5, 1}};
  field.visit_parts(box, [&](const abut::Triangle&, std::uint32_t index) { cells.push_back(index / 2); });
  std::sort(cells.begin(), cells.end());
  EXPECT_EQ(cells, (std::vector<std::uint32_t>{0, 0, 1, 1}));
}

// Which samples triangles join, found by going from one to the next until none is new.
std::set<std::set<std::pair<double, double>>> islands_of(const HeightField& field) {
  std::vector<std::set<std::pair<double, double>>> triangles;
  const abut::Triangles all = field.triangles();
  for (std::size_t i = 0; i + 2 < all.indices.size(); i += 3) {
    std::set<std::pair<double, double>> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 corner = all.vertices[all.indices[i + k]];
      corners.insert({corner.x, corner.y});
    }
    if (corners.size() == 3) triangles.push_back(corners);
  }
  std::set<std::set<std::pair<double, double>>> islands;
  while (!triangles.empty()) {
    std::set<std::pair<double, double>> island = triangles.back();
    for (bool grows = true; grows;) {
      grows = std::erase_if(triangles, [&](const auto& corners) {
                const bool meets =
                    std::ranges::any_of(corners, [&](const auto& corner) { return island.contains(corner); });
                if (meets) island.insert(corners.begin(), corners.end());
                return meets;
              }) != 0;
    }
    islands.insert(island);
  }
  return islands;
}

TEST(HeightField, HasAVertexOfEachPiece) {
  constexpr std::uint64_t seed = 77;
  SCOPED_TRACE("seed " + std::to_string(seed));
  test::Random random(seed);
  int with_several = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<double> heights(56, 0);
    for (double& height : heights) height = random.uniform(0, 1) < 0.35 ? std::nan("") : 0;
    const auto made = HeightField::make(std::vector<double>{8, 7, 1, 1, static_cast<double>(round % 3)}, heights, {});
    if (!made) continue;
    HeightField field = made.value();
    for (const bool is_edited : {false, true}) {
      if (is_edited) {
        const std::vector<double> there(16, 0);
        static_cast<void>(field.apply({2, 2, 4, 4, there}));
      }
      const auto islands = islands_of(field);
      with_several += islands.size() > 1 ? 1 : 0;
      std::set<std::set<std::pair<double, double>>> told;
      for (const Vec3& piece : field.pieces()) {
        for (const auto& island : islands) {
          if (island.contains({piece.x, piece.y})) EXPECT_TRUE(told.insert(island).second);
        }
      }
      EXPECT_EQ(told, islands);
      EXPECT_EQ(field.pieces().size(), islands.size());
    }
  }
  EXPECT_GT(with_several, 50);
}

}  // namespace
