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

// Sorts places on a grid. Places of one cell hang together, so that cells are compared and not all places.
class Regions {
 public:
  // Contacts of which `part_of` is the same hang together wherever they are. `share`: how wide a gap may be, of the
  // diagonal of the box around all, which jitter hardly changes. At least a millionth.
  template <class PartOf>
  Regions(std::span<const ContactPoint> contacts, Real share, const PartOf& part_of) {
    Aabb box = Aabb::empty();
    for (const ContactPoint& contact : contacts) {
      box.include(middle(contact));
    }
    gap_ = share * norm(box.high - box.low);
    // The diagonal of a cell is shorter than the gap.
    const Real per_length = gap_ > 0 ? 2 / gap_ : 0;
    for (std::uint32_t number = 0; number < contacts.size(); ++number) {
      const Vec3 at = middle(contacts[number]), steps = per_length * (at - box.low);
      places_.push_back(
          {at,
           {static_cast<std::int32_t>(steps.x), static_cast<std::int32_t>(steps.y), static_cast<std::int32_t>(steps.z)},
           part_of(contacts[number]),
           number,
           0});
    }
    std::ranges::sort(places_.span(), [](const Place& a, const Place& b) {
      return std::tie(a.cell, a.number) < std::tie(b.cell, b.number);
    });
    find_groups();
    unite_near();
    unite_parts();
  }
  [[nodiscard]] std::size_t count() const {
    std::size_t count = 0;
    for (std::uint32_t group = 0; group < groups_.size(); ++group) {
      count += groups_[group].region == group ? 1 : 0;
    }
    return count;
  }
  // Calls take(number of a contact) for those of one region after the other, and end() after each region.
  template <class Take, class End>
  void visit(const Take& take, const End& end) const {
    for (std::uint32_t region = 0; region < groups_.size(); ++region) {
      if (groups_[region].region != region) {
        continue;
      }
      for (std::uint32_t group = region; group < groups_.size(); ++group) {
        if (root_of(group) == region) {
          for (const Place& place : of(groups_[group])) {
            take(place.number);
          }
        }
      }
      end();
    }
  }

 private:
  struct Place {
    Vec3 at;
    std::array<std::int32_t, 3> cell;
    std::uint64_t part;
    std::uint32_t number, group;
  };
  // Places of one cell. The region is that of another group, or of its own.
  struct Group {
    std::uint32_t first, last, region;
  };

  [[nodiscard]] std::span<const Place> of(const Group& group) const [[clang::lifetimebound]] {
    return places_.span().subspan(group.first, group.last - group.first);
  }
  [[nodiscard]] std::uint32_t root_of(std::uint32_t group) const {
    while (groups_[group].region != group) {
      group = groups_[group].region;
    }
    return group;
  }
  // The lesser number stays the root.
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t root_a = root_of(a), root_b = root_of(b);
    groups_[std::max(root_a, root_b)].region = std::min(root_a, root_b);
  }

  void find_groups() {
    const std::span<Place> places = places_.span();
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      if (i == 0 || places[i].cell != places[i - 1].cell) {
        groups_.push_back({i, i, static_cast<std::uint32_t>(groups_.size())});
      }
      places[i].group = static_cast<std::uint32_t>(groups_.size() - 1);
      groups_[places[i].group].last = i + 1;
    }
  }
  void unite_near() {
    const auto may_be_near = [&](const Group& a, const Group& b) {
      const auto &cell_a = places_[a.first].cell, &cell_b = places_[b.first].cell;
      return std::abs(cell_a[0] - cell_b[0]) <= 3 && std::abs(cell_a[1] - cell_b[1]) <= 3 &&
             std::abs(cell_a[2] - cell_b[2]) <= 3;
    };
    const auto are_near = [&](const Group& a, const Group& b) {
      return std::ranges::any_of(of(a), [&](const Place& one) {
        return std::ranges::any_of(of(b),
                                   [&](const Place& other) { return squared_norm(one.at - other.at) <= gap_ * gap_; });
      });
    };
    for (std::uint32_t a = 0; a < groups_.size(); ++a) {
      for (std::uint32_t b = a + 1; b < groups_.size(); ++b) {
        if (root_of(a) != root_of(b) && may_be_near(groups_[a], groups_[b]) && are_near(groups_[a], groups_[b])) {
          unite(a, b);
        }
      }
    }
  }
  void unite_parts() {
    struct PartOfGroup {
      std::uint64_t part;
      std::uint32_t group;
    };
    SmallVector<PartOfGroup, few_contacts> parts;
    for (const Place& place : places_.span()) {
      parts.push_back({place.part, place.group});
    }
    std::ranges::sort(parts.span(), {}, &PartOfGroup::part);
    for (std::size_t i = 1; i < parts.size(); ++i) {
      if (parts[i].part == parts[i - 1].part) {
        unite(parts[i].group, parts[i - 1].group);
      }
    }
  }

  Real gap_ = 0;
  SmallVector<Place, few_contacts> places_;
  SmallVector<Group, 64> groups_;
};

}  // namespace abut
