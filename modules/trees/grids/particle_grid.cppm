// SPDX-License-Identifier: Apache-2.0
// Points sorted into the cells of a uniform grid, of which only a hash table is kept (Teschner et al., "Optimized
// spatial hashing for collision detection of deformable objects", 2003). Cells that follow each other along x
// have buckets that do so too, so that a row of cells is one stretch of memory.
export module abut.trees.grids.particle_grid;
import abut.core.standard;
import abut.math;

export namespace abut {

class HashGrid {
 public:
  struct Item {
    Vec3 point;
    std::uint32_t index;
  };

  HashGrid() = default;
  // Cells are no smaller than `least_cell`, and no more of them lie in the box of the points than there are
  // points, whether those fill a volume, an area or a line.
  HashGrid(std::span<const Vec3> points, Real least_cell);

  // Calls visit(item) for every point whose cell overlaps the box.
  template <class Visitor>
  void visit_near(const Aabb& query, Visitor&& visit) const {
    if (!bounds_.overlaps(query)) {
      return;
    }
    const Cell low = cell_of(maximum(query.low, bounds_.low)), high = cell_of(minimum(query.high, bounds_.high));
    const Real cells = (static_cast<Real>(high.x - low.x) + 1) * (static_cast<Real>(high.y - low.y) + 1) *
                       (static_cast<Real>(high.z - low.z) + 1);
    if (cells >= static_cast<Real>(items_.size())) {
      for (const Item& item : items_) {
        visit(item);
      }
      return;
    }
    for (std::int64_t z = low.z; z <= high.z; ++z) {
      for (std::int64_t y = low.y; y <= high.y; ++y) {
        visit_row(low.x, high.x, y, z, 0, [](const Item&) { return true; }, visit);
      }
    }
  }

  // Calls visit(item, other) for every two points no farther apart than `reach`, once.
  template <class Visitor>
  void visit_pairs(Real reach, Visitor&& visit) const {
    // Cells of two such points are no farther apart.
    const Real rings = std::floor(reach * per_cell_) + 1;
    const bool are_all_near = 2 * rings + 1 >= std::cbrt(static_cast<Real>(items_.size()));
    for (std::uint32_t at = 0; at < items_.size(); ++at) {
      const Item& item = items_[at];
      const auto is_near = [&](const Item& other) { return squared_norm(other.point - item.point) <= reach * reach; };
      const auto visit_other = [&](const Item& other) { visit(item, other); };
      if (!are_all_near) {
        visit_rows_after(at, static_cast<std::int64_t>(rings), is_near, visit_other);
        continue;
      }
      for (const Item& other : std::span(items_).subspan(at + 1)) {
        if (is_near(other)) {
          visit_other(other);
        }
      }
    }
  }

  // A point that is close to a place, though not always the closest.
  [[nodiscard]] std::uint32_t item_near(const Vec3& place) const;

  [[nodiscard]] inline const Aabb& bounds() const { return bounds_; }
  [[nodiscard]] inline Real cell() const { return cell_; }
  [[nodiscard]] std::size_t bytes() const {
    return items_.capacity() * sizeof(Item) + starts_.capacity() * sizeof(std::uint32_t);
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  [[nodiscard]] inline Cell cell_of(const Vec3& point) const {
    const Vec3 from = point - bounds_.low;
    const auto along = [&](Real value) { return static_cast<std::int64_t>(value * per_cell_); };
    return {along(from.x), along(from.y), along(from.z)};
  }
  [[nodiscard]] static inline std::uint64_t row_hash(std::int64_t y, std::int64_t z) {
    return (static_cast<std::uint64_t>(y) * 0x9e3779b97f4a7c15u) ^
           (static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4fu);
  }
  [[nodiscard]] inline std::uint64_t bucket_of(const Cell& cell) const {
    const std::uint64_t row = row_hash(cell.y, cell.z);
    return ((row >> 20) + static_cast<std::uint64_t>(cell.x)) & mask_;
  }
  // Visits what is wanted of a row of cells, among the items from `from` on. Whether an item is wanted is asked before
  // whether its cell is in the row: buckets hold items of other cells, which mostly are not.
  template <class Wanted, class Visitor>
  void visit_row(std::int64_t first, std::int64_t last, std::int64_t y, std::int64_t z, std::uint32_t from,
                 const Wanted& is_wanted, Visitor& visit) const {
    std::uint64_t bucket = bucket_of({first, y, z});
    for (std::int64_t x = first; x <= last;) {
      // The buckets up to the end of the table are one stretch.
      const auto run = std::min<std::int64_t>(last - x + 1, static_cast<std::int64_t>(mask_ + 1 - bucket));
      const std::uint32_t end = starts_[bucket + static_cast<std::uint64_t>(run)];
      for (std::uint32_t i = std::max(from, starts_[bucket]); i < end; ++i) {
        if (!is_wanted(items_[i])) {
          continue;
        }
        const Cell own = cell_of(items_[i].point);
        if (own.y == y && own.z == z && own.x >= x && own.x < x + run) {
          visit(items_[i]);
        }
      }
      x += run;
      bucket = 0;
    }
  }
  // Visits what comes after an item in its cell, and half of the cells around it: the other half has come to it.
  template <class Wanted, class Visitor>
  void visit_rows_after(std::uint32_t at, std::int64_t rings, const Wanted& is_wanted, Visitor& visit) const {
    const Cell own = cell_of(items_[at].point);
    visit_row(own.x, own.x, own.y, own.z, at + 1, is_wanted, visit);
    visit_row(own.x + 1, own.x + rings, own.y, own.z, 0, is_wanted, visit);
    for (std::int64_t z = own.z; z <= own.z + rings; ++z) {
      for (std::int64_t y = z == own.z ? own.y + 1 : own.y - rings; y <= own.y + rings; ++y) {
        visit_row(own.x - rings, own.x + rings, y, z, 0, is_wanted, visit);
      }
    }
  }

  Aabb bounds_ = Aabb::empty();
  Real cell_ = 1;
  Real per_cell_ = 1;
  std::uint64_t mask_ = 0;
  std::vector<std::uint32_t> starts_;  // of each bucket in items_, and the end
  std::vector<Item> items_;
};

}  // namespace abut
