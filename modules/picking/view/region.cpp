// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

module abut.picking;
import :camera;
import :region;
import :vector;

namespace abut::picking {

namespace {

// A corner of three planes counts when it lies outside of another one by at most this part of its distance: a rectangle
// without width has sides in one plane.
constexpr double least_gap = 1e-11;
// Three unit normals that span less than this have no corner.
constexpr double least_volume = 1e-14;

// Pixels further away are as far as that: what is seen there is at a right angle to the axis.
constexpr double farthest_pixel = 1e100;

// A plane through the eye, or parallel to the axis: `across` points into the region, and the side is seen `pixels`
// from the axis in this direction.
[[nodiscard]] HalfSpace side_of(const View& view, const abut_vec3& across, double pixels) {
  if (view.is_parallel) return {across, dot(across, view.eye) + pixels / view.focal};
  const abut_vec3 slope = tamed({view.focal, pixels, 0});
  const abut_vec3 normal = normalized(subtract(scale(across, slope.x), scale(view.forward, slope.y)));
  return {normal, dot(normal, view.eye)};
}

[[nodiscard]] std::optional<abut_vec3> common_point(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) {
  const abut_vec3 across = cross(b.normal, c.normal);
  const double volume = dot(a.normal, across);
  if (!(std::fabs(volume) > least_volume)) return std::nullopt;
  const abut_vec3 sum = add(add(scale(across, a.offset), scale(cross(c.normal, a.normal), b.offset)),
                            scale(cross(a.normal, b.normal), c.offset));
  return scale(sum, 1 / volume);
}

}  // namespace

std::vector<HalfSpace> region_of(const View& view, const Rectangle& rectangle, std::span<const HalfSpace> further) {
  const auto bounded = [](double pixel) { return std::clamp(pixel, -farthest_pixel, farthest_pixel); };
  const double left = bounded(std::min(rectangle.x0, rectangle.x1));
  const double right = bounded(std::max(rectangle.x0, rectangle.x1));
  const double top = bounded(std::min(rectangle.y0, rectangle.y1));
  const double bottom = bounded(std::max(rectangle.y0, rectangle.y1));
  const double depth_of_eye = dot(view.forward, view.eye);
  std::vector<HalfSpace> planes{
      side_of(view, view.right, view.aspect * (left - view.centre_x)),
      side_of(view, scale(view.right, -1), -view.aspect * (right - view.centre_x)),
      side_of(view, scale(view.up, -1), -(view.centre_y - top)),
      side_of(view, view.up, view.centre_y - bottom),
      {view.forward, depth_of_eye + view.start},
  };
  if (std::isfinite(view.limit)) planes.push_back({scale(view.forward, -1), -(depth_of_eye + view.start + view.limit)});
  planes.insert(planes.end(), further.begin(), further.end());
  return planes;
}

std::vector<double> corners_of(std::span<const HalfSpace> planes, const abut_vec3& around) {
  // Relative to that point, which costs no digits far from zero.
  std::vector<HalfSpace> near(planes.begin(), planes.end());
  for (HalfSpace& plane : near) plane.offset -= dot(plane.normal, around);
  std::vector<double> out;
  for (std::size_t i = 0; i < near.size(); ++i) {
    for (std::size_t j = i + 1; j < near.size(); ++j) {
      for (std::size_t k = j + 1; k < near.size(); ++k) {
        const std::optional<abut_vec3> corner = common_point(near[i], near[j], near[k]);
        if (!corner) continue;
        const double gap = least_gap * largest_component(*corner);
        const auto holds = [&](const HalfSpace& plane) { return height_above(plane, *corner) >= -gap; };
        if (std::ranges::all_of(near, holds)) {
          const abut_vec3 point = add(*corner, around);
          out.insert(out.end(), {point.x, point.y, point.z});
        }
      }
    }
  }
  return out;
}

}  // namespace abut::picking
