// SPDX-License-Identifier: Apache-2.0
// Solid shapes of the library, and questions to them.
#pragma once

#include <abut/abut.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "../unit/damaged_meshes.hpp"
#include "oracle/winding.hpp"

namespace solid {

struct Release {
  void operator()(abut_shape* shape) const { abut_shape_release(shape); }
};
using ShapePtr = std::unique_ptr<abut_shape, Release>;

template <class Make>
ShapePtr made(Make&& make) {
  abut_shape* shape = nullptr;
  EXPECT_EQ(make(&shape), ABUT_OK) << abut_last_error_message();
  return ShapePtr(shape);
}
inline ShapePtr sphere(double radius) {
  return made([&](abut_shape** out) { return abut_sphere_create(radius, out); });
}
inline ShapePtr box(double x, double y, double z) {
  return made([&](abut_shape** out) { return abut_box_create(x, y, z, out); });
}
inline ShapePtr mesh(const test::Surface& surface, abut_sides sides = ABUT_SIDES_SOLID) {
  abut_mesh_options options;
  abut_mesh_options_init(&options, sizeof options);
  options.sides = sides;
  return made([&](abut_shape** out) {
    return abut_mesh_create(surface.xyz.data(), surface.xyz.size() / 3, surface.triangles.data(),
                            surface.triangle_count(), &options, out);
  });
}
inline test::Surface box_surface(double x, double y, double z) {
  test::Surface out;
  for (unsigned i = 0; i < 8; ++i) {
    out.xyz.insert(out.xyz.end(), {(i & 1) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 4) != 0 ? z : -z});
  }
  out.triangles = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return out;
}
inline test::Surface scaled(test::Surface surface, double scale) {
  for (double& number : surface.xyz) number *= scale;
  return surface;
}

inline abut_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

inline abut_distance distance(const ShapePtr& a, const ShapePtr& b, const abut_pose& pose_b) {
  const abut_pose here = at(0, 0, 0);
  abut_distance out{};
  EXPECT_EQ(abut_pair_distance(a.get(), &here, b.get(), &pose_b, nullptr, &out), ABUT_OK) << abut_last_error_message();
  const abut_vec3 between{out.point_b.x - out.point_a.x, out.point_b.y - out.point_a.y, out.point_b.z - out.point_a.z};
  const double along = between.x * out.normal.x + between.y * out.normal.y + between.z * out.normal.z;
  EXPECT_NEAR(along, out.distance, 1e-9 * (1 + std::abs(out.distance)));
  EXPECT_LE(out.lower, out.distance);
  EXPECT_GE(out.upper, out.distance);
  return out;
}

inline std::vector<abut_contact> contacts(const ShapePtr& a, const ShapePtr& b, const abut_pose& pose_b) {
  const abut_pose here = at(0, 0, 0);
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.max_contacts = 0;
  std::vector<abut_contact> out(4000);
  std::size_t count = 0;
  EXPECT_EQ(abut_pair_contacts(a.get(), &here, b.get(), &pose_b, &options, out.data(), out.size(), &count), ABUT_OK);
  out.resize(count);
  return out;
}

inline double number_around(const test::Surface& surface, double x, double y, double z) {
  return static_cast<double>(
      oracle::winding_number(surface.xyz, surface.triangles, {oracle::quad(x), oracle::quad(y), oracle::quad(z)}));
}

// A move of b by the depth along the normal leaves no overlap but what rounding and the bound allow.
inline void expect_parted(const ShapePtr& a, const ShapePtr& b, abut_pose pose_b, const abut_distance& found) {
  const double way = -found.distance * (1 + 1e-9) + 1e-9;
  pose_b.position = {pose_b.position.x + way * found.normal.x, pose_b.position.y + way * found.normal.y,
                     pose_b.position.z + way * found.normal.z};
  EXPECT_GE(distance(a, b, pose_b).distance, -1e-8);
}

inline double least_of(const std::vector<abut_contact>& met) {
  double least = 0;
  for (const abut_contact& contact : met) least = std::min(least, contact.distance);
  return least;
}

}  // namespace solid
