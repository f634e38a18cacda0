// SPDX-License-Identifier: Apache-2.0
// Which of a few points of a surface hang together: what Regions tells of any number of points. Each point has a bit,
// and each of those that are reached is compared with all that are not, four at a time.
export module abut.narrow.manifold.few_regions;
import abut.core.standard;
import abut.math;
import abut.math.four_vec3;
import abut.narrow.manifold.regions;

export namespace abut {

class FewRegions {
 public:
  static constexpr std::size_t most_points = 64;

  template <class PartOf>
  FewRegions(std::span<const Vec3> points, const PartOf& part_of) {
    [[clang::uninitialized]] const Fours fours(points, part_of);
    const Real gap = region_gap(box_around(points));
    std::uint64_t free = ~std::uint64_t{0} >> (most_points - points.size());
    while (free != 0) {
      std::uint64_t region = 0, reached = free & -free;
      free ^= reached;
      while (reached != 0) {
        const auto from = static_cast<std::size_t>(std::countr_zero(reached));
        const std::uint64_t one = std::uint64_t{1} << from, more = fours.near(from, free, gap * gap);
        region |= one;
        free ^= more;
        reached = (reached ^ one) | more;
      }
      regions_[count_++] = region;
    }
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  // Calls take(number of a point) for those of one region after the other, as they came, and end() after each region.
  template <class Take, class End>
  void visit(const Take& take, const End& end) const {
    for (std::uint64_t region : std::span(regions_).first(count_)) {
      for (; region != 0; region &= region - 1) {
        take(static_cast<std::uint32_t>(std::countr_zero(region)));
      }
      end();
    }
  }

 private:
  class Fours {
   public:
    template <class PartOf>
    Fours(std::span<const Vec3> points, const PartOf& part_of) {
      for (std::size_t number = 0; number < points.size(); ++number) {
        if (number % 4 == 0) {
          points_[number / 4] = Columns::all(points[number]);
        }
        points_[number / 4].put(number % 4, points[number]);
        parts_[number / 4][number % 4] = static_cast<std::int64_t>(part_of(static_cast<std::uint32_t>(number)));
      }
    }
    // Those of some points that hang together with one.
    [[nodiscard]] std::uint64_t near(std::size_t from, std::uint64_t some, Real most_square) const {
      const Columns point = Columns::all(points_[from / 4][from % 4]);
      const LaneNumbers part = LaneNumbers{} + parts_[from / 4][from % 4];
      std::uint64_t found = 0;
      for (std::uint64_t left = some; left != 0;) {
        const auto first = static_cast<std::size_t>(std::countr_zero(left)) / 4 * 4;
        const Columns way = points_[first / 4] - point;
        found |= bits_of((dot(way, way) <= all_lanes(most_square)) | (parts_[first / 4] == part)) << first;
        left &= ~(std::uint64_t{15} << first);
      }
      return found & some;
    }

   private:
    std::array<Columns, most_points / 4> points_{};
    std::array<LaneNumbers, most_points / 4> parts_{};
  };

  std::array<std::uint64_t, most_points> regions_{};
  std::size_t count_ = 0;
};

}  // namespace abut
