// SPDX-License-Identifier: Apache-2.0
// Builds without the feature `deforming`: nobody asks, since the C interface asks first.
module abut.deforming;
import abut.core.standard;

namespace abut {

bool has_deforming() { return false; }

MovingTouch first_touch_of_vertex_and_face(const MovingPoint& /*vertex*/, const std::array<MovingPoint, 3>& /*face*/,
                                          const TouchSettings& /*settings*/) {
  return {};
}
MovingTouch first_touch_of_edges(const std::array<MovingPoint, 2>& /*a*/, const std::array<MovingPoint, 2>& /*b*/,
                                const TouchSettings& /*settings*/) {
  return {};
}

}  // namespace abut
