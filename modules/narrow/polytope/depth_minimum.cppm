// SPDX-License-Identifier: Apache-2.0
// Least depths of two cores of which one is curved: directions in which the support function of their difference D is
// least among those nearby, and the cap of directions around each in which surely nothing is less.
//
// At a minimum n of depth d the point d n belongs to D. D reaches beyond it by at least a quadratic form. The ball of
// radius d is in D where that form exceeds
//   d |w|^2, for directions n + w.
export module abut.narrow.polytope.depth_minimum;
import abut.capability.cores.second_order;
import abut.core.standard;
import abut.math;
import abut.narrow.cores.difference;
import abut.narrow.cores.second_order_of_pair;
import abut.narrow.polytope.newton_step;

export namespace abut {

struct DepthMinimum {
  Vec3 normal;        // unit
  Real depth, upper;  // along the normal; rounding and what the search has left lie between them
  Real lower;         // no direction in the cap has less
  Real cosine;        // of the angle of the cap, at most a right one
  Vec3 point_a, point_b;
};

// The minimum in the direction of a frame, after a step that leads nowhere else, with a cap of that direction alone.
[[nodiscard]] DepthMinimum minimum_at(const DirectionFrame& frame, const PairSecondOrder& near, const NewtonStep& step);

// The minimum that Newton's method comes to from a unit direction; nothing where no cap around it is proven.
[[nodiscard]] std::optional<DepthMinimum> minimum_near(const Difference& cores, const Vec3& direction, Real error,
                                                       Real noise);

}  // namespace abut
