// SPDX-License-Identifier: Apache-2.0
// A descent to the least depth of two cores where many directions are nearly as good: bodies of revolution that almost
// share an axis, a speck inside a round core.
//
// The support function of their difference D then has a long valley whose bottom hardly falls. A straight step along it
// leaves the bottom by more than it gains. So each step is brought back to the bottom before the depth judges it. These
// are second-order corrections against the Maratos effect (Nocedal and Wright, "Numerical optimization", 2006, chapters
// 15 and 18).
export module abut.narrow.polytope.depth_descent;
import abut.core.standard;
import abut.core;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.polytope.depth_minimum;

export namespace abut {

// Where a descent ended: at a minimum whose points are known, or where no move that was tried leads further down.
struct Descent {
  Vec3 normal;
  Real depth;
  std::optional<DepthMinimum> minimum;
};

[[nodiscard]] Descent descend(const Difference& cores, const Vec3& from, Real error, Real noise);

}  // namespace abut
