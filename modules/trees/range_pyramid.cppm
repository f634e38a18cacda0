// The least and the greatest value of a grid, which follow when values change: of blocks of 4 x 4 values, of blocks of
// 4 x 4 of these, and so on up to a single block.
export module abut.trees.range_pyramid;
import abut.core.standard;
import abut.math;

export namespace abut {

class RangePyramid {
 public:
  struct Range {
    Real low, high;
  };
  // Samples from (column, row) on.
  struct Rectangle {
    std::uint32_t column, row, columns, rows;
  };

  // At least one value; `columns` of them in each row.
  RangePyramid(std::span<const Real> values, std::uint32_t columns);

  [[nodiscard]] const Range& whole() const [[clang::lifetimebound]] { return levels_.back().ranges.front(); }

  // After values of a rectangle have changed. O(values of the rectangle + log(all values)).
  void update(std::span<const Real> values, const Rectangle& changed);

 private:
  struct Level {
    std::uint32_t columns, rows;
    std::vector<Range> ranges;
  };
  void update_level(std::span<const Real> values, std::size_t number, const Rectangle& blocks);

  std::uint32_t columns_, rows_;  // of the values
  std::vector<Level> levels_;
};

}  // namespace abut
