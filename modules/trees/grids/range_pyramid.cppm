// SPDX-License-Identifier: Apache-2.0
// The least and the greatest height of the cells of a grid, which follow when heights change: of blocks of 4 x 4 cells,
// of blocks of 4 x 4 of these, and so on up to a single block. A cell lies between four samples. Samples that are NaN
// do not count.
export module abut.trees.grids.range_pyramid;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.ray_slabs;

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
  // A block of a level: of 4 x 4 cells on level 0, of 4 x 4 blocks of the level below on all others.
  struct Block {
    std::size_t level;
    std::uint32_t column, row;
  };

  // At least one height; `columns` of them in each row. The range of no heights is from infinity to minus infinity.
  RangePyramid(std::span<const Real> values, std::uint32_t columns);

  [[nodiscard]] const Range& whole() const [[clang::lifetimebound]] { return levels_.back().ranges.front(); }
  [[nodiscard]] const Range& range_of(const Block& block) const [[clang::lifetimebound]] {
    return levels_[block.level].ranges[place_of(block)];
  }
  // Whether a sample of its cells is NaN.
  [[nodiscard]] bool lacks_any(const Block& block) const { return levels_[block.level].lacks[place_of(block)]; }
  [[nodiscard]] bool is_at_border(const Block& block) const {
    const Level& level = levels_[block.level];
    return block.column == 0 || block.row == 0 || block.column == level.columns - 1 || block.row == level.rows - 1;
  }
  // How many blocks there are on all levels.
  [[nodiscard]] std::uint32_t node_count() const {
    std::size_t count = 0;
    for (const Level& level : levels_) {
      count += level.ranges.size();
    }
    return static_cast<std::uint32_t>(count);
  }

  // After heights of a rectangle have changed. O(heights of the rectangle + log(all heights)).
  void update(std::span<const Real> values, const Rectangle& changed);

  // Visits take heights of blocks from range_of(block), where their own are not meant.

  // Calls visit(column, row, stretch) for the cells that a ray passes over within `limit`, which visit may lower.
  // Cells are left out where the blocks around them are lower or higher than the ray. `stretch`: the part of the ray
  // over the cell. No cell comes after one that lies behind it. The ray reaches over the grid on a stretch that ends,
  // `whole`.
  template <class Visitor, class RangeOf>
  void visit_ray(const RaySlabs& ray, const RaySlabs::Stretch& whole, const Spacing& spacing, const Real& limit,
                 Visitor&& visit, const RangeOf& range_of) const {
    if (whole.is_empty()) {
      return;
    }
    // Steep rays pass over few cells, and need no blocks.
    std::size_t level = 0;
    Rectangle passed = passed_elements(level, whole, ray, spacing);
    while (passed.columns > side || passed.rows > side) {
      passed = passed_elements(++level, whole, ray, spacing);
    }
    descend(level, passed, whole, ray, spacing, limit, visit, range_of);
  }
  template <class Visitor>
  void visit_ray(const RaySlabs& ray, const RaySlabs::Stretch& whole, const Spacing& spacing, const Real& limit,
                 Visitor&& visit) const {
    visit_ray(ray, whole, spacing, limit, visit,
              [this](const Block& block) -> const Range& { return range_of(block); });
  }

  // Calls visit(column, count, row) for the cells of a rectangle, for each row of a block at once. Cells are left out
  // where the blocks around them lie above or below a box, which visit may shrink.
  template <class Visitor, class RangeOf>
  void visit_over(const Rectangle& cells, const Aabb& box, Visitor&& visit, const RangeOf& range_of) const {
    const std::size_t level = level_over(cells);
    descend_over(
        level, all_elements(level), cells,
        [&](const Block& block) {
          const Range& range = range_of(block);
          return range.low <= box.high.z && range.high >= box.low.z;
        },
        visit);
  }
  template <class Visitor>
  void visit_over(const Rectangle& cells, const Aabb& box, Visitor&& visit) const {
    visit_over(cells, box, visit, [this](const Block& block) -> const Range& { return range_of(block); });
  }

  // The blocks as nodes of a tree; node 0 is the block of all cells. Calls visit(node, box) for the blocks that a block
  // is made of, or visit_cells(rectangle) where these are cells.
  template <class Visitor, class CellsVisitor, class RangeOf>
  void visit_in_block(std::uint32_t node, const Spacing& spacing, Visitor&& visit, CellsVisitor&& visit_cells,
                      const RangeOf& range_of) const {
    std::size_t number = levels_.size() - 1;
    std::uint32_t first = 0;  // node of the level
    for (; node - first >= levels_[number].ranges.size(); --number) {
      first += static_cast<std::uint32_t>(levels_[number].ranges.size());
    }
    const Level& level = levels_[number];
    const Rectangle its = elements_of({number, (node - first) % level.columns, (node - first) / level.columns});
    if (number == 0) {
      visit_cells(its);
      return;
    }
    first += static_cast<std::uint32_t>(level.ranges.size());
    for (std::uint32_t j = its.row; j < its.row + its.rows; ++j) {
      for (std::uint32_t i = its.column; i < its.column + its.columns; ++i) {
        const Block block{number - 1, i, j};
        const Range& range = range_of(block);
        if (range.low <= range.high) {
          visit(first + static_cast<std::uint32_t>(place_of(block)), box_of(block, range, spacing));
        }
      }
    }
  }
  template <class Visitor, class CellsVisitor>
  void visit_in_block(std::uint32_t node, const Spacing& spacing, Visitor&& visit, CellsVisitor&& visit_cells) const {
    visit_in_block(node, spacing, visit, visit_cells,
                   [this](const Block& block) -> const Range& { return range_of(block); });
  }

  // Calls visit(column, row) for cells in blocks of which `measure` of their box is at most `limit`, which visit may
  // lower. Blocks of less measure come first.
  template <class Measure, class Visitor, class RangeOf>
  void visit_in_order(const Spacing& spacing, const Real& limit, const Measure& measure, Visitor&& visit,
                      const RangeOf& range_of) const {
    visit_block({levels_.size() - 1, 0, 0}, spacing, limit, measure, visit, range_of);
  }
  template <class Measure, class Visitor>
  void visit_in_order(const Spacing& spacing, const Real& limit, const Measure& measure, Visitor&& visit) const {
    visit_in_order(spacing, limit, measure, visit,
                   [this](const Block& block) -> const Range& { return range_of(block); });
  }

 private:
  static constexpr std::uint32_t side = 4;  // of a block
  struct Level {
    std::uint32_t columns, rows;
    std::vector<Range> ranges;
    std::vector<bool> lacks;  // for each block
  };
  [[nodiscard]] std::size_t place_of(const Block& block) const {
    return std::size_t{block.row} * levels_[block.level].columns + block.column;
  }

  // The elements that a stretch of a ray may pass over: blocks of a level below `level`, or cells for 0.
  [[nodiscard]] Rectangle passed_elements(std::size_t level, const RaySlabs::Stretch& over, const RaySlabs& ray,
                                          const Spacing& spacing) const {
    const Real cells = static_cast<Real>(std::uint64_t{1} << (2 * level));
    const Rectangle all = all_elements(level);
    const RaySlabs::Range columns = ray.passed(0, over, cells * spacing.x, {0, all.columns - 1}),
                          rows = ray.passed(1, over, cells * spacing.y, {0, all.rows - 1});
    return {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
  }
  // The elements of a rectangle that a stretch of a ray meets: blocks of a level below `level`, or cells for 0.
  template <class Visitor, class RangeOf>
  void descend(std::size_t level, const Rectangle& within, const RaySlabs::Stretch& before, const RaySlabs& ray,
               const Spacing& spacing, const Real& limit, Visitor&& visit, const RangeOf& range_of) const {
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
        const Block block{level - 1, column, row};
        const Range& range = range_of(block);
        const RaySlabs::Stretch met = ray.within(2, range.low, range.high, over);
        if (!met.is_empty()) {
          descend(level - 1, elements_of(block), met, ray, spacing, limit, visit, range_of);
        }
      }
    }
  }
  // Small boxes lie over few cells, and need no blocks.
  [[nodiscard]] std::size_t level_over(const Rectangle& cells) const {
    std::size_t level = 0;
    for (std::uint32_t columns = cells.columns, rows = cells.rows; columns > side || rows > side; ++level) {
      columns = columns / side + 1;
      rows = rows / side + 1;
    }
    return std::min(level, levels_.size());
  }
  // The elements of `within` that hold cells of a rectangle: blocks of a level below `level`, or cells for 0, row by
  // row. Of blocks, those that are entered: enters(block).
  template <class Enters, class Visitor>
  void descend_over(std::size_t level, const Rectangle& within, const Rectangle& cells, const Enters& enters,
                    Visitor&& visit) const {
    const std::uint32_t shift = 2 * static_cast<std::uint32_t>(level);
    const std::uint32_t last_row = std::min(within.row + within.rows - 1, (cells.row + cells.rows - 1) >> shift),
                        last_column =
                            std::min(within.column + within.columns - 1, (cells.column + cells.columns - 1) >> shift);
    for (std::uint32_t row = std::max(within.row, cells.row >> shift); row <= last_row; ++row) {
      std::uint32_t column = std::max(within.column, cells.column >> shift);
      if (level == 0) {
        visit(column, std::max(last_column + 1, column) - column, row);
        continue;
      }
      for (; column <= last_column; ++column) {
        if (const Block block{level - 1, column, row}; enters(block)) {
          descend_over(level - 1, elements_of(block), cells, enters, visit);
        }
      }
    }
  }
  // As visit_in_order, of a block.
  template <class Measure, class Visitor, class RangeOf>
  void visit_block(const Block& block, const Spacing& spacing, const Real& limit, const Measure& measure,
                   Visitor&& visit, const RangeOf& range_of) const {
    struct Next {
      Real measure;
      std::uint32_t column, row;
    };
    [[clang::uninitialized]] SmallVector<Next, std::size_t{side} * side> order;
    const Rectangle its = elements_of(block);
    for (std::uint32_t j = its.row; j < its.row + its.rows; ++j) {
      for (std::uint32_t i = its.column; i < its.column + its.columns; ++i) {
        if (block.level == 0) {
          visit(i, j);
          continue;
        }
        const Block next{block.level - 1, i, j};
        const Range& range = range_of(next);
        if (range.low <= range.high) {
          order.push_back({measure(box_of(next, range, spacing)), i, j});
        }
      }
    }
    std::ranges::sort(order.span(), [](const Next& a, const Next& b) {
      return std::tie(a.measure, a.row, a.column) < std::tie(b.measure, b.row, b.column);
    });
    for (const Next& next : order.span()) {
      if (next.measure <= limit) {
        visit_block({block.level - 1, next.column, next.row}, spacing, limit, measure, visit, range_of);
      }
    }
  }
  // Around a block of which the range is known.
  [[nodiscard]] Aabb box_of(const Block& block, const Range& range, const Spacing& spacing) const {
    const std::uint64_t cells = std::uint64_t{1} << (2 * (block.level + 1));
    const auto at = [&](std::uint64_t place, std::uint32_t samples) {
      return static_cast<Real>(std::min<std::uint64_t>(place * cells, cells_along(samples)));
    };
    const std::uint64_t column = block.column, row = block.row;
    return {{at(column, columns_) * spacing.x, at(row, rows_) * spacing.y, range.low},
            {at(column + 1, columns_) * spacing.x, at(row + 1, rows_) * spacing.y, range.high}};
  }
  // Those that a block is made of: blocks of the level below, or cells.
  [[nodiscard]] Rectangle elements_of(const Block& block) const {
    const Rectangle all = all_elements(block.level);
    const std::uint32_t column = side * block.column, row = side * block.row;
    return {column, row, std::min(side, all.columns - column), std::min(side, all.rows - row)};
  }
  [[nodiscard]] Rectangle all_elements(std::size_t level) const {
    return level == 0 ? Rectangle{0, 0, cells_along(columns_), cells_along(rows_)}
                      : Rectangle{0, 0, levels_[level - 1].columns, levels_[level - 1].rows};
  }
  [[nodiscard]] static constexpr std::uint32_t cells_along(std::uint32_t samples) {
    return samples > 1 ? samples - 1 : 1;
  }
  void update_level(std::span<const Real> values, std::size_t number, const Rectangle& blocks);

  std::uint32_t columns_, rows_;  // of the samples
  std::vector<Level> levels_;
};

}  // namespace abut
