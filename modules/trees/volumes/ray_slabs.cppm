// SPDX-License-Identifier: Apache-2.0
// A ray against boxes, slab by slab. The boxes count as a little wider than they are: triangles are met in coordinates
// that are rounded, and the box of a triangle that is met so must not be missed.
export module abut.trees.volumes.ray_slabs;
import abut.core.standard;
import abut.math;

export namespace abut {

[[nodiscard]] [[gnu::always_inline]] inline Aabb in_double(const CompactAabb& box) {
  const auto wide = [](const std::array<float, 3>& p) {
    return Vec3{static_cast<Real>(p[0]), static_cast<Real>(p[1]), static_cast<Real>(p[2])};
  };
  return {wide(box.low), wide(box.high)};
}

class RaySlabs {
 public:
  // The stretch of the ray that is left, by the distance from its origin.
  struct Stretch {
    Real enter, leave;
    [[nodiscard]] inline bool is_empty() const { return !(enter <= leave * (1 + 4 * epsilon)); }
    [[nodiscard]] inline Stretch until(Real limit) const { return {enter, limit < leave ? limit : leave}; }
  };

  // `bounds`: of all boxes that are asked about. Seen from its origin, coordinates of points in a box are
  // off by at most three units of rounding of the furthest one. Eight are allowed.
  inline RaySlabs(const Vec3& origin, const Vec3& direction, const Aabb& bounds)
      : origin_(origin),
        direction_(direction),
        inverse_{inverse_of(direction.x), inverse_of(direction.y), inverse_of(direction.z)},
        is_reversed_{direction.x < 0, direction.y < 0, direction.z < 0},
        slack_(8 * epsilon *
               largest_magnitude(maximum(absolute(bounds.low - origin), absolute(bounds.high - origin)))) {}

  [[nodiscard]] inline bool is_reversed(std::size_t axis) const { return is_reversed_[axis]; }

  // What is left between two planes across an axis.
  [[nodiscard]] [[gnu::always_inline]] inline Stretch within(int axis, Real low, Real high,
                                                             const Stretch& before) const {
    const bool is_reversed = is_reversed_[static_cast<std::size_t>(axis)];
    const Real slack = is_reversed ? -slack_ : slack_, near = is_reversed ? high : low, far = is_reversed ? low : high;
    const Real enter = (near - origin_[axis] - slack) * inverse_[axis],
               leave = (far - origin_[axis] + slack) * inverse_[axis];
    // 0 * infinity gives NaN for a ray that lies in a plane: then the slab holds the whole ray.
    return {enter > before.enter ? enter : before.enter, leave < before.leave ? leave : before.leave};
  }
  [[nodiscard]] [[gnu::always_inline]] inline Stretch within(const Aabb& box, const Stretch& before) const {
    return within(2, box.low.z, box.high.z, within(1, box.low.y, box.high.y, within(0, box.low.x, box.high.x, before)));
  }

  // The first and the last element that a stretch may pass over along an axis. All have one size, and element zero
  // begins at zero.
  struct Range {
    std::uint32_t first, last;
  };
  [[nodiscard]] inline Range passed(int axis, const Stretch& over, Real size, const Range& all) const {
    const Real from = origin_[axis] + over.enter * direction_[axis], to = origin_[axis] + over.leave * direction_[axis];
    const Real slack = slack_ + 1e-6 * size;
    const Real low = ((from < to ? from : to) - slack) / size, high = ((from < to ? to : from) + slack) / size;
    return {low > all.first ? static_cast<std::uint32_t>(std::min(low, static_cast<Real>(all.last))) : all.first,
            high < all.last ? static_cast<std::uint32_t>(std::max(high, static_cast<Real>(all.first))) : all.last};
  }

 private:
  [[nodiscard]] static inline Real inverse_of(Real value) { return value == 0 ? infinity : 1 / value; }

  Vec3 origin_, direction_, inverse_;
  std::array<bool, 3> is_reversed_;
  Real slack_;
};

}  // namespace abut
