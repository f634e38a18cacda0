// SPDX-License-Identifier: Apache-2.0
// A vertex touches a face when the triangle of the differences (vertex - corner) holds the origin. Two edges touch when
// the parallelogram of the differences of their ends does, and that is two triangles.
module abut.deforming;
import abut.core.standard;
import abut.math;
import abut.deforming.exact_touch;
import abut.deforming.moving_triangle;

namespace abut {
namespace {

MovingTouch first_touch(const std::array<MovingDifference, 3>& corners, const TouchSettings& settings) {
  const MovingTriangle triangle = rounded(corners);
  if (settings.separation > 0) {
    return first_approach(triangle, settings);
  }
  // Where a touch is nearly missed, rounding leaves its time open.
  constexpr Real widest = 1e-9;
  const std::optional<MovingTouch> quick = quick_touch(triangle);
  return quick && quick->upper - quick->lower <= widest ? *quick : exact_touch(corners);
}

MovingTouch first_of(const MovingTouch& a, const MovingTouch& b) {
  if (!a.touches || !b.touches) {
    return a.touches ? a : b;
  }
  return {true, std::min(a.lower, b.lower), std::min(a.upper, b.upper)};
}

}  // namespace

bool has_deforming() { return true; }

MovingTouch first_touch_of_vertex_and_face(const MovingPoint& vertex, const std::array<MovingPoint, 3>& face,
                                          const TouchSettings& settings) {
  return first_touch({{{vertex, face[0]}, {vertex, face[1]}, {vertex, face[2]}}}, settings);
}

MovingTouch first_touch_of_edges(const std::array<MovingPoint, 2>& a, const std::array<MovingPoint, 2>& b,
                                const TouchSettings& settings) {
  const MovingDifference first{a[0], b[0]}, last{a[1], b[1]};
  return first_of(first_touch({{first, {a[0], b[1]}, last}}, settings),
                  first_touch({{first, {a[1], b[0]}, last}}, settings));
}

}  // namespace abut
