// SPDX-License-Identifier: Apache-2.0
// The Minkowski difference a - b of two cores behind functions, for searches that are compiled once for all cores.
//
// A call through a function costs some nanoseconds; these searches take microseconds.
export module abut.narrow.cores.difference;
import abut.capability.cores.second_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.math.tolerance;
import abut.narrow.cores.direction_cover;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.cores.simplex;

export namespace abut {

// The points of two cores that reach furthest toward each other.
struct SupportPair {
  Vec3 a, b;
  std::uint32_t index_a, index_b;
};

using SupportPairFunction = std::function<SupportPair(const Vec3& direction)>;
using SecondOrderFunction = std::function<PairSecondOrder(const DirectionFrame& frame)>;
using AddBallsFunction = std::function<void(Real noise, DirectionCover& cover)>;

struct Difference {
  SupportPairFunction support;  // of a along a direction and of b against it, in the frame of a
  // Only where a core is curved: the support function to second order, and the balls inside.
  SecondOrderFunction second_order;
  AddBallsFunction add_balls;
  Real size;  // bounds all coordinates
  bool is_curved;

  // By which vertices and depths may be off: both points of a vertex by a coordinate.
  [[nodiscard]] inline Real noise() const { return 2 * touching_distance(size); }
  [[nodiscard]] inline DifferenceVertex vertex_toward(const Vec3& direction) const {
    const SupportPair pair = support(direction);
    return {pair.a - pair.b, pair.a, pair.index_a, pair.index_b};
  }
  // The support function: how deep the cores overlap along a unit direction.
  [[nodiscard]] inline Real depth_along(const Vec3& n) const { return dot(n, vertex_toward(n).w); }
};

using DifferenceUse = std::function<void(const Difference&)>;

// Calls with the difference of two cores, which lives as long as the call.
template <Convex A, Convex B>
[[gnu::noinline]] void use_difference(const A& a, const B& b, const Pose& ab, Real size, const DifferenceUse& use) {
  const auto placement = place(b, ab);
  const auto support = [&](const Vec3& direction) {
    const SupportPoint on_a = a.support(direction), on_b = placed_support(b, placement, -direction);
    return SupportPair{on_a.point, on_b.point, on_a.index, on_b.index};
  };
  const auto second_order = [&](const DirectionFrame& frame) { return pair_second_order(a, b, ab, frame); };
  const auto add_balls = [&](Real noise, DirectionCover& cover) { add_inner_balls(a, b, ab, noise, cover); };
  Difference cores;
  // One reference fits into a function itself: no memory is asked for.
  cores.support = [&support](const Vec3& direction) { return support(direction); };
  cores.size = size;
  cores.is_curved = Curved<A> || Curved<B>;
  if constexpr (Curved<A> || Curved<B>) {
    cores.second_order = [&second_order](const DirectionFrame& frame) { return second_order(frame); };
    cores.add_balls = [&add_balls](Real noise, DirectionCover& cover) { add_balls(noise, cover); };
  }
  use(cores);
}

// The same, and hands on what the call answers.
template <Convex A, Convex B, class Use>
auto with_difference(const A& a, const B& b, const Pose& ab, Real size, Use&& use) {
  using Answer = std::invoke_result_t<Use, const Difference&>;
  if constexpr (std::is_same_v<Answer, void>) {
    use_difference(a, b, ab, size, [&use](const Difference& cores) { use(cores); });
  } else {
    Answer answer{};
    const auto keep = [&](const Difference& cores) { answer = use(cores); };
    use_difference(a, b, ab, size, [&keep](const Difference& cores) { keep(cores); });
    return answer;
  }
}

}  // namespace abut
