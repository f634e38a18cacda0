// SPDX-License-Identifier: Apache-2.0
// An order of boxes in which those near each other mostly follow each other, by a grid of cells across two axes. A tree
// is made of it with few searches for cuts.
//
// A uv_grid is a mesh whose tree is made in this order. An index of cells that queries read directly took 1.4 MB of
// code and was slower than trees.
export module abut.trees.grids.cell_order;
import abut.core.standard;
import abut.math;

export namespace abut {

// The axes across which the grid lies, and how many cells lie along each. 0: as many as suit.
struct CellPlan {
  int u, v;
  std::uint32_t columns, rows;
};

// The numbers of the boxes that are not empty. `around`: all of them. Cells are passed along the curve of Hilbert
// ("Über die stetige Abbildung einer Linie auf ein Flächenstück", 1891): it never leaves a square before all of it has
// been passed. Boxes that are much wider than a cell come last, by their widths, so that none lies among small ones.
[[nodiscard]] std::vector<std::uint32_t> ordered_by_cells(CellPlan plan, const Aabb& around,
                                                          std::span<const Aabb> boxes);

}  // namespace abut
