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

// Whether all differences are surely beyond the origin at both times along their mean. On straight lines they are at
// all times then, and so is what they span. Most features that come near each other's boxes never come nearer than
// that.
template <std::size_t Count>
bool are_beyond_origin(const std::array<MovingDifference, Count>& differences) {
  // Of the largest coordinates of both factors: differences and products of coordinates, and sums of three.
  constexpr Real rounding = 32 * epsilon, least_normal = 1e-300;
  std::array<Vec3, 2 * Count> at_both_times;
  Vec3 mean{0, 0, 0};
  Real size = 0;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto& [a, b] = differences[i];
    at_both_times[2 * i] = a.start - b.start;
    at_both_times[2 * i + 1] = a.end - b.end;
    mean += at_both_times[2 * i] + at_both_times[2 * i + 1];
    size = std::max({size, largest_magnitude(at_both_times[2 * i]), largest_magnitude(at_both_times[2 * i + 1])});
  }
  const Real error = rounding * largest_magnitude(mean) * size + least_normal;
  bool all = true;
  for (const Vec3& difference : at_both_times) {
    all &= dot(mean, difference) > error;
  }
  return all;
}

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

MovingTouch first_touch_of_vertex_and_face(const MovingPoint& vertex, const std::array<MovingPoint, 3>& face,
                                           const TouchSettings& settings) {
  const std::array<MovingDifference, 3> corners{{{vertex, face[0]}, {vertex, face[1]}, {vertex, face[2]}}};
  return settings.separation == 0 && are_beyond_origin(corners) ? MovingTouch{} : first_touch(corners, settings);
}

MovingTouch first_touch_of_edges(const std::array<MovingPoint, 2>& a, const std::array<MovingPoint, 2>& b,
                                 const TouchSettings& settings) {
  const MovingDifference first{a[0], b[0]}, last{a[1], b[1]};
  if (settings.separation == 0 && are_beyond_origin<4>({{first, {a[0], b[1]}, {a[1], b[0]}, last}})) {
    return {};
  }
  return first_of(first_touch({{first, {a[0], b[1]}, last}}, settings),
                  first_touch({{first, {a[1], b[0]}, last}}, settings));
}

}  // namespace abut
