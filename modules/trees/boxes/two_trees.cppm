// SPDX-License-Identifier: Apache-2.0
// Two trees of boxes, of which one is placed in the frame of the other, are gone down at once: to the items whose boxes
// are near each other, the nearest first. Of two nodes the larger one is opened.
//
// The eight boxes of the opened node are compared with the other node along the axes of both, in single precision; the
// reach grows by a bound of the rounding, so no pair is lost. A distance orders nodes by their gap, a cast by the
// displacement after which the boxes touch. A surface needs only two functions for this (Hierarchy). A height field
// offers blocks of cells as nodes.
export module abut.trees.boxes.two_trees;
import abut.core.memory.small_vector;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.trees.volumes.eight_boxes;

export namespace abut {

// Eight boxes are compared at once, or four in double precision.
using EightFloats = EightBoxes::Floats;

// One side of all eight boxes, or of the first or last four of them.
template <class Numbers>
[[nodiscard]] [[gnu::always_inline]] inline Numbers side_of(const EightBoxes& eight, std::size_t side,
                                                            std::size_t half) {
  if constexpr (std::same_as<Numbers, EightFloats>) {
    return eight.side(side);
  } else {
    return __builtin_convertvector((std::bit_cast<std::array<SingleLanes, 2>>(eight.sides[side])[half]), Lanes);
  }
}
[[nodiscard]] [[gnu::always_inline]] inline EightFloats magnitudes(const EightFloats& numbers) {
  return numbers < 0 ? -numbers : numbers;
}

// A box in one register, which is copied at once: its six sides, and minus their sum, which tells how large it is.
using OneBox = EightFloats;

[[nodiscard]] inline OneBox one_box(const BoxSides& sides) {
  return {sides[0],
          sides[1],
          sides[2],
          sides[3],
          sides[4],
          sides[5],
          -(sides[0] + sides[1] + sides[2] + sides[3] + sides[4] + sides[5])};
}
// All eight: a matrix is turned, in blocks of one, two and four numbers.
[[nodiscard]] [[gnu::always_inline]] inline std::array<OneBox, 8> boxes_of(const EightBoxes& eight) {
  std::array<EightFloats, 8> rows, ones, twos;
  rows[6] = rows[7] = EightFloats{};
  for (std::size_t i = 0; i < 6; ++i) {
    rows[i] = eight.side(i);
    rows[6] -= rows[i];
  }
  for (std::size_t i = 0; i < 8; i += 2) {
    ones[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    ones[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (std::size_t i = 0; i < 8; i += 4) {
    for (std::size_t j = i; j < i + 2; ++j) {
      twos[j] = __builtin_shufflevector(ones[j], ones[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      twos[j + 2] = __builtin_shufflevector(ones[j], ones[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    rows[i] = __builtin_shufflevector(twos[i], twos[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    rows[i + 4] = __builtin_shufflevector(twos[i], twos[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
  return rows;
}

// Ways of eight boxes, or their squares.
using EightWays = std::array<Lanes, 2>;

// How boxes of two trees lie to each other, along the axes of either. Most boxes that are apart are so along one of
// these; the axes across two edges would add little (van den Bergen, "Efficient collision detection of complex
// deformable models using AABB trees", 1997).
class BoxAxes {
 public:
  // b is placed by ab.
  BoxAxes(const Vec3& origin_a, const Vec3& origin_b, const Pose& ab)
      : b_in_a_(Pose{ab.rotation, ab * origin_b - origin_a}), a_in_b_(b_in_a_.pose.inverse()) {}

  // Calls take(axis, between, reach) for the axes of both, those of the eight boxes first: how far the other box is
  // from the middles of boxes, and the sums of the half extents. Of eight, the reach covers the rounding.
  template <class Numbers, class Take>
  [[gnu::always_inline]] inline void for_each(const EightBoxes& eight, std::size_t part, const OneBox& other,
                                              bool are_of_b, Take&& take) const {
    constexpr bool are_eight = std::same_as<Numbers, EightFloats>;
    using Number = std::remove_reference_t<decltype(Numbers{}[0])>;
    constexpr Number one_half = 0.5;
    const Placing &to_eight = are_of_b ? a_in_b_ : b_in_a_, &to_other = are_of_b ? b_in_a_ : a_in_b_;
    const auto three = [&](std::size_t at) {
      return Vec3{static_cast<Real>(other[at]), static_cast<Real>(other[at + 1]), static_cast<Real>(other[at + 2])};
    };
    const Vec3 low = three(0), minus_high = three(3);
    const Vec3 centre = 0.5 * (low - minus_high), half = -0.5 * (low + minus_high);
    const Vec3 placed = to_eight.pose * centre, placed_half = to_eight.wide * half;
    const Vec3 from_other = centre - to_other.pose.position;
    std::array<Numbers, 3> centres, halves;
    Numbers rounding{};
    for (std::size_t at = 0; at < 3; ++at) {
      const Numbers lows = side_of<Numbers>(eight, at, part), minus_highs = side_of<Numbers>(eight, at + 3, part);
      centres[at] = one_half * (lows - minus_highs);
      halves[at] = -one_half * (lows + minus_highs);
    }
    if constexpr (are_eight) {
      // Each step rounds by 2^-24 of numbers that are no larger than the sum of these. No axis takes more than 32.
      constexpr float share = 0x1p-19f;
      const auto sum = [](const Vec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); };
      rounding = share * (magnitudes(centres[0]) + magnitudes(centres[1]) + magnitudes(centres[2]) + halves[0] +
                          halves[1] + halves[2] + static_cast<float>(sum(placed) + sum(placed_half) + sum(centre)));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      take(axis, static_cast<Number>(placed[axis]) - centres[at],
           static_cast<Number>(placed_half[axis]) + halves[at] + rounding);
    }
    const auto sum_along = [](const Rotation& rotation, int axis, const std::array<Numbers, 3>& of) {
      return static_cast<Number>(rotation.x[axis]) * of[0] + static_cast<Number>(rotation.y[axis]) * of[1] +
             static_cast<Number>(rotation.z[axis]) * of[2];
    };
    for (int axis = 0; axis < 3; ++axis) {
      take(axis + 3, static_cast<Number>(from_other[axis]) - sum_along(to_other.pose.rotation, axis, centres),
           static_cast<Number>(half[axis]) + sum_along(to_other.wide, axis, halves) + rounding);
    }
  }

 private:
  struct Placing {
    Pose pose;
    Rotation wide;  // the magnitudes of its numbers

    explicit inline Placing(const Pose& its)
        : pose(its), wide{absolute(its.rotation.x), absolute(its.rotation.y), absolute(its.rotation.z)} {}
  };
  Placing b_in_a_, a_in_b_;
};

// No number is larger than before after a few roundings and this.
inline constexpr float inward = 1 - 0x1p-20f;

[[nodiscard]] [[gnu::always_inline]] inline EightWays in_double(const EightFloats& numbers) {
  const auto [low, high] = std::bit_cast<std::array<SingleLanes, 2>>(numbers);
  return {__builtin_convertvector(low, Lanes), __builtin_convertvector(high, Lanes)};
}

// The order of two trees that stand still: what is no further apart than a reach.
class GapOrder {
 public:
  GapOrder(const Vec3& origin_a, const Vec3& origin_b, const Pose& ab) : axes_(origin_a, origin_b, ab) {}

  // Squares, which no two points of the boxes are nearer than. A box beyond all numbers is near.
  [[nodiscard]] [[gnu::always_inline]] inline EightWays ways(const EightBoxes& eight, const OneBox& other,
                                                             bool are_of_b) const {
    // Squares of longer ones may have no number.
    constexpr float most = 1e18f;
    EightFloats own{}, of_other{};
    axes_.for_each<EightFloats>(eight, 0, other, are_of_b, [&](int axis, EightFloats between, EightFloats reach) {
      const EightFloats beyond = magnitudes(between) - reach, gap = beyond > 0 ? (beyond < most ? beyond : most) : 0;
      (axis < 3 ? own : of_other) += gap * gap;
    });
    // The sum of squares has rounded three times.
    return in_double(inward * (own > of_other ? own : of_other));
  }
  [[nodiscard]] static inline Real way_of(Real reach) { return reach < 0 ? -1 : reach * reach; }

 private:
  BoxAxes axes_;
};

// The order of two trees of which b moves along a direction: what is met up to a way.
class PassageOrder {
 public:
  // `direction`: in the frame of a. Boxes are met where they are no further apart than `slack`.
  PassageOrder(const Vec3& origin_a, const Vec3& origin_b, const Pose& ab, const Vec3& direction, Real slack)
      : axes_(origin_a, origin_b, ab), slack_(static_cast<float>((1 + 1e-6) * slack)) {
    const Vec3 in_b = ab.rotation.undo(direction);
    for (int axis = 0; axis < 3; ++axis) {
      inverses_[static_cast<std::size_t>(axis)] = inverse_of(direction[axis]);
      inverses_[static_cast<std::size_t>(axis) + 3] = inverse_of(in_b[axis]);
    }
  }

  // The ways after which boxes are met, or infinity.
  [[nodiscard]] [[gnu::always_inline]] inline EightWays ways(const EightBoxes& eight, const OneBox& other,
                                                             bool are_of_b) const {
    constexpr float none = std::numeric_limits<float>::infinity();
    EightFloats enter{}, leave = EightFloats(none);
    axes_.for_each<EightFloats>(eight, 0, other, are_of_b, [&](int axis, EightFloats between, EightFloats reach) {
      // Seen from boxes of b the other one moves backward. Axes come in the order of the eight.
      const auto at = static_cast<std::size_t>(are_of_b ? (axis + 3) % 6 : axis);
      const float inverse = are_of_b ? -inverses_[at] : inverses_[at];
      const EightFloats wide = reach + slack_, one = (-wide - between) * inverse, two = (wide - between) * inverse;
      const EightFloats first = one < two ? one : two, last = one < two ? two : one;
      enter = first > enter ? first : enter;
      leave = last < leave ? last : leave;
    });
    return in_double(inward * enter > leave ? EightFloats(none) : inward * enter);
  }
  [[nodiscard]] static inline Real way_of(Real limit) { return limit; }

 private:
  // Slower parts of a motion count as this one: boxes are met or not, whichever way is gone.
  [[nodiscard]] static inline float inverse_of(Real speed) {
    constexpr Real slowest = 1e-30;
    return static_cast<float>(1 / (std::fabs(speed) > slowest ? speed : slowest));
  }

  BoxAxes axes_;
  std::array<float, 6> inverses_;  // of the speed along the axes of a, then of b
  float slack_;
};

struct WantsAnyItem {
  [[nodiscard]] inline bool operator()(std::uint32_t, bool) const { return true; }
};

// Calls visit(item of a, item of b) for items whose boxes an order says to be met up to `most`, in its order, mostly.
// visit returns up to which way more are wanted. Items are left out of which wants(item, whether it is of b) is false.
template <Hierarchy A, Hierarchy B, class Order, class Visitor, class Wants = WantsAnyItem>
void visit_two(const A& a, const B& b, const Order& order, Real most, Visitor&& visit, Wants&& wants = {}) {
  struct Waiting {
    OneBox box_a, box_b;
    Real way;
    std::uint32_t a, b;
  };
  const auto root_of = [](const auto& tree) {
    BoxSides root = no_sides;
    tree.visit_children(0, [&](const EightBoxes& eight) { root = merged(root, eight.sides_around()); });
    return one_box(root);
  };
  SmallVector<Waiting, 96> waiting;
  waiting.push_back({root_of(a), root_of(b), 0, 0, 0});
  Real limit = order.way_of(most);
  const auto open = [&](const auto& tree, const Waiting& its, bool is_b) {
    const OneBox other = is_b ? its.box_a : its.box_b;
    const std::uint32_t number_of_other = is_b ? its.a : its.b;
    tree.visit_children(is_b ? its.b : its.a, [&](const EightBoxes& eight) {
      const EightWays ways = order.ways(eight, other, is_b);
      const std::uint64_t beyond = bits_of(ways[0] > all_lanes(limit)) | bits_of(ways[1] > all_lanes(limit))
                                                                             << std::size_t{4};
      struct Met {
        Real way;
        std::size_t lane;
      };
      // The nearest one comes last, and next off the list.
      [[clang::uninitialized]] std::array<Met, 8> met;
      std::size_t count = 0;
      for (std::uint64_t left = eight.present() & ~beyond; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const std::uint32_t number = eight.numbers[lane];
        if (EightBoxes::is_item(number) && !wants(EightBoxes::item_of(number), is_b)) {
          continue;
        }
        const Real way = ways[lane / 4][lane % 4];
        std::size_t place = count++;
        for (; place > 0 && met[place - 1].way < way; --place) {
          met[place] = met[place - 1];
        }
        met[place] = {way, lane};
      }
      if (count == 0) {
        return;
      }
      const std::array<OneBox, 8> boxes = boxes_of(eight);
      for (const Met& one : std::span(met).first(count)) {
        const OneBox& box = boxes[one.lane];
        const std::uint32_t number = eight.numbers[one.lane];
        waiting.push_back(is_b ? Waiting{other, box, one.way, number_of_other, number}
                               : Waiting{box, other, one.way, number, number_of_other});
      }
    });
  };
  while (!waiting.empty()) {
    const Waiting next = waiting[waiting.size() - 1];
    waiting.pop_back();
    if (next.way > limit) {
      continue;
    }
    const bool is_item_a = EightBoxes::is_item(next.a), is_item_b = EightBoxes::is_item(next.b);
    if (is_item_a && is_item_b) {
      limit = order.way_of(visit(EightBoxes::item_of(next.a), EightBoxes::item_of(next.b)));
    } else if (is_item_b || (!is_item_a && next.box_a[6] >= next.box_b[6])) {
      open(a, next, false);
    } else {
      open(b, next, true);
    }
  }
}

}  // namespace abut
