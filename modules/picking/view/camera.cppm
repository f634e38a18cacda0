// SPDX-License-Identifier: Apache-2.0
// A camera: from points of the picture to rays.
module;

#include <abut/picking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

export module abut.picking:camera;
import :vector;

namespace abut::picking {

// Directions of a camera in the world, and pixels: `focal` of them are as high as the slope 1 of a perspective camera,
// or the length 1 of an orthographic one.
struct View {
  abut_vec3 eye;
  abut_vec3 right;
  abut_vec3 up;
  abut_vec3 forward;
  double focal;
  double aspect;  // width of a pixel divided by its height
  double centre_x;
  double centre_y;
  double start;
  double limit;
  bool is_parallel;  // orthographic
  bool has_planes;   // near and far are measured along the axis
};

[[nodiscard]] inline View view_of(const abut_camera& camera) {
  const Frame frame = frame_of(camera.pose);
  const bool is_parallel = camera.projection == ABUT_PROJECTION_ORTHOGRAPHIC;
  const double half_height = 0.5 * static_cast<double>(camera.height);
  const double slope = is_parallel ? 0.5 * camera.vertical_extent : std::tan(0.5 * camera.vertical_fov);
  constexpr double longest = std::numeric_limits<double>::max();
  return {.eye = camera.pose.position,
          .right = rotate(frame, {1, 0, 0}),
          .up = rotate(frame, {0, 1, 0}),
          .forward = rotate(frame, {0, 0, -1}),
          .focal = slope > 0 ? std::min(half_height / slope, longest) : longest,
          .aspect = camera.pixel_aspect,
          .centre_x = 0.5 * static_cast<double>(camera.width) + camera.shift_x,
          .centre_y = half_height + camera.shift_y,
          .start = camera.near_distance,
          .limit = camera.far_distance - camera.near_distance,
          .is_parallel = is_parallel,
          .has_planes = camera.depth_axis == ABUT_DEPTH_ALONG_AXIS};
}

// A point of a picture, and how many pixels around it count.
struct Aim {
  View view;
  double x;
  double y;
  double radius;
};

// Unit direction through a point of the picture. In pixels and then tamed: a quotient may overflow.
[[nodiscard]] inline abut_vec3 direction_through(const View& view, double x, double y) {
  if (view.is_parallel) return view.forward;
  const abut_vec3 seen = tamed({view.aspect * (x - view.centre_x), view.centre_y - y, view.focal});
  return normalized(add(add(scale(view.right, seen.x), scale(view.up, seen.y)), scale(view.forward, seen.z)));
}

// How much longer the way along a ray is than what near and far are measured along.
[[nodiscard]] inline double stretch_of(const View& view, const abut_vec3& direction) {
  constexpr double least_cosine = 1e-60;
  if (!view.has_planes || view.is_parallel) return 1;
  return 1 / std::max(dot(direction, view.forward), least_cosine);
}

// Rays start no further away: their squares and cubes would overflow.
inline constexpr double farthest_start = 1e70;

// Where the ray through a point of the picture crosses the plane of the eye.
[[nodiscard]] inline abut_vec3 eye_of(const View& view, double x, double y) {
  if (!view.is_parallel) return view.eye;
  const auto bounded = [](double length) { return std::clamp(length, -farthest_start, farthest_start); };
  return add(view.eye, add(scale(view.right, bounded(view.aspect * (x - view.centre_x) / view.focal)),
                           scale(view.up, bounded((view.centre_y - y) / view.focal))));
}

[[nodiscard]] inline abut_ray ray_through(const View& view, double x, double y) {
  const abut_vec3 direction = direction_through(view, x, y);
  const double stretch = stretch_of(view, direction);
  const double start = std::min(stretch * view.start, farthest_start);
  return {add(eye_of(view, x, y), scale(direction, start)), direction, stretch * view.limit};
}

}  // namespace abut::picking

export namespace abut::picking {

// Ray through a point of the picture; x to the right, y down, in pixels.
[[nodiscard]] inline abut_ray camera_ray(const abut_camera& camera, double x, double y) {
  return ray_through(view_of(camera), x, y);
}

// Orientation of a camera that looks along `forward` with `up` upwards; both have any length but
// zero and are not parallel.
[[nodiscard]] abut_quat look_along(const abut_vec3& forward, const abut_vec3& up);

// Whether two vectors are parallel, or one is zero, up to rounding.
[[nodiscard]] bool are_parallel(const abut_vec3& a, const abut_vec3& b);

}  // namespace abut::picking
