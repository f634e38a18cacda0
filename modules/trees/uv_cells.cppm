// SPDX-License-Identifier: Apache-2.0
// A grid of cells across two axes, found by division, for the boxes of the triangles of a mesh. An item lies in the
// cell that holds its low corner. What is wider than a cell lies in a grid of cells four times as wide, and so on up to
// a single cell. So each item lies in one cell, and reaches no further than into the next one.
export module abut.trees.uv_cells;
import abut.core.small_vector;
import abut.core.standard;
import abut.math;
import abut.trees.box_heights;
import abut.trees.bvh;
import abut.trees.ray_slabs;

export namespace abut {

class UvCells {
 public:
  // The axes across which the grid lies, and how many of its narrowest cells lie along each.
  struct Plan {
    int u, v;
    std::uint32_t columns, rows;
  };

  // Of items that are numbered as their boxes are; an empty box is no item. `around`: all of them.
  UvCells(const Plan& plan, const Aabb& around, std::span<const Aabb> boxes);

  // Calls visit(item) for items whose boxes overlap `query`, and some beside them. visit may shrink `query`.
  template <class Visitor>
  void visit_overlaps(const Aabb& query, Visitor&& visit) const {
    std::size_t level = level_under(query);
    const Rectangle under = cells_under(level, query);
    under.for_each([&](std::uint32_t i, std::uint32_t j) { descend(level, i, j, query, visit); });
    for (++level; level < levels_.size(); ++level) {
      if (levels_[level].items > 0) {
        cells_under(level, query).for_each([&](std::uint32_t i, std::uint32_t j) {
          const std::size_t cell = number_of(level, i, j);
          if (boxes_[cell].overlaps(query)) {
            visit_own(cells_[cell], query, visit);
          }
        });
      }
    }
  }

  // Calls cast(item) for items whose boxes a ray meets within `limit`, which cast may lower, and some beside them.
  // Nearer cells come first.
  template <class Caster>
  void visit_ray(const Vec3& origin, const Vec3& direction, Real& limit, Caster&& cast) const {
    const RaySlabs slabs(origin, direction, bounds());
    const RaySlabs::Stretch whole = slabs.within(bounds(), {0, limit});
    if (whole.is_empty()) {
      return;
    }
    // Steep rays pass over few cells.
    const Vec3 from = origin + whole.enter * direction, to = origin + whole.leave * direction;
    const Vec3 size = bounds().high - bounds().low;
    const Aabb passed = Aabb{minimum(from, to), maximum(from, to)}.inflated(
        1e-9 * (largest_magnitude(size) + largest_magnitude(origin)));
    const auto way_to = [&](const Aabb& box) {
      const RaySlabs::Stretch met = slabs.within(box, {0, limit});
      return met.is_empty() ? infinity : met.enter;
    };
    visit_in_order(passed, limit, way_to, [&](const Cell& cell) {
      visit_all_of(cell, cast,
                   [&](const Bvh& tree, auto&& of_tree) { tree.visit_ray(origin, direction, limit, of_tree); });
    });
  }

  // Calls visit(item) for items whose boxes reach down to `limit` along a direction, which visit may lower, and some
  // beside them. Lower cells come first.
  template <class Visitor>
  void visit_below(const Vec3& direction, Real& limit, Visitor&& visit) const {
    const auto height_of = [&](const Aabb& box) { return least_along(box, direction); };
    visit_in_order(Aabb::everything(), limit, height_of, [&](const Cell& cell) {
      visit_all_of(cell, visit, [&](const Bvh& tree, auto&& of_tree) { tree.visit_below(direction, limit, of_tree); });
    });
  }

  // An item close to a point. There are items.
  [[nodiscard]] std::uint32_t item_near(const Vec3& point) const;

  // The memory that changes take. Whoever changes cells asks for it first.
  void make_room();
  // Fits the boxes around an item that got another box, which lies where it lay across the grid. box_of(item): of any.
  template <class BoxOf>
  void fit(std::uint32_t item, const BoxOf& box_of) {
    const Aabb box = box_of(item);
    const Place place = place_of(box);
    const Cell& cell = cells_[number_of(place)];
    if (cell.tree != none) {
      move_in_tree(cell, item, box);
    }
    fit_from(place, box_of);
  }
  // Takes out for good an item that has its box still.
  template <class BoxOf>
  void remove(std::uint32_t item, const BoxOf& box_of) {
    const Place place = place_of(box_of(item));
    Cell& cell = cells_[number_of(place)];
    if (cell.tree != none) {
      move_in_tree(cell, item, Aabb::empty());
    } else {
      const std::uint32_t last = items_[cell.first + cell.count - 1];
      items_[slots_[item]] = last;
      slots_[last] = slots_[item];
    }
    --cell.count;
    --levels_[place.level].items;
    fit_from(place, box_of);
  }
  // Whether changes have made a query cost much more in a cell that has a tree.
  [[nodiscard]] bool is_worn() const { return is_worn_; }

  // Around all items.
  [[nodiscard]] const Aabb& bounds() const [[clang::lifetimebound]] { return boxes_.back(); }
  [[nodiscard]] std::size_t bytes() const;

 private:
  static constexpr std::uint32_t side = 4;  // of a cell in cells of the next narrower grid
  static constexpr std::uint64_t most_at_once = 16;
  // A cell with more items finds them by a tree of its own.
  static constexpr std::uint32_t most_listed = 24;
  static constexpr std::uint32_t none = 0xffffffff;

  struct Cell {
    std::uint32_t first, count;  // its own items
    std::uint32_t tree = none;   // over them, if there is one
  };
  struct Level {
    std::size_t first;  // cell
    std::uint32_t columns, rows;
    Real width_u, width_v;      // of a cell, or of what fits into it
    Real inverse_u, inverse_v;  // of the distance of two cells
    std::size_t items;          // in its cells
  };
  struct Rectangle {
    std::uint32_t i0, i1, j0, j1;  // first and last

    [[nodiscard]] inline std::uint64_t count() const { return std::uint64_t{i1 - i0 + 1} * (j1 - j0 + 1); }
    template <class Each>
    inline void for_each(Each&& each) const {
      for (std::uint32_t j = j0; j <= j1; ++j) {
        for (std::uint32_t i = i0; i <= i1; ++i) {
          each(i, j);
        }
      }
    }
  };

  // Where a coordinate lies, in cells of a grid of `count`.
  [[nodiscard]] static inline std::uint32_t place_at(Real from_origin, Real inverse, std::uint32_t count) {
    const Real place = from_origin * inverse;
    return place > 0 ? static_cast<std::uint32_t>(std::min(place, static_cast<Real>(count - 1))) : 0;
  }
  [[nodiscard]] inline std::size_t number_of(std::size_t level, std::uint32_t i, std::uint32_t j) const {
    return levels_[level].first + std::size_t{j} * levels_[level].columns + i;
  }
  // The cells with items that may overlap a box.
  [[nodiscard]] inline Rectangle cells_under(std::size_t number, const Aabb& box) const {
    const Level& level = levels_[number];
    const auto before = [](std::uint32_t place) { return place > 0 ? place - 1 : 0; };
    return {before(place_at(box.low[u_] - origin_u_, level.inverse_u, level.columns)),
            place_at(box.high[u_] - origin_u_, level.inverse_u, level.columns),
            before(place_at(box.low[v_] - origin_v_, level.inverse_v, level.rows)),
            place_at(box.high[v_] - origin_v_, level.inverse_v, level.rows)};
  }
  // Where a query begins: over many cells with wider ones.
  [[nodiscard]] inline std::size_t level_under(const Aabb& box) const {
    std::size_t level = 0;
    while (level + 1 < levels_.size() && cells_under(level, box).count() > most_at_once) {
      ++level;
    }
    return level;
  }
  // The cells of the next narrower grid that lie in a cell.
  [[nodiscard]] inline Rectangle cells_in(std::size_t level, std::uint32_t i, std::uint32_t j) const {
    const Level& below = levels_[level - 1];
    return {side * i, std::min(side * i + side, below.columns) - 1, side * j,
            std::min(side * j + side, below.rows) - 1};
  }
  [[nodiscard]] static inline Rectangle common(const Rectangle& a, const Rectangle& b) {
    return {std::max(a.i0, b.i0), std::min(a.i1, b.i1), std::max(a.j0, b.j0), std::min(a.j1, b.j1)};
  }

  template <class Visitor>
  void visit_own(const Cell& cell, const Aabb& query, Visitor&& visit) const {
    visit_all_of(cell, visit, [&](const Bvh& tree, auto&& of_tree) { tree.visit_overlaps(query, of_tree); });
  }
  // Its own items: all that are listed, or those that `by_tree` finds.
  template <class Visitor, class ByTree>
  void visit_all_of(const Cell& cell, Visitor&& visit, const ByTree& by_tree) const {
    if (cell.tree != none) {
      by_tree(trees_[cell.tree], [&](std::uint32_t item) { visit(items_[cell.first + item]); });
      return;
    }
    for (std::uint32_t i = cell.first; i < cell.first + cell.count; ++i) {
      visit(items_[i]);
    }
  }
  template <class Visitor>
  void descend(std::size_t level, std::uint32_t i, std::uint32_t j, const Aabb& query, Visitor&& visit) const {
    const std::size_t number = number_of(level, i, j);
    if (!boxes_[number].overlaps(query)) {
      return;
    }
    visit_own(cells_[number], query, visit);
    if (level > 0) {
      common(cells_in(level, i, j), cells_under(level - 1, query))
          .for_each([&](std::uint32_t column, std::uint32_t row) { descend(level - 1, column, row, query, visit); });
    }
  }
  // Calls visit(cell) for cells that may overlap a box and of which `measure` of their box is at most `limit`, which
  // visit may lower. Of cells that lie in one, less comes first.
  template <class Measure, class Visitor>
  void visit_in_order(const Aabb& query, const Real& limit, const Measure& measure, Visitor&& visit) const {
    const std::size_t level = level_under(query);
    for (std::size_t wider = level + 1; wider < levels_.size(); ++wider) {
      if (levels_[wider].items > 0) {
        cells_under(wider, query).for_each([&](std::uint32_t i, std::uint32_t j) {
          const std::size_t cell = number_of(wider, i, j);
          if (const Real its = cells_[cell].count > 0 ? measure(boxes_[cell]) : infinity;
              its < infinity && its <= limit) {
            visit(cells_[cell]);
          }
        });
      }
    }
    visit_sorted(level, cells_under(level, query), limit, measure, visit);
  }
  template <class Measure, class Visitor>
  void visit_sorted(std::size_t level, const Rectangle& cells, const Real& limit, const Measure& measure,
                    Visitor&& visit) const {
    struct Next {
      Real measure;
      std::uint32_t i, j;
    };
    [[clang::uninitialized]] SmallVector<Next, most_at_once> order;
    cells.for_each([&](std::uint32_t i, std::uint32_t j) {
      const Aabb& box = boxes_[number_of(level, i, j)];
      if (const Real its = box.low.x <= box.high.x ? measure(box) : infinity; its < infinity && its <= limit) {
        order.push_back({its, i, j});
      }
    });
    std::ranges::sort(order.span(), [](const Next& a, const Next& b) {
      return std::tie(a.measure, a.j, a.i) < std::tie(b.measure, b.j, b.i);
    });
    for (const Next& next : order.span()) {
      if (next.measure <= limit) {
        visit(cells_[number_of(level, next.i, next.j)]);
        if (level > 0) {
          visit_sorted(level - 1, cells_in(level, next.i, next.j), limit, measure, visit);
        }
      }
    }
  }

  // A cell of a level.
  struct Place {
    std::size_t level;
    std::uint32_t i, j;
  };
  [[nodiscard]] inline std::size_t number_of(const Place& place) const {
    return number_of(place.level, place.i, place.j);
  }
  [[nodiscard]] Place place_of(const Aabb& box) const;
  void move_in_tree(const Cell& cell, std::uint32_t item, const Aabb& box);
  // The boxes of a cell and of those that it lies in.
  template <class BoxOf>
  void fit_from(Place place, const BoxOf& box_of) {
    for (;; place = {place.level + 1, place.i / side, place.j / side}) {
      const Aabb box = box_at(place, box_of);
      const Aabb before = std::exchange(boxes_[number_of(place)], box);
      if ((box.low == before.low && box.high == before.high) || place.level + 1 == levels_.size()) {
        return;
      }
    }
  }
  // Around the items of a cell and the cells in it.
  template <class BoxOf>
  [[nodiscard]] Aabb box_at(const Place& place, const BoxOf& box_of) const {
    const Cell& cell = cells_[number_of(place)];
    Aabb box = Aabb::empty();
    if (cell.tree == none) {
      for (std::uint32_t i = cell.first; i < cell.first + cell.count; ++i) {
        box.include(box_of(items_[i]));
      }
    } else if (cell.count > 0) {
      box = box_of_tree(cell, box_of);
    }
    if (place.level > 0) {
      cells_in(place.level, place.i, place.j).for_each([&](std::uint32_t i, std::uint32_t j) {
        box.include(boxes_[number_of(place.level - 1, i, j)]);
      });
    }
    return box;
  }
  template <class BoxOf>
  [[nodiscard]] Aabb box_of_tree(const Cell& cell, const BoxOf& box_of) const {
    const auto least = [&](std::size_t number) {
      return trees_[cell.tree].least(number, -infinity, [&](std::uint32_t item) {
        const Aabb box = box_of(items_[cell.first + item]);
        return number < 3 ? box.low[static_cast<int>(number)] : -box.high[static_cast<int>(number - 3)];
      });
    };
    return {{least(0), least(1), least(2)}, {-least(3), -least(4), -least(5)}};
  }
  void place_items(std::span<const Aabb> boxes);
  void fit_from_below();

  int u_, v_;
  Real origin_u_, origin_v_;
  std::vector<Level> levels_;  // the narrowest cells first
  std::vector<Cell> cells_;    // level by level, rows of columns
  std::vector<Aabb> boxes_;    // around the items of each cell and of the cells in it
  std::vector<std::uint32_t> items_;
  std::vector<Bvh> trees_;
  // Only for changes.
  std::vector<std::uint32_t> slots_;  // where items lie in items_
  bool is_worn_ = false;
};

}  // namespace abut
