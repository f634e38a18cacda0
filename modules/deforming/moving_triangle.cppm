// SPDX-License-Identifier: Apache-2.0
// Whether a triangle whose corners move on straight lines comes to hold the origin, or near it: in double precision,
// with bounds of what rounding does.
export module abut.deforming.moving_triangle;
import abut.core.standard;
import abut.math;
import abut.deforming;

export namespace abut {

// The difference a - b, which rounding has not touched yet.
struct MovingDifference {
  MovingPoint a, b;
};

struct MovingTriangle {
  std::array<Vec3, 3> start, end;
};
[[nodiscard]] inline MovingTriangle rounded(const std::array<MovingDifference, 3>& corners) {
  MovingTriangle triangle;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    triangle.start[i] = corners[i].a.start - corners[i].b.start;
    triangle.end[i] = corners[i].a.end - corners[i].b.end;
  }
  return triangle;
}

[[nodiscard]] inline Real largest_coordinate_of(const MovingTriangle& triangle) {
  Real largest = 0;
  for (const auto& corners : {triangle.start, triangle.end}) {
    for (const Vec3& corner : corners) {
      largest = std::max(largest, largest_magnitude(corner));
    }
  }
  return largest;
}

// The first time at which the triangle holds the origin. Nothing where rounding might tell another answer.
[[nodiscard]] std::optional<MovingTouch> quick_touch(const MovingTriangle& triangle);

// The first time at which the triangle is as near to the origin as the separation.
[[nodiscard]] MovingTouch first_approach(const MovingTriangle& triangle, const TouchSettings& settings);

}  // namespace abut
