// SPDX-License-Identifier: Apache-2.0
// Boxes side by side in vector registers, so that one is compared with eight at once.
export module abut.trees.volumes.eight_boxes;
import abut.core.standard;
import abut.math;
import abut.trees.volumes.box_heights;
import abut.trees.volumes.box_sweep;

export namespace abut {

// The low sides and the negated high sides of a box. That way a box around two others has the lesser of each side, and
// two boxes overlap when no side of one is beyond the opposite side of the other.
using BoxSides = std::array<float, 6>;

[[nodiscard]] inline BoxSides sides_of(const CompactAabb& box) {
  return {box.low[0], box.low[1], box.low[2], -box.high[0], -box.high[1], -box.high[2]};
}
[[nodiscard]] inline CompactAabb box_of(const BoxSides& sides) {
  return {{sides[0], sides[1], sides[2]}, {-sides[3], -sides[4], -sides[5]}};
}
[[nodiscard]] inline BoxSides merged(const BoxSides& a, const BoxSides& b) {
  BoxSides both;
  for (std::size_t i = 0; i < both.size(); ++i) {
    both[i] = a[i] < b[i] ? a[i] : b[i];
  }
  return both;
}

// Beyond every limit: where there is no box.
inline constexpr BoxSides no_sides = [] {
  BoxSides sides{};
  sides.fill(std::numeric_limits<float>::infinity());
  return sides;
}();

// What the sides of a box that overlaps do not exceed. They are finite, so that no_sides do.
[[nodiscard]] inline BoxSides limits_of(const CompactAabb& box) {
  constexpr float far = std::numeric_limits<float>::max();
  BoxSides limits;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    limits[axis] = std::min(box.high[axis], far);
    limits[axis + 3] = std::min(-box.low[axis], far);
  }
  return limits;
}

struct alignas(32) EightBoxes {
  using Floats = CompactSweep::Floats;
  using Numbers = std::int32_t __attribute__((ext_vector_type(8)));
  static constexpr std::size_t width = 8;

  // One side of all boxes. Kept as numbers, not as a vector: writing one of a vector writes them all, and several
  // threads give boxes of one block new sides at once.
  struct alignas(32) Side {
    std::array<float, width> of;

    inline Side() { of.fill(no_sides[0]); }
  };
  std::array<Side, 6> sides;
  std::array<std::uint32_t, width> numbers{};  // whatever the owner calls the boxes

  // In a Hierarchy a number is that of a node, with this bit that of an item, or nobody.
  static constexpr std::uint32_t item_bit = 0x80000000, nobody = 0x7fffffff;
  [[nodiscard]] static constexpr bool is_item(std::uint32_t number) { return (number & item_bit) != 0; }
  [[nodiscard]] static constexpr std::uint32_t item_of(std::uint32_t number) { return number & ~item_bit; }
  // A bit for each box that is there.
  [[nodiscard]] inline std::uint32_t present() const {
    return ~mask_of(std::bit_cast<Numbers>(numbers) == Numbers(static_cast<std::int32_t>(nobody))) & 0xffu;
  }

  // One side of all boxes at once.
  [[nodiscard]] inline Floats side(std::size_t i) const { return std::bit_cast<Floats>(sides[i]); }

  [[nodiscard]] static inline std::uint32_t mask_of(Numbers lanes) {
    using Mask = bool __attribute__((ext_vector_type(8)));
    return std::bit_cast<std::uint8_t>(__builtin_convertvector(lanes, Mask));
  }
  // A bit for each box.
  [[nodiscard]] inline std::uint32_t overlapping(const BoxSides& limits) const {
    Numbers beyond = side(0) > limits[0];
    for (std::size_t i = 1; i < limits.size(); ++i) {
      beyond |= side(i) > limits[i];
    }
    return ~mask_of(beyond) & 0xffu;
  }
  // The same with limits that are the same in all lanes, for one box that is compared with many.
  using WideLimits = std::array<Floats, 6>;
  [[nodiscard]] static inline WideLimits widened(const BoxSides& limits) {
    return {Floats(limits[0]), Floats(limits[1]), Floats(limits[2]),
            Floats(limits[3]), Floats(limits[4]), Floats(limits[5])};
  }
  [[nodiscard]] [[gnu::always_inline]] inline std::uint32_t overlapping(const WideLimits& limits) const {
    const Numbers beyond = (side(0) > limits[0]) | (side(1) > limits[1]) | (side(2) > limits[2]) |
                           (side(3) > limits[3]) | (side(4) > limits[4]) | (side(5) > limits[5]);
    return ~mask_of(beyond) & 0xffu;
  }
  // The way at which each is met, as a CompactSweep or BoxHeights says it.
  template <class Order>
  [[nodiscard]] [[gnu::always_inline]] inline auto entries(const Order& order, typename Order::Way most) const {
    return order.entries([&](std::size_t i) { return side(i); }, most);
  }
  // A bit for each box that is met.
  [[nodiscard]] static inline std::uint32_t met(Floats entries) {
    return mask_of(entries < std::numeric_limits<float>::infinity());
  }
  [[nodiscard]] static inline std::uint32_t met(const BoxHeights::Ways& entries) {
    std::uint32_t met = 0;
    for (std::size_t lane = 0; lane < width; ++lane) {
      met |= (entries[lane] < infinity ? 1u : 0u) << lane;
    }
    return met;
  }

  [[nodiscard]] inline BoxSides sides_of_lane(std::size_t lane) const {
    BoxSides lane_sides;
    for (std::size_t i = 0; i < lane_sides.size(); ++i) {
      lane_sides[i] = sides[i].of[lane];
    }
    return lane_sides;
  }
  // Lanes without a box do not count.
  [[nodiscard]] inline BoxSides sides_around() const {
    BoxSides around;
    for (std::size_t i = 0; i < around.size(); ++i) {
      around[i] = __builtin_reduce_min(side(i));
    }
    return around;
  }
  inline void set_sides(std::size_t lane, const BoxSides& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
      sides[i].of[lane] = given[i];
    }
  }
  // Without any box.
  [[nodiscard]] static inline EightBoxes empty() {
    EightBoxes none;
    none.numbers.fill(nobody);
    return none;
  }
};

struct AcceptsEightBoxes {
  void operator()(const EightBoxes&) const {}
};

// What can be gone down from boxes to items. visit_children hands over the boxes of the children of a node, eight at a
// time and relative to the origin; they are numbered as nodes or as items. The root is node 0.
template <class T>
concept Hierarchy = requires(const T& tree, std::uint32_t node, AcceptsEightBoxes visitor) {
  { tree.origin() } -> std::convertible_to<Vec3>;
  tree.visit_children(node, visitor);
};

}  // namespace abut
