// SPDX-License-Identifier: Apache-2.0
module abut.trees.uv_cells;
import abut.core.standard;
import abut.math;
import abut.trees.bvh;

namespace abut {
namespace {

// Places in cells are rounded: what fits is a little narrower than the distance of two cells.
constexpr Real fitting = 1 - 1e-9;

}  // namespace

UvCells::UvCells(const Plan& plan, const Aabb& around, std::span<const Aabb> boxes)
    : u_(plan.u), v_(plan.v), origin_u_(around.low[plan.u]), origin_v_(around.low[plan.v]) {
  Real width_u = (around.high[u_] - origin_u_) / plan.columns, width_v = (around.high[v_] - origin_v_) / plan.rows;
  std::uint32_t columns = plan.columns, rows = plan.rows;
  std::size_t first = 0;
  const auto inverse_of = [](Real width) { return width > 0 ? 1 / width : 0; };
  for (;;) {
    levels_.push_back(
        {first, columns, rows, fitting * width_u, fitting * width_v, inverse_of(width_u), inverse_of(width_v), 0});
    first += std::size_t{columns} * rows;
    if (columns == 1 && rows == 1) {
      break;
    }
    columns = (columns + side - 1) / side;
    rows = (rows + side - 1) / side;
    width_u *= side;
    width_v *= side;
  }
  cells_.resize(first);
  boxes_.resize(first, Aabb::empty());
  place_items(boxes);
  fit_from_below();
}

// The narrowest cell that is as wide as a box, where its low corner lies. The last one takes whatever is left.
UvCells::Place UvCells::place_of(const Aabb& box) const {
  const Vec3 size = box.high - box.low;
  std::size_t number = 0;
  while (number + 1 < levels_.size() && !(size[u_] <= levels_[number].width_u && size[v_] <= levels_[number].width_v)) {
    ++number;
  }
  const Level& level = levels_[number];
  return {number, place_at(box.low[u_] - origin_u_, level.inverse_u, level.columns),
          place_at(box.low[v_] - origin_v_, level.inverse_v, level.rows)};
}

// Sorted by counting: where the items of each cell begin, then the items.
void UvCells::place_items(std::span<const Aabb> boxes) {
  std::vector<std::size_t> cells(boxes.size(), cells_.size());
  for (std::size_t item = 0; item < boxes.size(); ++item) {
    if (boxes[item].low.x <= boxes[item].high.x) {
      cells[item] = number_of(place_of(boxes[item]));
      ++cells_[cells[item]].count;
      boxes_[cells[item]].include(boxes[item]);
    }
  }
  std::uint32_t before = 0;
  for (Cell& cell : cells_) {
    cell.first = before;
    before += std::exchange(cell.count, 0);
  }
  items_.resize(before);
  for (std::size_t item = 0; item < boxes.size(); ++item) {
    if (cells[item] < cells_.size()) {
      Cell& cell = cells_[cells[item]];
      items_[cell.first + cell.count++] = static_cast<std::uint32_t>(item);
    }
  }
  std::vector<Aabb> of_cell;
  for (Cell& cell : cells_) {
    if (cell.count > most_listed) {
      of_cell.clear();
      for (std::uint32_t i = cell.first; i < cell.first + cell.count; ++i) {
        of_cell.push_back(boxes[items_[i]]);
      }
      cell.tree = static_cast<std::uint32_t>(trees_.size());
      trees_.emplace_back(of_cell);
    }
  }
}

// The boxes of wider cells from those of narrower ones.
void UvCells::fit_from_below() {
  for (std::size_t number = 0; number < levels_.size(); ++number) {
    Level& level = levels_[number];
    const Rectangle all{0, level.columns - 1, 0, level.rows - 1};
    all.for_each([&](std::uint32_t i, std::uint32_t j) {
      const std::size_t cell = number_of(number, i, j);
      level.items += cells_[cell].count;
      if (number > 0) {
        cells_in(number, i, j).for_each([&](std::uint32_t column, std::uint32_t row) {
          boxes_[cell].include(boxes_[number_of(number - 1, column, row)]);
        });
      }
    });
  }
}

std::uint32_t UvCells::item_near(const Vec3& point) const {
  const auto any_of = [&](const Cell& cell) {
    return items_[cell.first + (cell.tree != none ? trees_[cell.tree].item_near(point) : 0)];
  };
  const Cell& below = cells_[number_of(place_of({point, point}))];
  if (below.count > 0) {
    return any_of(below);
  }
  std::uint32_t nearest = none;
  Real limit = infinity;
  const auto way_to = [&](const Aabb& box) {
    const Vec3 beyond = maximum(maximum(box.low - point, point - box.high), {0, 0, 0});
    return beyond.x + beyond.y + beyond.z;
  };
  visit_in_order(Aabb::everything(), limit, way_to, [&](const Cell& cell) {
    if (nearest == none && cell.count > 0) {
      nearest = any_of(cell);
      limit = -1;
    }
  });
  return nearest;
}

void UvCells::make_room() {
  if (!slots_.empty()) {
    return;
  }
  for (Bvh& tree : trees_) {
    tree.make_room();
  }
  slots_.resize(std::size_t{*std::max_element(items_.begin(), items_.end())} + 1);
  for (std::uint32_t slot = 0; slot < items_.size(); ++slot) {
    slots_[items_[slot]] = slot;
  }
}

void UvCells::move_in_tree(const Cell& cell, std::uint32_t item, const Aabb& box) {
  Bvh& tree = trees_[cell.tree];
  tree.move(slots_[item] - cell.first, box);
  static_cast<void>(tree.settle());
  is_worn_ = is_worn_ || tree.is_worn();
}

std::size_t UvCells::bytes() const {
  std::size_t sum = cells_.capacity() * sizeof(Cell) + boxes_.capacity() * sizeof(Aabb) +
                    (items_.capacity() + slots_.capacity()) * sizeof(std::uint32_t);
  return sum + trees_.capacity() * sizeof(Bvh);
}

}  // namespace abut
