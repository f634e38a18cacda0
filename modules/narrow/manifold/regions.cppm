// SPDX-License-Identifier: Apache-2.0
// Which contacts of a surface hang together: those of the same triangles, and those between which no gap is too wide.
export module abut.narrow.manifold.regions;
import abut.capability;
import abut.core.small_vector;
import abut.core.standard;
import abut.math;
import abut.narrow.manifold.choice;

export namespace abut {

// Up to so many contacts need no memory of the heap.
inline constexpr std::size_t few_contacts = 256;

// No gap between contacts of one region is wider than this share of the diagonal of the box around all. Jitter hardly
// changes that diagonal, and there are a few regions at most, however many triangles there are.
inline constexpr Real region_gap_share = 0.25;

// Sorts places into the cells of a grid. Places of one cell hang together, so that cells are compared and not all
// places.
class Regions {
 public:
  // Contacts of which `part_of` is the same hang together wherever they are.
  template <class PartOf>
  Regions(std::span<const ContactPoint> contacts, const PartOf& part_of) {
    sort_into_cells(contacts);
    join_near();
    if (count_ > 1) {
      join_parts(contacts, part_of);
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  // Calls take(number of a contact) for those of one region after the other, as they came, and end() after each region.
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
  static constexpr int cells_along = static_cast<int>(2 / region_gap_share) + 1;
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  struct Place {
    Vec3 at;
    std::uint32_t cell, next;  // the next place in the same cell
  };
  struct Cell {
    std::array<int, 3> steps;  // from the lowest one
    std::uint32_t first;
    std::uint32_t region;
  };

  void sort_into_cells(std::span<const ContactPoint> contacts) {
    Aabb box = Aabb::empty();
    for (const ContactPoint& contact : contacts) {
      const Vec3 at = middle(contact);
      places_.push_back({at, none, none});
      box.include(at);
    }
    gap_ = region_gap_share * norm(box.high - box.low);
    const Real per_length = gap_ > 0 ? 2 / gap_ : 0;
    std::array<std::uint16_t, cells_along * cells_along * cells_along>
        numbers{};  // counted from 1; 0 for cells without places
    for (std::uint32_t number = 0; number < places_.size(); ++number) {
      Place& place = places_[number];
      const Vec3 steps = per_length * (place.at - box.low);
      const std::array<int, 3> at{static_cast<int>(steps.x), static_cast<int>(steps.y), static_cast<int>(steps.z)};
      std::uint16_t& found = numbers[static_cast<std::size_t>((at[0] * cells_along + at[1]) * cells_along + at[2])];
      if (found == 0) {
        cells_.push_back({at, none, none});
        found = static_cast<std::uint16_t>(cells_.size());
      }
      place.cell = found - 1u;
      place.next = cells_[place.cell].first;
      cells_[place.cell].first = number;
    }
  }

  [[nodiscard]] bool are_near(const Cell& a, const Cell& b) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (std::abs(a.steps[axis] - b.steps[axis]) > 3) {
        return false;
      }
    }
    for (std::uint32_t one = a.first; one != none; one = places_[one].next) {
      for (std::uint32_t other = b.first; other != none; other = places_[other].next) {
        if (squared_norm(places_[one].at - places_[other].at) <= gap_ * gap_) {
          return true;
        }
      }
    }
    return false;
  }
  // From each cell to those near it, so that few cells are left to be asked for.
  void join_near() {
    SmallVector<std::uint32_t, few_cells> left, reached;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      left.push_back(cell);
    }
    while (!left.empty()) {
      const auto region = static_cast<std::uint32_t>(count_++);
      roots_.push_back(region);
      const auto take = [&](std::size_t place) {
        const std::uint32_t cell = left[place];
        cells_[cell].region = region;
        reached.push_back(cell);
        left[place] = left[left.size() - 1];
        left.pop_back();
      };
      take(0);
      while (!reached.empty() && !left.empty()) {
        const Cell from = cells_[reached[reached.size() - 1]];
        reached.pop_back();
        for (std::size_t place = left.size(); place-- > 0;) {
          if (are_near(from, cells_[left[place]])) {
            take(place);
          }
        }
      }
      reached.clear();
    }
  }

  [[nodiscard]] std::uint32_t region_of(std::uint32_t number) const { return cells_[places_[number].cell].region; }
  [[nodiscard]] std::uint32_t root_of(std::uint32_t region) const {
    while (roots_[region] != region) {
      region = roots_[region];
    }
    return region;
  }
  template <class PartOf>
  void join_parts(std::span<const ContactPoint> contacts, const PartOf& part_of) {
    struct PartOfRegion {
      std::uint64_t part;
      std::uint32_t region;
    };
    SmallVector<PartOfRegion, few_contacts> parts;
    for (std::uint32_t number = 0; number < contacts.size(); ++number) {
      parts.push_back({part_of(contacts[number]), region_of(number)});
    }
    std::ranges::sort(parts.span(), {}, &PartOfRegion::part);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const std::uint32_t one = root_of(parts[i - 1].region), other = root_of(parts[i].region);
      if (parts[i].part == parts[i - 1].part && one != other) {
        roots_[std::max(one, other)] = std::min(one, other);
        --count_;
      }
    }
  }

  static constexpr std::size_t few_cells = 128;

  Real gap_ = 0;
  SmallVector<Place, few_contacts> places_;
  SmallVector<Cell, few_cells> cells_;
  SmallVector<std::uint32_t, 16> roots_;  // of regions: another one that it belongs to, or itself
  std::size_t count_ = 0;                 // of regions that belong to no other
};

}  // namespace abut
