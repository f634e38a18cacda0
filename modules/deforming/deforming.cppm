// SPDX-License-Identifier: Apache-2.0
// When a vertex meets a face, and an edge an edge, while all of their vertices move on straight lines at constant
// speeds: the question of meshes that deform. Time runs from 0 to 1.
export module abut.deforming;
import abut.core.standard;
import abut.math;

export namespace abut {

// A vertex on its way.
struct MovingPoint {
  Vec3 start, end;
};

// The first touch lies in [lower, upper]. Before `lower` nothing touches.
struct MovingTouch {
  bool touches = false;
  Real lower = 0, upper = 0;
};

// With a separation of 0, whether they touch is exact: shapes that come to one point do, and no rounding of the inputs
// or of the answer adds or takes away a touch. The times are those of exact arithmetic, rounded outward.
//
// With a separation above 0 they touch where they come as near as that. Then `tolerance` is a distance: at `upper` they
// are no farther apart than the separation and the tolerance. What is not decided by then counts as a touch.
struct TouchSettings {
  Real separation = 0;
  Real tolerance = 1e-9;
};

[[nodiscard]] MovingTouch first_touch_of_vertex_and_face(const MovingPoint& vertex,
                                                         const std::array<MovingPoint, 3>& face,
                                                         const TouchSettings& settings);
[[nodiscard]] MovingTouch first_touch_of_edges(const std::array<MovingPoint, 2>& a, const std::array<MovingPoint, 2>& b,
                                               const TouchSettings& settings);

}  // namespace abut
