// SPDX-License-Identifier: Apache-2.0
// What rays do not see: what clip planes cut away, and surfaces from behind.
module;

#include <abut/picking.h>

#include "core/check.hpp"
#include "picking/embree.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

module abut.picking;
import :crossing;
import :entry;
import :region;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

// Shortens a ray to what the clip planes keep of it. `skipped` is how much later it starts. False when nothing is left.
bool Tracer::trim(abut_ray& ray, double& skipped) const {
  if (clip_planes_.empty()) [[likely]]
    return true;
  double first = 0;
  double last = ray.max_distance;
  for (const HalfSpace& plane : clip_planes_) {
    const double height = height_above(plane, ray.origin);
    const double rise = dot(plane.normal, ray.direction);
    if (rise == 0 && height < 0) return false;
    if (rise > 0) first = std::max(first, -height / rise);
    if (rise < 0) last = std::min(last, -height / rise);
  }
  if (!(first <= last && first < infinity)) return false;
  skipped = first;
  ray = {add(ray.origin, scale(ray.direction, first)), ray.direction, last - first};
  return true;
}

bool Tracer::is_kept(const abut_vec3& point) const {
  return std::ranges::all_of(clip_planes_, [&](const HalfSpace& plane) { return height_above(plane, point) >= 0; });
}

// Whether a hit on a still surface does not count, since it is seen from behind.
bool Tracer::is_behind(const Baked& baked, const RTCFilterFunctionNArguments& arguments, unsigned ray) const {
  if (!skips_back_faces_) return false;
  const unsigned count = arguments.N;
  const std::uint32_t triangle =
      triangle_of(baked, RTCHitN_primID(arguments.hit, count, ray), RTCHitN_u(arguments.hit, count, ray),
                  RTCHitN_v(arguments.hit, count, ray));
  const abut_vec3 direction{static_cast<double>(RTCRayN_dir_x(arguments.ray, count, ray)),
                            static_cast<double>(RTCRayN_dir_y(arguments.ray, count, ray)),
                            static_cast<double>(RTCRayN_dir_z(arguments.ray, count, ray))};
  return dot(plane_of(baked, triangle).normal, direction) > 0;
}

// First crossing in double that counts.
std::optional<abut_ray_hit> Tracer::cast_seen(const Entry& entry, const abut_ray& ray) const {
  const PickableShape& access = *shapes_[entry.shape].access;
  if (!skips_back_faces_) return access.cast(entry.pose, ray);
  std::optional<abut_ray_hit> found;
  visit_crossings(access, entry.pose, ray, [&](const abut_ray_hit& hit) {
    const bool is_front = dot(hit.normal, ray.direction) <= 0;
    if (is_front) found = hit;
    return !is_front;
  });
  return found;
}

}  // namespace abut::picking
