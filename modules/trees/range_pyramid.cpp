module abut.trees.range_pyramid;
import abut.core.standard;
import abut.math;

namespace abut {
namespace {

using Range = RangePyramid::Range;
using Rectangle = RangePyramid::Rectangle;

constexpr std::uint32_t side = 4;  // of a block

constexpr std::uint32_t blocks_of(std::uint32_t count) { return (count + side - 1) / side; }

// Of the elements of a grid below a block, of which range_at(place) tells.
template <class RangeAt>
Range range_of_block(std::uint32_t column, std::uint32_t row, std::uint32_t columns, std::uint32_t rows,
                     RangeAt&& range_at) {
  Range range{infinity, -infinity};
  for (std::uint32_t j = side * row; j < std::min(side * (row + 1), rows); ++j) {
    for (std::uint32_t i = side * column; i < std::min(side * (column + 1), columns); ++i) {
      const Range each = range_at(std::size_t{j} * columns + i);
      range = {std::min(range.low, each.low), std::max(range.high, each.high)};
    }
  }
  return range;
}

// The blocks that hold a rectangle, which is not empty.
Rectangle blocks_around(const Rectangle& its) {
  const std::uint32_t column = its.column / side, row = its.row / side;
  return {column, row, (its.column + its.columns - 1) / side - column + 1, (its.row + its.rows - 1) / side - row + 1};
}

}  // namespace

RangePyramid::RangePyramid(std::span<const Real> values, std::uint32_t columns)
    : columns_(columns), rows_(static_cast<std::uint32_t>(values.size() / columns)) {
  std::uint32_t wide = columns_, high = rows_;
  do {
    wide = blocks_of(wide);
    high = blocks_of(high);
    levels_.push_back({wide, high, std::vector<Range>(std::size_t{wide} * high)});
  } while (wide > 1 || high > 1);
  update(values, {0, 0, columns_, rows_});
}

void RangePyramid::update_level(std::span<const Real> values, std::size_t number, const Rectangle& blocks) {
  Level& level = levels_[number];
  for (std::uint32_t row = blocks.row; row < blocks.row + blocks.rows; ++row) {
    for (std::uint32_t column = blocks.column; column < blocks.column + blocks.columns; ++column) {
      Range& range = level.ranges[std::size_t{row} * level.columns + column];
      if (number == 0) {
        range = range_of_block(column, row, columns_, rows_,
                               [&](std::size_t place) { return Range{values[place], values[place]}; });
      } else {
        const Level& below = levels_[number - 1];
        range = range_of_block(column, row, below.columns, below.rows,
                               [&](std::size_t place) { return below.ranges[place]; });
      }
    }
  }
}

void RangePyramid::update(std::span<const Real> values, const Rectangle& changed) {
  if (changed.columns == 0 || changed.rows == 0) {
    return;
  }
  Rectangle blocks = changed;
  for (std::size_t number = 0; number < levels_.size(); ++number) {
    blocks = blocks_around(blocks);
    update_level(values, number, blocks);
  }
}

}  // namespace abut
