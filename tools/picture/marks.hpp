// SPDX-License-Identifier: Apache-2.0
// Points of the world as dots on a picture.
#pragma once

#include <optional>

#include "abut/picking.h"
#include "common/vector.hpp"
#include "image.hpp"

namespace tools {

/// Where a point of the world is in a picture.
struct Pixel {
  double x;
  double y;
  double distance;  // from the camera
};

/// The inverse of abut_camera_ray; none outside of the picture.
[[nodiscard]] std::optional<Pixel> project(const abut_camera& camera, const Vec3& point);

/// The colour of contacts.
inline constexpr Colour mark_colour{1.0, 0.92, 0.05};

/// A dot; `scale` is that of its outline, in pixels.
void draw_mark(Image& image, const Pixel& pixel, double radius, double scale);

/// A dot of something that is behind what is seen.
void draw_faint_mark(Image& image, const Pixel& pixel, double radius);

}  // namespace tools
