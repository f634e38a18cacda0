// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "../../random_boxes.hpp"

import abut.math;
import abut.trees.grids.cell_order;

namespace {

using abut::Aabb;
using abut::Vec3;

Aabb box_around_all(const std::vector<Aabb>& boxes) {
  Aabb around = Aabb::empty();
  for (const Aabb& box : boxes) {
    around.include(box);
  }
  return around;
}
Vec3 middle_of(const Aabb& box) { return 0.5 * (box.low + box.high); }

// A box in each cell of a grid, in any order.
std::vector<Aabb> one_in_each_cell(int side, test::Random& random) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < side * side; ++i) {
    const Vec3 low{1.0 * (i % side), 1.0 * (i / side), random.uniform(0, 1)};
    boxes.push_back({low, low + Vec3{1, 1, 0.1}});
  }
  for (std::size_t i = boxes.size(); i > 1; --i) {
    std::swap(boxes[i - 1], boxes[static_cast<std::size_t>(random.uniform(0, static_cast<double>(i)))]);
  }
  return boxes;
}

// The curve goes from each cell to one beside it, and fills each quarter of a square before it goes on.
TEST(CellOrder, PassesCellsOneBesideTheOther) {
  test::Random random(801);
  constexpr int side = 16;
  const std::vector<Aabb> boxes = one_in_each_cell(side, random);
  const std::vector<std::uint32_t> order = abut::ordered_by_cells({0, 1, side, side}, box_around_all(boxes), boxes);
  ASSERT_EQ(order.size(), boxes.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Vec3 way = middle_of(boxes[order[i]]) - middle_of(boxes[order[i - 1]]);
    EXPECT_EQ(std::fabs(way.x) + std::fabs(way.y), 1) << i;
  }
  for (std::size_t count = 4; count <= boxes.size(); count *= 4) {
    for (std::size_t first = 0; first < order.size(); first += count) {
      Aabb square = Aabb::empty();
      for (std::size_t i = first; i < first + count; ++i) {
        square.include(boxes[order[i]]);
      }
      EXPECT_EQ(square.high.x - square.low.x, std::sqrt(static_cast<double>(count)));
      EXPECT_EQ(square.high.y - square.low.y, std::sqrt(static_cast<double>(count)));
    }
  }
}

TEST(CellOrder, HasEachBoxThatIsThereOnce) {
  test::Random random(802);
  for (const abut::CellPlan plan : {abut::CellPlan{0, 1, 0, 0}, {2, 0, 7, 1}, {1, 2, 1, 1}, {0, 1, 65535, 255}}) {
    std::vector<Aabb> boxes;
    for (int i = 0; i < 500; ++i) {
      const Vec3 low = random.point(10);
      boxes.push_back(i % 7 == 0 ? Aabb::empty() : Aabb{low, low + random.uniform(0, 5) * Vec3{1, 0.5, 2}});
    }
    std::vector<std::uint32_t> order = abut::ordered_by_cells(plan, box_around_all(boxes), boxes), there;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (i % 7 != 0) there.push_back(i);
    }
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, there);
  }
}

// None lies between small ones, whose nodes it would widen.
TEST(CellOrder, HasWideBoxesLast) {
  test::Random random(803);
  std::vector<Aabb> boxes = one_in_each_cell(16, random);
  for (const double width : {5.0, 15.0}) {
    boxes.insert(boxes.begin() + 50, Aabb{{0, 0, 0}, {width, width, 1}});
  }
  const std::vector<std::uint32_t> order = abut::ordered_by_cells({0, 1, 16, 16}, box_around_all(boxes), boxes);
  ASSERT_EQ(order.size(), boxes.size());
  EXPECT_EQ(boxes[order[order.size() - 1]].high.x - boxes[order[order.size() - 1]].low.x, 15);
  EXPECT_EQ(boxes[order[order.size() - 2]].high.x - boxes[order[order.size() - 2]].low.x, 5);
}

// One cell holds all: layers and heaps are told apart by their places in it.
TEST(CellOrder, TellsLayersOfACellApart) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 400; ++i) {
    const Vec3 low{0.1 * (i % 10), 0.1 * (i / 2 % 10), i % 2 == 0 ? 0.0 : 50.0};
    boxes.push_back({low, low + Vec3{0.1, 0.1, 0.01}});
  }
  const std::vector<std::uint32_t> order = abut::ordered_by_cells({0, 1, 1, 1}, box_around_all(boxes), boxes);
  ASSERT_EQ(order.size(), boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(order[i] % 2, i < order.size() / 2 ? 0U : 1U) << i;
  }
}

TEST(CellOrder, NeedsNoExtent) {
  const Vec3 point{1, 2, 3};
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double size : {0.0, tiny, 1e70}) {
    const std::vector<Aabb> boxes(20, Aabb{point, point + size * Vec3{1, 1, 1}});
    EXPECT_EQ(abut::ordered_by_cells({0, 1, 0, 0}, boxes.front(), boxes).size(), 20U);
    EXPECT_EQ(abut::ordered_by_cells({2, 1, 100, 3}, boxes.front(), boxes).size(), 20U);
  }
  const Vec3 origin{0, 0, 0};
  const std::vector<Aabb> boxes{{origin, {tiny, 0, 0}}, {{tiny, 0, 0}, {tiny, tiny, 0}}};
  EXPECT_EQ(abut::ordered_by_cells({0, 1, 5, 5}, {origin, {tiny, tiny, 0}}, boxes).size(), 2U);
}

}  // namespace
