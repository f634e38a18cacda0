// SPDX-License-Identifier: Apache-2.0
// The space between two parallel planes, and which of eight boxes reach into it.
export module abut.trees.slab;
import abut.core.standard;
import abut.math;
import abut.trees.eight_boxes;

export namespace abut {

// The points p with low <= dot(normal, p) <= high.
class Slab {
 public:
  Slab(const Vec3& normal, Real low, Real high)
      : normal_{normal.x, normal.y, normal.z}, low_(low), negated_high_(-high) {}

  // As seen from a point.
  [[nodiscard]] Slab from(const Vec3& origin) const {
    const Vec3 normal{normal_[0], normal_[1], normal_[2]};
    const Real shift = dot(normal, origin);
    return {normal, low_ - shift, -negated_high_ - shift};
  }
  // A bit for each box. Sides are single and sums double: a box that touches the slab is not lost by rounding of sums
  // that are much longer than it is thick.
  [[nodiscard]] [[gnu::always_inline]] inline std::uint32_t reached_by(const EightBoxes& boxes) const {
    using Eight = Real __attribute__((ext_vector_type(8)));
    Eight lowest = 0, negated_highest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t low = normal_[axis] >= 0 ? axis : axis + 3, high = normal_[axis] >= 0 ? axis + 3 : axis;
      const Eight share = std::fabs(normal_[axis]);
      lowest += share * __builtin_convertvector(boxes.side(low), Eight);
      negated_highest += share * __builtin_convertvector(boxes.side(high), Eight);
    }
    const auto beyond = (lowest > Eight(-negated_high_)) | (negated_highest > Eight(-low_));
    using Mask = bool __attribute__((ext_vector_type(8)));
    const std::uint32_t mask = std::bit_cast<std::uint8_t>(__builtin_convertvector(beyond, Mask));
    return ~mask & 0xffu;
  }

 private:
  std::array<Real, 3> normal_;
  Real low_, negated_high_;
};

// A condition on triangles, as InFours has it, for those that reach into a slab. Others may be passed over in bulk.
template <class Ask>
struct InSlab {
  Ask ask;
  Slab slab;

  InSlab(const Ask& asked, const Slab& within) : ask(asked), slab(within) {}
};

}  // namespace abut
