// SPDX-License-Identifier: Apache-2.0
module abut.trees.grids.range_pyramid;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

using Range = RangePyramid::Range;
using Rectangle = RangePyramid::Rectangle;

// Of the elements of a rectangle of a grid, of which range_at(place) tells.
template <class RangeAt>
Range range_over(const Rectangle& its, std::uint32_t columns, RangeAt&& range_at) {
  Range range{infinity, -infinity};
  for (std::uint32_t j = its.row; j < its.row + its.rows; ++j) {
    for (std::uint32_t i = its.column; i < its.column + its.columns; ++i) {
      const Range each = range_at(std::size_t{j} * columns + i);
      range = {std::min(range.low, each.low), std::max(range.high, each.high)};
    }
  }
  return range;
}

// The blocks that hold a rectangle, which is not empty.
Rectangle blocks_around(const Rectangle& its, std::uint32_t side) {
  const std::uint32_t column = its.column / side, row = its.row / side;
  return {column, row, (its.column + its.columns - 1) / side - column + 1, (its.row + its.rows - 1) / side - row + 1};
}

// The first of the cells around a stretch of samples, and how many there are.
std::pair<std::uint32_t, std::uint32_t> cells_around(std::uint32_t first, std::uint32_t count, std::uint32_t cells) {
  const std::uint32_t begin = first > 0 ? first - 1 : 0;
  return {begin, std::min(first + count, cells) - begin};
}

}  // namespace

RangePyramid::RangePyramid(std::span<const Real> values, std::uint32_t columns)
    : columns_(columns), rows_(static_cast<std::uint32_t>(values.size() / columns)) {
  std::uint32_t wide = cells_along(columns_), high = cells_along(rows_);
  do {
    wide = (wide + side - 1) / side;
    high = (high + side - 1) / side;
    const std::size_t blocks = std::size_t{wide} * high;
    levels_.push_back({wide, high, std::vector<Range>(blocks), std::vector<bool>(blocks)});
  } while (wide > 1 || high > 1);
  update(values, {0, 0, columns_, rows_});
}

void RangePyramid::update_level(std::span<const Real> values, std::size_t number, const Rectangle& blocks) {
  Level& level = levels_[number];
  for (std::uint32_t row = blocks.row; row < blocks.row + blocks.rows; ++row) {
    for (std::uint32_t column = blocks.column; column < blocks.column + blocks.columns; ++column) {
      const std::size_t place_of_block = std::size_t{row} * level.columns + column;
      Range& range = level.ranges[place_of_block];
      Rectangle its = elements_of({number, column, row});
      bool lacks = false;
      if (number == 0) {
        its.columns = std::min(its.columns + 1, columns_ - its.column);
        its.rows = std::min(its.rows + 1, rows_ - its.row);
        range = range_over(its, columns_, [&](std::size_t place) {
          lacks = lacks || std::isnan(values[place]);
          return Range{values[place], values[place]};
        });
      } else {
        const Level& below = levels_[number - 1];
        range = range_over(its, below.columns, [&](std::size_t place) {
          lacks = lacks || below.lacks[place];
          return below.ranges[place];
        });
      }
      level.lacks[place_of_block] = lacks;
    }
  }
}

void RangePyramid::update(std::span<const Real> values, const Rectangle& changed) {
  if (changed.columns == 0 || changed.rows == 0) {
    return;
  }
  const auto [column, columns] = cells_around(changed.column, changed.columns, cells_along(columns_));
  const auto [row, rows] = cells_around(changed.row, changed.rows, cells_along(rows_));
  Rectangle blocks{column, row, columns, rows};
  for (std::size_t number = 0; number < levels_.size(); ++number) {
    blocks = blocks_around(blocks, side);
    update_level(values, number, blocks);
  }
}

}  // namespace abut
