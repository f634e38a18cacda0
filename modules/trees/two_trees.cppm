// SPDX-License-Identifier: Apache-2.0
// Two trees of boxes, of which one is placed in the frame of the other, are gone down at once: to the items whose boxes
// are near each other, the nearest first. Of two nodes the larger one is opened.
export module abut.trees.two_trees;
import abut.core.small_vector;
import abut.core.standard;
import abut.math;
import abut.math.tolerance;
import abut.trees.eight_boxes;

export namespace abut {

// One side of four of eight boxes, the first or the last ones.
[[nodiscard]] [[gnu::always_inline]] inline Lanes side_of_four(const EightBoxes& eight, std::size_t side,
                                                               std::size_t half) {
  return __builtin_convertvector((std::bit_cast<std::array<SingleLanes, 2>>(eight.sides[side])[half]), Lanes);
}

// How boxes of two trees lie to each other, along the axes of either. Most boxes that are apart are so along one of
// these; the axes across two edges would add little (van den Bergen, "Efficient collision detection of complex
// deformable models using AABB trees", 1997).
class BoxAxes {
 public:
  // b is placed by ab.
  BoxAxes(const Vec3& origin_a, const Vec3& origin_b, const Pose& ab)
      : b_in_a_(Pose{ab.rotation, ab * origin_b - origin_a}), a_in_b_(b_in_a_.pose.inverse()) {}

  // Calls take(axis, between, reach) for the axes of both, those of the eight boxes first: how far the other box is
  // from the middles of four of them, and the sums of the half extents.
  template <class Take>
  [[gnu::always_inline]] inline void for_each(const EightBoxes& eight, std::size_t four, const BoxSides& other,
                                              bool are_of_b, Take&& take) const {
    const Placing &to_eight = are_of_b ? a_in_b_ : b_in_a_, &to_other = are_of_b ? b_in_a_ : a_in_b_;
    const auto three = [&](std::size_t at) {
      return Vec3{static_cast<Real>(other[at]), static_cast<Real>(other[at + 1]), static_cast<Real>(other[at + 2])};
    };
    const Vec3 low = three(0), minus_high = three(3);
    const Vec3 centre = 0.5 * (low - minus_high), half = -0.5 * (low + minus_high);
    const Vec3 placed = to_eight.pose * centre, placed_half = to_eight.wide * half;
    std::array<Lanes, 3> centres, halves;
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      const Lanes lows = side_of_four(eight, at, four), minus_highs = side_of_four(eight, at + 3, four);
      centres[at] = 0.5 * (lows - minus_highs);
      halves[at] = -0.5 * (lows + minus_highs);
      take(axis, placed[axis] - centres[at], placed_half[axis] + halves[at]);
    }
    const auto sum_along = [](const Rotation& rotation, int axis, const std::array<Lanes, 3>& of) {
      return rotation.x[axis] * of[0] + rotation.y[axis] * of[1] + rotation.z[axis] * of[2];
    };
    for (int axis = 0; axis < 3; ++axis) {
      take(axis + 3, centre[axis] - to_other.pose.position[axis] - sum_along(to_other.pose.rotation, axis, centres),
           half[axis] + sum_along(to_other.wide, axis, halves));
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

// The order of two trees that stand still: what is no further apart than a reach.
class GapOrder {
 public:
  GapOrder(const Vec3& origin_a, const Vec3& origin_b, const Pose& ab) : axes_(origin_a, origin_b, ab) {}

  // Squares, which no two points of the boxes are nearer than. A box beyond all numbers is near.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes ways(const EightBoxes& eight, std::size_t four,
                                                         const BoxSides& other, bool are_of_b) const {
    Lanes own = all_lanes(0), of_other = all_lanes(0);
    axes_.for_each(eight, four, other, are_of_b, [&](int axis, Lanes between, Lanes reach) {
      const Lanes beyond = absolute(between) - reach, gap = beyond > 0 ? beyond : all_lanes(0);
      (axis < 3 ? own : of_other) += gap * gap;
    });
    return own > of_other ? own : of_other;
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
      : axes_(origin_a, origin_b, ab), slack_(slack) {
    const Vec3 in_b = ab.rotation.undo(direction);
    for (int axis = 0; axis < 3; ++axis) {
      inverses_[static_cast<std::size_t>(axis)] = inverse_of(direction[axis]);
      inverses_[static_cast<std::size_t>(axis) + 3] = inverse_of(in_b[axis]);
    }
  }

  // The ways after which boxes are met, or infinity.
  [[nodiscard]] [[gnu::always_inline]] inline Lanes ways(const EightBoxes& eight, std::size_t four,
                                                         const BoxSides& other, bool are_of_b) const {
    Lanes enter = all_lanes(0), leave = all_lanes(infinity);
    axes_.for_each(eight, four, other, are_of_b, [&](int axis, Lanes between, Lanes reach) {
      // Seen from boxes of b the other one moves backward. Axes come in the order of the eight.
      const auto at = static_cast<std::size_t>(are_of_b ? (axis + 3) % 6 : axis);
      const Real inverse = are_of_b ? -inverses_[at] : inverses_[at];
      const Lanes wide = reach + slack_, one = (-wide - between) * inverse, two = (wide - between) * inverse;
      const Lanes first = one < two ? one : two, last = one < two ? two : one;
      enter = first > enter ? first : enter;
      leave = last < leave ? last : leave;
    });
    return enter > leave ? all_lanes(infinity) : enter;
  }
  [[nodiscard]] static inline Real way_of(Real limit) { return limit; }

 private:
  // Slower parts of a motion count as this one: boxes are met or not, whichever way is gone.
  [[nodiscard]] static inline Real inverse_of(Real speed) {
    constexpr Real slowest = 1e-200;
    return 1 / (std::fabs(speed) > slowest ? speed : slowest);
  }

  BoxAxes axes_;
  std::array<Real, 6> inverses_;  // of the speed along the axes of a, then of b
  Real slack_;
};

struct WantsAnyItem {
  bool operator()(std::uint32_t, bool) const { return true; }
};

// Calls visit(item of a, item of b) for items whose boxes an order says to be met up to `most`, in its order, mostly.
// visit returns up to which way more are wanted. Items are left out of which wants(item, whether it is of b) is false.
template <Hierarchy A, Hierarchy B, class Order, class Visitor, class Wants = WantsAnyItem>
void visit_two(const A& a, const B& b, const Order& order, Real most, Visitor&& visit, Wants&& wants = {}) {
  struct Side {
    std::uint32_t number;
    BoxSides sides;

    [[nodiscard]] inline bool is_item() const { return EightBoxes::is_item(number); }
    [[nodiscard]] inline float size() const {
      return -(sides[0] + sides[1] + sides[2] + sides[3] + sides[4] + sides[5]);
    }
  };
  struct Waiting {
    Real way;
    Side a, b;
  };
  const auto root_of = [](const auto& tree) {
    Side root{0, no_sides};
    tree.visit_children(0, [&](const EightBoxes& eight) { root.sides = merged(root.sides, eight.sides_around()); });
    return root;
  };
  SmallVector<Waiting, 96> waiting;
  waiting.push_back({0, root_of(a), root_of(b)});
  Real limit = order.way_of(most);
  const auto open = [&](const auto& tree, const Waiting& its, bool is_b) {
    const std::size_t begin = waiting.size();
    const Side& other = is_b ? its.a : its.b;
    tree.visit_children((is_b ? its.b : its.a).number, [&](const EightBoxes& eight) {
      const auto ways = std::bit_cast<std::array<Real, 8>>(
          std::array{order.ways(eight, 0, other.sides, is_b), order.ways(eight, 1, other.sides, is_b)});
      for (std::uint32_t left = eight.present(); left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        const Real way = ways[lane];
        if (way > limit ||
            (EightBoxes::is_item(eight.numbers[lane]) && !wants(EightBoxes::item_of(eight.numbers[lane]), is_b))) {
          continue;
        }
        // The nearest one comes last, and next off the list.
        const Side side{eight.numbers[lane], eight.sides_of_lane(lane)};
        waiting.push_back({way, is_b ? other : side, is_b ? side : other});
        const std::span<Waiting> list = waiting.span();
        for (std::size_t place = list.size() - 1; place > begin && list[place - 1].way < list[place].way; --place) {
          std::swap(list[place - 1], list[place]);
        }
      }
    });
  };
  while (!waiting.empty()) {
    const Waiting next = waiting[waiting.size() - 1];
    waiting.pop_back();
    if (next.way > limit) {
      continue;
    }
    if (next.a.is_item() && next.b.is_item()) {
      limit = order.way_of(visit(EightBoxes::item_of(next.a.number), EightBoxes::item_of(next.b.number)));
    } else if (next.b.is_item() || (!next.a.is_item() && next.a.size() >= next.b.size())) {
      open(a, next, false);
    } else {
      open(b, next, true);
    }
  }
}

}  // namespace abut
