// SPDX-License-Identifier: Apache-2.0
// A pinhole camera: from points of the picture to rays.
module;

#include <abut/picking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

export module abut.picking:camera;
import :vector;

namespace abut::picking {

// Directions of a camera in the world, and its focal length in pixels.
struct View {
  abut_vec3 eye;
  abut_vec3 right;
  abut_vec3 up;
  abut_vec3 forward;
  double focal;
  double centre_x;
  double centre_y;
  double start;
  double limit;
};

[[nodiscard]] inline View view_of(const abut_camera& camera) {
  const Frame frame = frame_of(camera.pose);
  const double half_height = 0.5 * static_cast<double>(camera.height), slope = std::tan(0.5 * camera.vertical_fov);
  constexpr double longest = std::numeric_limits<double>::max();
  return {.eye = camera.pose.position,
          .right = rotate(frame, {1, 0, 0}),
          .up = rotate(frame, {0, 1, 0}),
          .forward = rotate(frame, {0, 0, -1}),
          .focal = slope > 0 ? std::min(half_height / slope, longest) : longest,
          .centre_x = 0.5 * static_cast<double>(camera.width),
          .centre_y = half_height,
          .start = camera.near_distance,
          .limit = camera.far_distance - camera.near_distance};
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
  const abut_vec3 seen = tamed({x - view.centre_x, view.centre_y - y, view.focal});
  return normalized(add(add(scale(view.right, seen.x), scale(view.up, seen.y)), scale(view.forward, seen.z)));
}

[[nodiscard]] inline abut_ray ray_through(const View& view, double x, double y) {
  const abut_vec3 direction = direction_through(view, x, y);
  return {add(view.eye, scale(direction, view.start)), direction, view.limit};
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
