// SPDX-License-Identifier: Apache-2.0
// Convex regions of space between planes, such as what a rectangle of a picture shows.
module;

#include <abut/abut.h>

#include <span>
#include <vector>

export module abut.picking:region;
import :camera;
import :vector;

export namespace abut::picking {

// Points p with dot(normal, p) >= offset; the normal has unit length.
struct HalfSpace {
  abut_vec3 normal;
  double offset;
};

// Two opposite corners, in pixels.
struct Rectangle {
  double x0, y0, x1, y1;
};

}  // namespace abut::picking

namespace abut::picking {

[[nodiscard]] inline double height_above(const HalfSpace& plane, const abut_vec3& point) {
  return dot(plane.normal, point) - plane.offset;
}

// The half-spaces whose common points a rectangle shows between near and far, followed by `further` ones.
[[nodiscard]] std::vector<HalfSpace> region_of(const View& view, const Rectangle& rectangle,
                                               std::span<const HalfSpace> further);

// Corners of the region between planes, three numbers each; it has to be bounded, around a point that is not far off.
// None where it is empty.
[[nodiscard]] std::vector<double> corners_of(std::span<const HalfSpace> planes, const abut_vec3& around);

}  // namespace abut::picking
