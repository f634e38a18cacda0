// The Minkowski difference a - b of two cores behind functions, for searches that are compiled once for all cores.
//
// A call through a function costs some nanoseconds; these searches take microseconds.
export module abut.narrow.cores.difference;
import abut.capability.second_order;
import abut.capability;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.direction_cover;
import abut.narrow.cores.outlines;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.cores.simplex;

export namespace abut {

// The points of two cores that reach furthest toward each other.
struct SupportPair {
  Vec3 a, b;
  std::uint32_t index_a, index_b;
};

// Directions in which the depth of two cores may be least for their symmetry.
struct SymmetricDirections {
  SmallVector<Vec3, 4> discs;     // unit: along the axes of flat discs
  SmallVector<Vec3, 6> outlines;  // across the outlines of two bodies of revolution around one axis; empty for others
  bool is_coaxial = false;
};

using SupportPairFunction = std::function<SupportPair(const Vec3& direction)>;
using PairGermFunction = std::function<PairGerm(const GermFrame& frame)>;
using AddBallsFunction = std::function<void(Real noise, DirectionCover& cover)>;

struct Difference {
  SupportPairFunction support;  // of a along a direction and of b against it, in the frame of a
  // Of curved cores: the support function to second order, their symmetries, and the balls inside.
  PairGermFunction germ;
  std::function<SymmetricDirections()> symmetries;
  AddBallsFunction add_balls;
  Real size;                 // bounds all coordinates
  Real least_extent;         // of the smaller core
  std::array<Vec3, 6> axes;  // unit: of the frames of both
  bool is_curved;

  // By which vertices and depths may be off.
  [[nodiscard]] inline Real noise() const { return 8 * epsilon * size; }
  [[nodiscard]] inline DifferenceVertex vertex_toward(const Vec3& direction) const {
    const SupportPair pair = support(direction);
    return {pair.a - pair.b, pair.a, pair.index_a, pair.index_b};
  }
  // The support function: how deep the cores overlap along a unit direction.
  [[nodiscard]] inline Real depth_along(const Vec3& n) const { return dot(n, vertex_toward(n).w); }
};

template <Convex A, Convex B>
[[nodiscard]] SymmetricDirections symmetric_directions(const A& a, const B& b, const Pose& ab, Real noise) {
  SymmetricDirections found;
  for (const Real side : {1.0, -1.0}) {
    if constexpr (Rimmed<A>) {
      if (a.supporting_rim({0, 0, side})) {
        found.discs.push_back(Vec3{0, 0, side});
      }
    }
    if constexpr (Rimmed<B>) {
      if (b.supporting_rim({0, 0, side})) {
        found.discs.push_back(-side * ab.rotation.z);
      }
    }
  }
  if constexpr (is_outlined<A> && is_outlined<B>) {
    found.is_coaxial = is_coaxial(ab, noise);
    if (found.is_coaxial) {
      collect_outlines(a, b, ab, found.outlines);
    }
  }
  return found;
}

using DifferenceUse = std::function<void(const Difference&)>;

// Calls with the difference of two cores, which lives as long as the call.
template <Convex A, Convex B>
[[gnu::noinline]] void use_difference(const A& a, const B& b, const Pose& ab, Real size, const DifferenceUse& use) {
  const auto placement = place(b, ab);
  const auto support = [&](const Vec3& direction) {
    const SupportPoint on_a = a.support(direction), on_b = placed_support(b, placement, -direction);
    return SupportPair{on_a.point, on_b.point, on_a.index, on_b.index};
  };
  const auto germ = [&](const GermFrame& frame) { return pair_germ(a, b, ab, frame); };
  const auto symmetries = [&] { return symmetric_directions(a, b, ab, 8 * epsilon * size); };
  const auto add_balls = [&](Real noise, DirectionCover& cover) { add_inner_balls(a, b, ab, noise, cover); };
  Difference cores;
  // One reference fits into a function itself: no memory is asked for.
  cores.support = [&support](const Vec3& direction) { return support(direction); };
  cores.size = size;
  cores.least_extent = std::fmin(a.extent(), b.extent());
  cores.axes = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, ab.rotation.x, ab.rotation.y, ab.rotation.z};
  cores.is_curved = Curved<A> || Curved<B>;
  if constexpr (Curved<A> || Curved<B>) {
    cores.germ = [&germ](const GermFrame& frame) { return germ(frame); };
    cores.symmetries = [&symmetries] { return symmetries(); };
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
