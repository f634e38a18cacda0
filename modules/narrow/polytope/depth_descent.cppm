// Least depths of two cores where many directions are nearly as good: bodies of revolution that almost share an axis, a
// speck inside a round core.
//
// The support function of their difference D then has a long valley whose bottom hardly falls. A straight step along it
// leaves the bottom by more than it gains, so each step is brought back to the bottom before it is judged, by the depth
// itself (second-order corrections against the Maratos effect: Nocedal and Wright, "Numerical optimization", 2006,
// chapters 15 and 18).
export module abut.narrow.polytope.depth_descent;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.depth_minimum;
import abut.narrow.polytope.epa;

export namespace abut {

// From a direction n to n + (x, y).
struct Move {
  Real x, y;
};

// The valley around a direction: across it to the bottom, none where the bottom is farther than a radius; and along it,
// of length one.
struct Valley {
  Move to_bottom, along;
};
[[nodiscard]] Valley valley_of(const PairGerm& germ, Real radius);

// Moves of one length that may lead down: against the slope, where D is softest, and along each crease.
using Moves = SmallVector<Move, 28>;
void collect_moves(const PairGerm& germ, Real length, Moves& moves);

// Where a descent ended: at a minimum whose points are known, or where no move that was tried leads further down.
struct Descent {
  Vec3 normal;
  Real depth;
  std::optional<DepthMinimum> minimum;
};

[[nodiscard]] Descent descend(const Difference& cores, const Vec3& from, Real error, Real noise);

// Along the bottom of the valley that a direction lies in, as long as `visit` answers true.
void walk_valley(const Difference& cores, const Vec3& from, const std::function<bool(const Vec3&)>& visit);

// The least depth that descents reach from the answer of a search that ended without a proof, from the discs, and from
// the best of a sweep of directions.
[[nodiscard]] EpaResult least_of_descents(const Difference& cores, Real error, const EpaResult& found);

}  // namespace abut
