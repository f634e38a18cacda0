// SPDX-License-Identifier: Apache-2.0
// How low boxes reach along a direction, for eight of them at once.
//
// A plane descends the tree of a surface by these heights. Sums of the single sides are double; nodes as low as the
// lowest so far, within rounding, are skipped. On a flat surface that would be all nodes.
export module abut.trees.volumes.box_heights;
import abut.core.standard;
import abut.math;

export namespace abut {

// Of the lowest corner of a box.
[[nodiscard]] inline Real least_along(const Aabb& box, const Vec3& direction) {
  return std::min(direction.x * box.low.x, direction.x * box.high.x) +
         std::min(direction.y * box.low.y, direction.y * box.high.y) +
         std::min(direction.z * box.low.z, direction.z * box.high.z);
}

// Sides are single, but sums are double: of a flat surface across the direction all boxes are equally low, and none
// seems lower by rounding.
class BoxHeights {
 public:
  using Way = Real;
  using Ways = std::array<Real, 8>;

  explicit BoxHeights(const Vec3& direction) : direction_{direction.x, direction.y, direction.z} {}

  [[nodiscard]] inline Real way_of(Real height) const { return height; }

  // The heights of the lowest corners of boxes, or infinity above `most`. The sides are low ones, then negated high
  // ones.
  template <class SideOf>
  [[nodiscard]] [[gnu::always_inline]] inline Ways entries(const SideOf& side, Real most) const {
    Ways lowest{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Real share = direction_[axis];
      const auto sides = side(share >= 0 ? axis : axis + 3);
      for (std::size_t lane = 0; lane < lowest.size(); ++lane) {
        lowest[lane] += static_cast<Real>(sides[lane]) * std::fabs(share);
      }
    }
    for (Real& height : lowest) {
      // Zero times infinity is NaN: such a box may reach anywhere.
      height = height > most ? infinity : std::max(-largest, height);
    }
    return lowest;
  }

 private:
  static constexpr Real largest = std::numeric_limits<Real>::max();

  std::array<Real, 3> direction_;
};

}  // namespace abut
