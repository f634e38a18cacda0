// SPDX-License-Identifier: Apache-2.0
// Shapes of the library, each with the same shape for the oracle.
#pragma once

#include <abut/abut.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "oracle/distance.hpp"

namespace property {

struct ReleaseShape {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using ShapePtr = std::unique_ptr<abut_shape, ReleaseShape>;

struct Subject {
  std::string kind;  // "sphere", "box", ...
  std::string name;  // of this one
  ShapePtr shape;
  ShapePtr doubled;  // scaled by 2
  oracle::Measured measured;
  double size = 0;   // farthest extent from the local origin; the offset of a plane
  double small = 0;  // a length to choose gaps by: the smallest of the sizes that are not zero
};

[[nodiscard]] Subject make_sphere(const std::string& name, double radius);
[[nodiscard]] Subject make_box(const std::string& name, double x, double y, double z);
[[nodiscard]] Subject make_capsule(const std::string& name, double radius, double half_height);
[[nodiscard]] Subject make_plane(const std::string& name, const oracle::Point& normal, double offset);
[[nodiscard]] Subject make_hull(const std::string& name, const std::vector<oracle::Point>& points);
[[nodiscard]] Subject make_mesh(const std::string& name, const oracle::Soup& soup);

struct Grid {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  double spacing_x = 1;
  double spacing_y = 1;
  std::vector<double> heights;
};
[[nodiscard]] Subject make_height_field(const std::string& name, const Grid& grid);

// A pose of the library as the oracle reads it.
[[nodiscard]] oracle::Pose pose_of(const abut_pose& pose);
[[nodiscard]] oracle::Vec vec_of(const abut_vec3& v);

// Numbers in hexadecimal, to repeat a case exactly.
[[nodiscard]] std::string text_of(const abut_pose& pose);
[[nodiscard]] std::string text_of(const abut_vec3& v);

}  // namespace property
