// SPDX-License-Identifier: Apache-2.0
// The least and the greatest height of the cells of a grid, which follow when heights change: of blocks of 4 x 4 cells,
// of blocks of 4 x 4 of these, and so on up to a single block. A cell lies between four samples.
export module abut.trees.range_pyramid;
import abut.core.standard;
import abut.math;
import abut.trees.ray_slabs;

export namespace abut {

class RangePyramid {
 public:
  struct Range {
    Real low, high;
  };
  struct Spacing {
    Real x, y;  // of the samples
  };
  // Samples from (column, row) on.
  struct Rectangle {
    std::uint32_t column, row, columns, rows;
  };

  // At least one height; `columns` of them in each row.
  RangePyramid(std::span<const Real> values, std::uint32_t columns);

  [[nodiscard]] const Range& whole() const [[clang::lifetimebound]] { return levels_.back().ranges.front(); }

  // After heights of a rectangle have changed. O(heights of the rectangle + log(all heights)).
  void update(std::span<const Real> values, const Rectangle& changed);

  // Calls visit(column, row, stretch) for the cells that a ray passes over within `limit`, which visit may lower.
  // Cells are left out where the blocks around them are lower or higher than the ray. `stretch`: the part of the ray
  // over the cell. No cell comes after one that lies behind it. The ray reaches over the grid on a stretch that ends,
  // `whole`.
  template <class Visitor>
  void visit_ray(const RaySlabs& ray, const RaySlabs::Stretch& whole, const Spacing& spacing, const Real& limit,
                 Visitor&& visit) const {
    if (whole.is_empty()) {
      return;
    }
    // Steep rays pass over few cells, and need no blocks.
    std::size_t level = 0;
    Rectangle passed = passed_elements(level, whole, ray, spacing);
    while (passed.columns > side || passed.rows > side) {
      passed = passed_elements(++level, whole, ray, spacing);
    }
    descend(level, passed, whole, ray, spacing, limit, visit);
  }

 private:
  static constexpr std::uint32_t side = 4;  // of a block
  struct Level {
    std::uint32_t columns, rows;
    std::vector<Range> ranges;
  };

  // The elements that a stretch of a ray may pass over: blocks of a level below `level`, or cells for 0.
  [[nodiscard]] Rectangle passed_elements(std::size_t level, const RaySlabs::Stretch& over, const RaySlabs& ray,
                                          const Spacing& spacing) const {
    const Real cells = static_cast<Real>(std::uint64_t{1} << (2 * level));
    const std::uint32_t all_columns = level == 0 ? cells_along(columns_) : levels_[level - 1].columns,
                        all_rows = level == 0 ? cells_along(rows_) : levels_[level - 1].rows;
    const RaySlabs::Range columns = ray.passed(0, over, cells * spacing.x, {0, all_columns - 1}),
                          rows = ray.passed(1, over, cells * spacing.y, {0, all_rows - 1});
    return {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
  }
  // The elements of a rectangle that a stretch of a ray meets: blocks of a level below `level`, or cells for 0.
  template <class Visitor>
  void descend(std::size_t level, const Rectangle& within, const RaySlabs::Stretch& before, const RaySlabs& ray,
               const Spacing& spacing, const Real& limit, Visitor&& visit) const {
    const Real cells = static_cast<Real>(std::uint64_t{1} << (2 * level));  // along a side of an element
    const Real width = cells * spacing.x, height = cells * spacing.y;
    const RaySlabs::Range rows = ray.passed(1, before, height, {within.row, within.row + within.rows - 1});
    for (std::uint32_t j = rows.first; j <= rows.last; ++j) {
      const std::uint32_t row = ray.is_reversed(1) ? rows.first + rows.last - j : j;
      const RaySlabs::Stretch over_row = ray.within(1, row * height, (row + 1) * height, before.until(limit));
      if (over_row.is_empty()) {
        continue;
      }
      const RaySlabs::Range columns =
          ray.passed(0, over_row, width, {within.column, within.column + within.columns - 1});
      for (std::uint32_t i = columns.first; i <= columns.last; ++i) {
        const std::uint32_t column = ray.is_reversed(0) ? columns.first + columns.last - i : i;
        const RaySlabs::Stretch over = ray.within(0, column * width, (column + 1) * width, over_row.until(limit));
        if (over.is_empty()) {
          continue;
        }
        if (level == 0) {
          visit(column, row, over);
          continue;
        }
        const Range& range = levels_[level - 1].ranges[std::size_t{row} * levels_[level - 1].columns + column];
        const RaySlabs::Stretch met = ray.within(2, range.low, range.high, over);
        if (!met.is_empty()) {
          descend(level - 1, elements_of(level - 1, column, row), met, ray, spacing, limit, visit);
        }
      }
    }
  }
  // Those that a block is made of: blocks of a level below `level`, or cells for 0.
  [[nodiscard]] Rectangle elements_of(std::size_t level, std::uint32_t column, std::uint32_t row) const {
    const std::uint32_t columns = level == 0 ? cells_along(columns_) : levels_[level - 1].columns,
                        rows = level == 0 ? cells_along(rows_) : levels_[level - 1].rows;
    return {side * column, side * row, std::min(side, columns - side * column), std::min(side, rows - side * row)};
  }
  [[nodiscard]] static constexpr std::uint32_t cells_along(std::uint32_t samples) {
    return samples > 1 ? samples - 1 : 1;
  }
  void update_level(std::span<const Real> values, std::size_t number, const Rectangle& blocks);

  std::uint32_t columns_, rows_;  // of the samples
  std::vector<Level> levels_;
};

}  // namespace abut
