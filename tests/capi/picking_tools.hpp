// SPDX-License-Identifier: Apache-2.0
// Geometry of pictures for the tests of tools, written from the definition of abut_camera alone.
#pragma once

#include "picking_scene.hpp"

#include <array>
#include <optional>
#include <vector>

namespace picking_test {

inline abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline abut_vec3 turned(const abut_quat& q, const abut_vec3& v) {
  const abut_vec3 u{q.x, q.y, q.z};
  return v + 2 * cross(u, cross(u, v) + q.w * v);
}

inline abut_vec3 moved(const abut_pose& pose, const abut_vec3& v) {
  return pose.position + turned(pose.orientation, v);
}

// Directions of a camera, and pixels for a slope of 1 or a length of 1.
struct Axes {
  abut_vec3 eye, right, up, forward;
  double focal_x, focal_y, centre_x, centre_y;
  bool is_parallel;
};

inline Axes axes_of(const abut_camera& camera) {
  const abut_quat& q = camera.pose.orientation;
  const bool is_parallel = camera.projection == ABUT_PROJECTION_ORTHOGRAPHIC;
  const double focal =
      is_parallel ? camera.height / camera.vertical_extent : 0.5 * camera.height / std::tan(0.5 * camera.vertical_fov);
  return {camera.pose.position,
          turned(q, {1, 0, 0}),
          turned(q, {0, 1, 0}),
          turned(q, {0, 0, -1}),
          focal / camera.pixel_aspect,
          focal,
          0.5 * camera.width + camera.shift_x,
          0.5 * camera.height + camera.shift_y,
          is_parallel};
}

// x and y in pixels, and the depth along the axis.
inline abut_vec3 pictured(const Axes& axes, const abut_vec3& point) {
  const abut_vec3 from_eye = point - axes.eye;
  const double depth = dot(from_eye, axes.forward);
  const double shrink = axes.is_parallel ? 1 : 1 / depth;
  return {axes.centre_x + axes.focal_x * shrink * dot(from_eye, axes.right),
          axes.centre_y - axes.focal_y * shrink * dot(from_eye, axes.up), depth};
}

// Looks at about the origin, from outside of most.
inline abut_camera some_camera(Random& random) {
  abut_camera camera;
  abut_camera_init(&camera, sizeof camera);
  camera.depth_axis = ABUT_DEPTH_ALONG_AXIS;
  camera.projection = random.one_in(2) ? ABUT_PROJECTION_ORTHOGRAPHIC : ABUT_PROJECTION_PERSPECTIVE;
  camera.vertical_extent = random.in(4, 20);
  if (random.one_in(2)) camera.pixel_aspect = random.in(0.5, 2);
  if (random.one_in(2)) camera.shift_x = random.in(-100, 100);
  if (random.one_in(2)) camera.shift_y = random.in(-100, 100);
  if (random.one_in(2)) camera.near_distance = random.in(1, 10);
  if (random.one_in(2)) camera.far_distance = random.in(12, 20);
  const abut_vec3 eye = 14 * (1 / std::sqrt(3)) * random.point(1);
  const abut_vec3 target = random.point(3);
  const abut_vec3 up{0.1, 0, 1};
  EXPECT_EQ(abut_camera_look_at(&camera, &eye, &target, &up), ABUT_OK) << abut_last_error_message();
  return camera;
}

// The point on three planes; none where they are nearly parallel.
inline std::optional<abut_vec3> corner_of(const abut_vec3& a, double of_a, const abut_vec3& b, double of_b,
                                          const abut_vec3& c, double of_c) {
  const double volume = dot(a, cross(b, c));
  if (std::fabs(volume) < 1e-9) return std::nullopt;
  return (1 / volume) * (of_a * cross(b, c) + of_b * cross(c, a) + of_c * cross(a, b));
}

struct Surface {
  std::vector<abut_vec3> vertices;
  std::vector<std::array<std::size_t, 3>> triangles;
};

inline Surface surface_of(const Shape& shape) {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  EXPECT_EQ(abut_shape_triangles(shape.get(), nullptr, 0, &vertices, nullptr, 0, &triangles), ABUT_OK);
  std::vector<double> xyz(3 * vertices);
  std::vector<std::uint32_t> indices(3 * triangles);
  EXPECT_EQ(abut_shape_triangles(shape.get(), xyz.data(), vertices, &vertices, indices.data(), triangles, &triangles),
            ABUT_OK);
  Surface out;
  for (std::size_t i = 0; i < vertices; ++i) out.vertices.push_back({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
  for (std::size_t i = 0; i < triangles; ++i)
    out.triangles.push_back({indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]});
  return out;
}

inline std::vector<abut_geometry_id> selected_by(World& world, const abut_camera& camera,
                                                 const std::array<double, 4>& corners, abut_selection selection,
                                                 const abut_query_filter* filter = nullptr) {
  std::size_t count = 0;
  const auto select = [&](abut_geometry_id* out, std::size_t capacity) {
    EXPECT_EQ(abut_picker_select_rectangle(world.picker(), &camera, corners[0], corners[1], corners[2], corners[3],
                                           selection, filter, out, capacity, &count),
              ABUT_OK)
        << abut_last_error_message();
  };
  select(nullptr, 0);
  std::vector<abut_geometry_id> out(count);
  select(out.data(), out.size());
  EXPECT_EQ(count, out.size());
  return out;
}

}  // namespace picking_test
