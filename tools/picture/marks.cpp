// SPDX-License-Identifier: Apache-2.0
#include "marks.hpp"

#include <cmath>

namespace tools {

std::optional<Pixel> project(const abut_camera& camera, const Vec3& point) {
  const Vec3 offset = point - camera.pose.position;
  const Vec3 local = rotate(conjugate(camera.pose.orientation), offset);
  if (local.z >= 0.0) {
    return std::nullopt;
  }
  const double focal = 0.5 * camera.height / std::tan(0.5 * camera.vertical_fov);
  const Pixel pixel{0.5 * camera.width - focal * local.x / local.z, 0.5 * camera.height + focal * local.y / local.z,
                    length(offset)};
  const bool inside = pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < camera.width && pixel.y < camera.height;
  return inside ? std::optional(pixel) : std::nullopt;
}

void draw_mark(Image& image, const Pixel& pixel, double radius, double scale) {
  image.draw_disc(pixel.x, pixel.y, radius + 0.9 * scale, {0.0, 0.0, 0.0}, 0.75);
  image.draw_disc(pixel.x, pixel.y, radius, mark_colour, 1.0);
}

void draw_faint_mark(Image& image, const Pixel& pixel, double radius) {
  image.draw_disc(pixel.x, pixel.y, 0.8 * radius, mark_colour, 0.45);
}

}  // namespace tools
