// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

import abut.trees.grids.range_pyramid;

namespace {

using abut::RangePyramid;

void expect_range_of(const std::vector<double>& values, const RangePyramid& pyramid) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  EXPECT_EQ(pyramid.whole().low, *low);
  EXPECT_EQ(pyramid.whole().high, *high);
}

// Of each block of 4 x 4 cells, whether one of its samples is NaN.
void expect_gaps_of(const std::vector<double>& values, std::uint32_t columns, const RangePyramid& pyramid) {
  const auto rows = static_cast<std::uint32_t>(values.size()) / columns;
  for (std::uint32_t j = 0; 4 * j < std::max(rows - 1, 1u); ++j) {
    for (std::uint32_t i = 0; 4 * i < std::max(columns - 1, 1u); ++i) {
      bool lacks = false;
      for (std::uint32_t row = 4 * j; row <= 4 * j + 4 && row < rows; ++row) {
        for (std::uint32_t column = 4 * i; column <= 4 * i + 4 && column < columns; ++column) {
          lacks = lacks || std::isnan(values[std::size_t{row} * columns + column]);
        }
      }
      EXPECT_EQ(pyramid.lacks_any({0, i, j}), lacks) << columns << " x " << rows << ": " << i << ", " << j;
    }
  }
}

TEST(RangePyramid, IsTheRangeOfOneValue) {
  const std::vector values{-3.0};
  expect_range_of(values, RangePyramid(values, 1));
}

// Sizes around the powers of the side of a block, and long and narrow ones.
TEST(RangePyramid, FollowsWhateverRectangleChanges) {
  constexpr std::uint64_t seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const auto below = [&](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
  for (const auto& [columns, rows] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 1},
                                                                                          {2, 2},
                                                                                          {3, 7},
                                                                                          {4, 4},
                                                                                          {5, 4},
                                                                                          {4, 17},
                                                                                          {16, 16},
                                                                                          {17, 15},
                                                                                          {64, 65},
                                                                                          {2, 300},
                                                                                          {300, 2},
                                                                                          {63, 1}}) {
    std::vector<double> values(std::size_t{columns} * rows);
    const auto draw = [&] { return static_cast<double>(below(1000)) - 500; };
    std::ranges::generate(values, draw);
    RangePyramid pyramid(values, columns);
    for (int change = 0; change < 200; ++change) {
      const std::uint32_t column = below(columns + 1), row = below(rows + 1);
      const std::uint32_t wide = below(columns - column + 1), high = below(rows - row + 1);
      for (std::uint32_t j = row; j < row + high; ++j) {
        for (std::uint32_t i = column; i < column + wide; ++i) {
          values[std::size_t{j} * columns + i] = draw() * (below(4) == 0 ? 2 : 0.5);
        }
      }
      pyramid.update(values, {column, row, wide, high});
      expect_range_of(values, pyramid);
    }
    std::vector<double> gaps = values;
    for (int change = 0; change < 50; ++change) {
      const std::uint32_t column = below(columns), row = below(rows);
      gaps[std::size_t{row} * columns + column] = below(2) == 0 ? std::nan("") : draw();
      pyramid.update(gaps, {column, row, 1, 1});
      expect_gaps_of(gaps, columns, pyramid);
    }
  }
}

}  // namespace
