// SPDX-License-Identifier: Apache-2.0
// The regions of a patch of a surface. Contacts of one region hang together: those of the same triangles, and those
// with no wide gap between.
export module abut.narrow.manifold.regions;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.manifold.depth_order;
import abut.narrow.manifold.contact_patch;

export namespace abut {

// Which sides of a pair are surfaces, so that what they touch may fall apart into regions. A contact of two convex
// shapes has one.
struct SurfaceSides {
  bool a = false, b = false;
};

class Regions {
 public:
  // `gap_share`: no gap is wider than this share of the diagonal of the box around the points, which their jitter
  // hardly changes.
  Regions(const ContactPatch& patch, SurfaceSides surfaces, Real gap_share) : patch_(patch) {
    Aabb box = Aabb::empty();
    for (std::size_t i = 0; i < patch.size(); ++i) {
      box.include(middle(patch[i]));
    }
    square_ = gap_share * gap_share * squared_norm(box.high - box.low);
    for (std::size_t i = 0; i < (patch.size() + 3) / 4 * 4; i += 4) {
      Four four{};
      for (std::size_t lane = 0; lane < 4 && i + lane < patch.size(); ++lane) {
        const ContactPoint& contact = patch[i + lane];
        four.points.put(lane, middle(contact));
        four.part_of_a[lane] = surfaces.a ? contact.feature_a.index : 0;
        four.part_of_b[lane] = surfaces.b ? contact.feature_b.index : 0;
        four.left |= std::uint64_t{1} << lane;
      }
      fours_.push_back(four);
    }
  }

  // The places of the next region, rising in the patch. None are left if it is empty.
  [[nodiscard]] PlaceList next() {
    [[clang::uninitialized]] SmallVector<std::uint32_t, 256> reached;
    const auto reach = [&](std::size_t place_of_four, std::uint64_t lanes) {
      fours_[place_of_four].left &= ~lanes;
      for (; lanes != 0; lanes &= lanes - 1) {
        reached.push_back(static_cast<std::uint32_t>(4 * place_of_four) +
                          static_cast<std::uint32_t>(std::countr_zero(lanes)));
      }
    };
    for (std::size_t i = 0; i < fours_.size() && reached.empty(); ++i) {
      reach(i, fours_[i].left & (~fours_[i].left + 1));
    }
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const Four from = fours_[reached[next] / 4].all_of(reached[next] % 4);
      for (std::size_t i = 0; i < fours_.size(); ++i) {
        if (fours_[i].left != 0) {
          reach(i, fours_[i].left & fours_[i].hang_together_with(from, square_));
        }
      }
    }
    std::ranges::sort(reached.span());
    [[clang::uninitialized]] PlaceList places;
    for (const std::uint32_t index : reached.span()) {
      places.push_back(patch_.place(index));
    }
    return places;
  }

 private:
  // Four contacts of the patch, one per lane.
  struct Four {
    Columns points;
    LaneNumbers part_of_a, part_of_b;
    std::uint64_t left;  // a bit for each that no region has yet

    [[nodiscard]] [[gnu::always_inline]] inline Four all_of(std::size_t lane) const {
      const std::int64_t a = part_of_a[lane], b = part_of_b[lane];
      return {Columns::all(points[lane]), LaneNumbers{a, a, a, a}, LaneNumbers{b, b, b, b}, 0};
    }
    [[nodiscard]] [[gnu::always_inline]] inline std::uint64_t hang_together_with(const Four& other, Real square) const {
      const Columns way = points - other.points;
      return bits_of(((part_of_a == other.part_of_a) & (part_of_b == other.part_of_b)) |
                     (dot(way, way) <= all_lanes(square)));
    }
  };

  ContactPatch patch_;
  Real square_ = 0;
  SmallVector<Four, 64> fours_;
};

}  // namespace abut
