// SPDX-License-Identifier: Apache-2.0
// Along a direction, each corner moves at a constant speed. So what all corners are beyond at both ends of a stretch of
// time, they are beyond all the time.
module abut.deforming.moving_triangle;
import abut.capability;
import abut.core.standard;
import abut.math.tolerance;
import abut.math;
import abut.narrow.triangle.triangle_point;
import abut.deforming;

namespace abut {
namespace {

// What slides by at nearly the separation is halved often. Then the answer is as wide as what is left.
constexpr int most_stretches = 16384;

// The ends of the answer come as near to each other.
constexpr int most_halvings = 40;
constexpr Real wanted_width = 1.0 / (std::uint64_t{1} << most_halvings);

TriangleCorners corners_at(const MovingTriangle& triangle, Real time) {
  TriangleCorners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = (1 - time) * triangle.start[i] + time * triangle.end[i];
  }
  return corners;
}

struct Stretch {
  Real low, high;
};

}  // namespace

// Stretches come in the order of time, so that the first one which is small and not ruled out is the answer.
MovingTouch first_approach(const MovingTriangle& triangle, const TouchSettings& settings) {
  const Real rounding = rounding_of(largest_coordinate_of(triangle));
  const auto nearest_at = [&](Real time) { return nearest_on(corners_at(triangle, time), {0, 0, 0}); };
  if (norm(nearest_at(0)) <= settings.separation) {
    return {true, 0, 0};
  }
  std::array<Stretch, most_halvings + 2> waiting;
  waiting[0] = {0, 1};
  std::size_t count = 1;
  for (int stretches = 0; count > 0; ++stretches) {
    const Stretch at = waiting[--count];
    const Real middle = 0.5 * (at.low + at.high);
    const Vec3 nearest = nearest_at(middle);
    if (const auto direction = UnitVec3::make(nearest)) {
      const Real at_low = least_along(corners_at(triangle, at.low), *direction),
                 at_high = least_along(corners_at(triangle, at.high), *direction);
      if (std::min(at_low, at_high) > settings.separation + rounding) {
        continue;
      }
    }
    if (at.high - at.low <= wanted_width || stretches == most_stretches) {
      const bool is_near = norm(nearest) <= settings.separation + settings.tolerance;
      return {true, at.low, is_near ? middle : stretches == most_stretches ? 1 : at.high};
    }
    waiting[count++] = {middle, at.high};
    waiting[count++] = {at.low, middle};
  }
  return {};
}

}  // namespace abut
