// SPDX-License-Identifier: Apache-2.0
// How one body moves as seen from another that moves and turns as well.
export module abut.motion.impacts.relative_motion;
import abut.core.standard;
import abut.math;
import abut.motion.paths.path;

export namespace abut {

// The largest speed of a point of b, and the largest acceleration, in the frame of a.
struct RelativeBounds {
  Real speed, bend;
};

// Of points of b up to `radius` from its centre. What turns with a is further from the centre of a than that.
[[nodiscard]] RelativeBounds relative_bounds(const Path& a, const Path& b, Real radius, const TimeSpan& span);

// The largest speed at which two bodies come nearer to each other, wherever they are. Infinite bodies that turn have
// none.
[[nodiscard]] Real largest_approach(const Path& a, Real radius_a, const Path& b, Real radius_b, const TimeSpan& span);

// A box in the frame that `frame` places on a, which holds at all times of the span what a box of b holds. `drift`
// receives how far the middle of the box moves, and `slack` by how much the box is larger for what is bent.
struct RelativeBox {
  Aabb box;
  Real drift, slack;
};
[[nodiscard]] RelativeBox relative_box(const Path& a, const Pose& frame, const Path& b, const Aabb& box_of_b,
                                       const TimeSpan& span);

}  // namespace abut
