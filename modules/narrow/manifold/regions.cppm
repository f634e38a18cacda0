// SPDX-License-Identifier: Apache-2.0
// Which points of a surface hang together: those of the same triangles, and those between which no gap is too wide.
//
// Regions are found from cell to cell. A cell is half as wide as the widest gap, so all points of a cell belong
// together. Boxes around the points of cells, four at a time, nearly always decide whether two cells are near;
// otherwise their points do.
export module abut.narrow.manifold.regions;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.manifold.by_depth;
import abut.narrow.manifold.depth_order;

export namespace abut {

// No gap between points of one region is wider than this share of the diagonal of the box around all. Jitter hardly
// changes that diagonal, and there are a few regions at most, however many triangles there are.
inline constexpr Real region_gap_share = 0.25;

// Sorts points into the cells of a grid. Points of one cell hang together, so that cells are compared, by the boxes
// around their points, and rarely the points themselves.
class Regions {
 public:
  // Points of which part_of(number) is the same hang together wherever they are.
  template <class PartOf>
  Regions(std::span<const Vec3> points, const PartOf& part_of) {
    sort_into_cells(points);
    join_near();
    if (count_ > 1) {
      join_parts(part_of);
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  // Calls take(number of a point) for those of one region after the other, as they came, and end() after each region.
  template <class Take, class End>
  void visit(const Take& take, const End& end) const {
    for (std::uint32_t region = 0; region < roots_.size(); ++region) {
      if (roots_[region] != region) {
        continue;
      }
      for (std::uint32_t number = 0; number < places_.size(); ++number) {
        if (root_of(region_of(number)) == region) {
          take(number);
        }
      }
      end();
    }
  }

 private:
  // Their diagonal is no longer than a gap: a cell is half as wide.
  static constexpr std::size_t cells_along = static_cast<std::size_t>(2 / region_gap_share) + 1;
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static constexpr std::size_t few_cells = 128;

  struct Place {
    Vec3 at;
    std::uint32_t cell, next;  // the next place in the same cell
  };
  struct Cell {
    std::uint32_t first, region;
  };
  // The boxes around the points of four cells, and a bit for each cell that no region has.
  struct FourBoxes {
    Columns low, high;
    std::uint64_t free;
  };

  void sort_into_cells(std::span<const Vec3> points) {
    Aabb box = Aabb::empty();
    for (const Vec3& point : points) {
      box.include(point);
    }
    gap_ = region_gap_share * norm(box.high - box.low);
    const Real per_length = gap_ > 0 ? 2 / gap_ : 0;
    // Counted from 1; 0 for cells without points.
    std::array<std::uint16_t, cells_along * cells_along * cells_along> numbers{};
    constexpr Vec3 furthest{infinity, infinity, infinity};
    for (std::size_t cell = 0; cell < std::min(points.size(), numbers.size()); cell += 4) {
      boxes_.push_back({Columns::all(furthest), Columns::all(-furthest), 0});
    }
    for (const Vec3& point : points) {
      const Vec3 steps = per_length * (point - box.low);
      const auto x = static_cast<std::size_t>(steps.x), y = static_cast<std::size_t>(steps.y),
                 z = static_cast<std::size_t>(steps.z);
      std::uint16_t& found = numbers[(x * cells_along + y) * cells_along + z];
      cells_.push_back_if({none, none}, found == 0);
      found = found == 0 ? static_cast<std::uint16_t>(cells_.size()) : found;
      add(point, found - 1u);
    }
  }
  void add(const Vec3& point, std::uint32_t at) {
    Cell& cell = cells_[at];
    places_.push_back({point, at, cell.first});
    cell.first = static_cast<std::uint32_t>(places_.size() - 1);
    FourBoxes& four = boxes_[at / 4];
    const std::size_t lane = at % 4;
    four.free |= std::uint64_t{1} << lane;
    Aabb box{four.low[lane], four.high[lane]};
    box.include(point);
    four.low.put(lane, box.low);
    four.high.put(lane, box.high);
  }

  [[nodiscard]] bool have_near_points(const Cell& a, const Cell& b) const {
    for (std::uint32_t one = a.first; one != none; one = places_[one].next) {
      for (std::uint32_t other = b.first; other != none; other = places_[other].next) {
        if (squared_norm(places_[one].at - places_[other].at) <= gap_ * gap_) {
          return true;
        }
      }
    }
    return false;
  }
  // From each cell to those near it, until none is free.
  void join_near() {
    std::size_t free = cells_.size();
    [[clang::uninitialized]] SmallVector<std::uint32_t, few_cells> reached;
    for (std::uint32_t cell = 0; free > 0; ++cell) {
      if (cells_[cell].region != none) {
        continue;
      }
      boxes_[cell / 4].free &= ~(std::uint64_t{1} << cell % 4);
      reached.clear();
      reached.push_back(cell);
      for (std::size_t next = 0; next < reached.size() && reached.size() < free; ++next) {
        reach_from(reached[next], reached);
      }
      const auto region = static_cast<std::uint32_t>(count_++);
      roots_.push_back(region);
      for (const std::uint32_t one : reached.span()) {
        cells_[one].region = region;
      }
      free -= reached.size();
    }
  }
  // Takes the free cells that have a point near one of the given cell.
  void reach_from(std::uint32_t from, SmallVector<std::uint32_t, few_cells>& reached) {
    const FourBoxes& its = boxes_[from / 4];
    const Columns low = Columns::all(its.low[from % 4]), high = Columns::all(its.high[from % 4]);
    const Lanes most = all_lanes(gap_ * gap_), zero = all_lanes(0);
    for (std::uint32_t first = 0; first < cells_.size(); first += 4) {
      FourBoxes& four = boxes_[first / 4];
      const Columns above = four.low - high, below = low - four.high;
      const Columns least{maximum(maximum(above.x, below.x), zero), maximum(maximum(above.y, below.y), zero),
                          maximum(maximum(above.z, below.z), zero)};
      const Columns up = four.high - low, down = high - four.low;
      const Columns largest{maximum(up.x, down.x), maximum(up.y, down.y), maximum(up.z, down.z)};
      const std::uint64_t may_be_near = bits_of(dot(least, least) <= most) & four.free;
      std::uint64_t are_near = may_be_near & bits_of(dot(largest, largest) <= most);
      for (std::uint64_t left = may_be_near & ~are_near; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
        are_near |= std::uint64_t{have_near_points(cells_[from], cells_[first + lane]) ? 1u : 0u} << lane;
      }
      four.free &= ~are_near;
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        reached.push_back_if(first + lane, (are_near >> lane & 1) != 0);
      }
    }
  }

  [[nodiscard]] std::uint32_t region_of(std::uint32_t number) const { return cells_[places_[number].cell].region; }
  [[nodiscard]] std::uint32_t root_of(std::uint32_t region) const {
    while (roots_[region] != region) {
      region = roots_[region];
    }
    return region;
  }
  // Of a part that several points have, each joins its region to that of the one before.
  template <class PartOf>
  void join_parts(const PartOf& part_of) {
    [[clang::uninitialized]] IdTable<std::uint32_t> regions(places_.size());
    for (std::uint32_t number = 0; number < places_.size(); ++number) {
      const std::uint32_t region = region_of(number);
      const std::uint32_t one = root_of(region), other = root_of(regions.find_or_add(part_of(number), region));
      roots_[std::max(one, other)] = std::min(one, other);
      count_ -= one != other ? 1 : 0;
    }
  }

  Real gap_ = 0;
  SmallVector<Place, few_contacts> places_;
  SmallVector<Cell, few_cells> cells_;
  SmallVector<FourBoxes, few_cells / 4> boxes_;
  SmallVector<std::uint32_t, 16> roots_;  // of regions: another one that it belongs to, or itself
  std::size_t count_ = 0;                 // of regions that belong to no other
};

}  // namespace abut
