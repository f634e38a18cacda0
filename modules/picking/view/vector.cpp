// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

module abut.picking;
import :vector;

namespace abut::picking {

std::optional<Entrance> enter_from_afar(const Space& space, const abut_vec3& origin, const abut_vec3& direction,
                                        double limit) {
  // A little more than the cube, so that nothing on its faces is passed by.
  const double side = 1.01 * space.extent;
  const abut_vec3 start = subtract(origin, space.origin);
  const std::array<double, 3> point{start.x, start.y, start.z};
  const std::array<double, 3> along{direction.x, direction.y, direction.z};
  double first = 0;
  double last = limit;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0) {
      if (std::fabs(point[axis]) > side) return std::nullopt;
      continue;
    }
    // Divided, not multiplied by the inverse, which may be infinite.
    const double a = (-side - point[axis]) / along[axis];
    const double b = (side - point[axis]) / along[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first <= last) || std::isinf(first)) return std::nullopt;
  // Onto the cube: from very far away rounding alone is larger than it.
  const abut_vec3 entered = add(start, scale(direction, first));
  const auto onto = [side](double coordinate) { return std::clamp(coordinate, -side, side); };
  return Entrance{{onto(entered.x), onto(entered.y), onto(entered.z)}, first};
}

}  // namespace abut::picking
