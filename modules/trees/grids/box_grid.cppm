// SPDX-License-Identifier: Apache-2.0
// Boxes in cells of space, of which only those with something in them exist.
export module abut.trees.grids.box_grid;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.box_sweep;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// A box lies in the cell of its centre, in a grid whose cells are at least as large as the box; each grid is four times
// as coarse as the one before (Teschner and others, "Optimized spatial hashing for collision detection of deformable
// objects", 2003; the levels are those of Ericson, "Real-time collision detection", 2005, 7.1.4). Boxes larger than the
// cells of all grids are in one cell that is always looked at. The finest cells suit the mean size of the boxes.
class BoxGrid {
 public:
  // Boxes are finite. The same functions as those of BoxTree.
  void insert(std::uint32_t leaf, const CompactAabb& box);
  void erase(std::uint32_t leaf);
  void move(std::uint32_t leaf, const CompactAabb& box);
  [[nodiscard]] bool moved_in_place(std::uint32_t leaf, const CompactAabb& box);

  template <class Visitor>
  void visit(const CompactAabb& box, Visitor&& visit_leaf) const {
    const BoxSides limits = limits_of(box);
    for_each_cell(box, [&](std::uint32_t first) {
      for (std::uint32_t at = first; at != none; at = links_[at].next) {
        for (std::uint32_t met = blocks_[at].overlapping(limits); met != 0; met &= met - 1) {
          visit_leaf(blocks_[at].numbers[static_cast<std::size_t>(std::countr_zero(met))]);
        }
      }
    });
  }

  // All boxes are tried, eight at once, in no order.
  template <class Visitor>
  void sweep(const CompactSweep& sweep, Real most, Visitor&& visit_leaf) const {
    float most_way = sweep.way_of(most);
    for (std::size_t at = 0; at < blocks_.size(); ++at) {
      const std::uint32_t present = (1u << links_[at].count) - 1;
      const EightBoxes::Floats entries = blocks_[at].entries(sweep, most_way);
      for (std::uint32_t met = EightBoxes::met(entries) & present; met != 0; met &= met - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(met));
        if (entries[lane] <= most_way) {
          most_way = sweep.way_of(visit_leaf(blocks_[at].numbers[lane]));
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t place_of(std::uint32_t leaf) const { return places_[leaf]; }

  inline void expect_place(std::uint32_t place) const {
    if (const std::size_t block = place / width; block < blocks_.size()) {
      __builtin_prefetch(&blocks_[block]);
      __builtin_prefetch(&links_[block]);
    }
  }
  inline void expect(std::uint32_t leaf) const {
    if (leaf < places_.size()) {
      __builtin_prefetch(&places_[leaf]);
    }
  }

  // Makes the grids anew when the boxes have become larger or smaller than the cells suit.
  void tidy();

  [[nodiscard]] std::size_t bytes() const {
    return blocks_.capacity() * sizeof(EightBoxes) + links_.capacity() * sizeof(Link) +
           places_.capacity() * sizeof(std::uint32_t) + (slots_.capacity() + old_slots_.capacity()) * sizeof(Slot);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::size_t width = EightBoxes::width;
  static constexpr std::uint32_t level_count = 8;  // the last one is the cell of what is too large
  static constexpr std::int32_t most_coordinate = (1 << 19) - 1;

  using Cell = std::array<std::int32_t, 3>;

  // An occupied cell. Of its blocks only the first one has room.
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t first = none;
  };
  struct Link {
    std::uint64_t key = 0;      // of the cell
    std::uint32_t next = none;  // in the cell, or of those that are not in use
    std::uint32_t count = 0;
  };

  [[nodiscard]] static inline std::uint64_t key_of(std::uint32_t level, const Cell& cell) {
    std::uint64_t key = level;
    for (const std::int32_t coordinate : cell) {
      key = (key << 20) | static_cast<std::uint64_t>(coordinate + most_coordinate);
    }
    return key;
  }
  [[nodiscard]] static inline std::uint32_t level_of_key(std::uint64_t key) {
    return static_cast<std::uint32_t>(key >> 60);
  }
  [[nodiscard]] inline std::int32_t coordinate(std::uint32_t level, Real value) const {
    const Real scaled = value * cells_per_unit_[level];
    const Real clamped = std::clamp(scaled, static_cast<Real>(-most_coordinate), static_cast<Real>(most_coordinate));
    const auto whole = static_cast<std::int32_t>(clamped);
    return whole - (static_cast<Real>(whole) > clamped ? 1 : 0);
  }
  [[nodiscard]] inline std::size_t slot_of(std::uint64_t key) const {
    // The golden ratio spreads neighbours over the table (Knuth, volume 3, 6.4).
    return static_cast<std::size_t>((key ^ (key >> 31)) * 0x9e3779b97f4a7c15u >> slot_shift_);
  }
  [[nodiscard]] inline std::uint32_t first_of(std::uint64_t key) const {
    for (std::size_t at = slot_of(key); slots_[at].first != none; at = (at + 1) & (slots_.size() - 1)) {
      if (slots_[at].key == key) {
        return slots_[at].first;
      }
    }
    return none;
  }

  // Calls visit_cell(first block) for the occupied cells that can hold an overlapping box.
  template <class Visitor>
  void for_each_cell(const CompactAabb& box, Visitor&& visit_cell) const {
    for (std::uint32_t level = 0; level < level_count; ++level) {
      if (sizes_[level] == 0) {
        continue;
      }
      Cell low{}, high{};
      std::size_t cells = 1;
      const Real reach = level + 1 == level_count ? 0 : 0.5 / cells_per_unit_[level];
      for (std::size_t axis = 0; axis < 3 && level + 1 < level_count; ++axis) {
        low[axis] = coordinate(level, static_cast<Real>(box.low[axis]) - reach);
        high[axis] = coordinate(level, static_cast<Real>(box.high[axis]) + reach);
        cells *= static_cast<std::size_t>(high[axis] - low[axis]) + 1;
        cells = std::min(cells, std::size_t{1} << 40);
      }
      if (cells > slot_count_) {
        for (const Slot& slot : slots_) {
          if (slot.first != none && level_of_key(slot.key) == level) {
            visit_cell(slot.first);
          }
        }
        continue;
      }
      for (Cell cell = low; cell[0] <= high[0]; ++cell[0]) {
        for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1]) {
          for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2]) {
            if (const std::uint32_t first = first_of(key_of(level, cell)); first != none) {
              visit_cell(first);
            }
          }
        }
      }
    }
  }

  [[nodiscard]] std::uint64_t key_of_box(const CompactAabb& box) const;
  [[nodiscard]] static std::int32_t exponent_of(const CompactAabb& box);
  void set_cells(std::int32_t exponent);
  void add(std::uint64_t key, std::uint32_t leaf, const BoxSides& sides);
  void take_out(std::uint32_t leaf);
  [[nodiscard]] std::size_t make_slot(std::uint64_t key);
  void free_slot(std::size_t slot);
  void resize_slots(std::size_t count);
  void set_lane(std::uint32_t block, std::size_t lane, std::uint32_t leaf, const BoxSides& sides);

  std::vector<EightBoxes> blocks_;  // numbered by leaf
  std::vector<Link> links_;
  std::vector<std::uint32_t> places_;  // of leaves: block times eight plus lane
  std::uint32_t free_ = none;
  std::vector<Slot> slots_ = std::vector<Slot>(16);
  std::uint32_t slot_shift_ = 60;
  std::size_t slot_count_ = 0;
  std::vector<Slot> old_slots_;  // scratch
  std::array<Real, level_count> cells_per_unit_{};
  std::array<std::size_t, level_count> sizes_{};  // boxes of each level
  std::int32_t cell_exponent_ = 0;
  std::int64_t exponent_sum_ = 0;  // of the sizes of all boxes
  std::size_t size_ = 0;
};

}  // namespace abut
