// From what Embree found in single precision to hits in double.
module;

#include <abut/picking.h>

#include "embree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

module abut.picking:hit;
import :source;
import :surface;
import :tracer;
import :vector;

namespace abut::picking {

/// Two crossings of neighbouring triangles, in parts of the extent: outlines overlap by twice their
/// growth, which a slope stretches.
inline constexpr double crossing_blur = 0x1p-17;

/// Largest difference between a hit found in single precision and the one on the plane of the
/// triangle, in parts of the extent. Beyond it the ray runs along the plane and single precision
/// knows better.
inline constexpr double largest_correction = 1e-3;

/// A limit that no rounding makes smaller.
[[nodiscard]] inline float widened(double limit) { return static_cast<float>(limit * (1 + 0x1p-22)); }

inline void write_ray(RTCRayHit& hit, const abut_vec3& point, const abut_vec3& direction, double limit) {
  hit.ray.org_x = static_cast<float>(point.x);
  hit.ray.org_y = static_cast<float>(point.y);
  hit.ray.org_z = static_cast<float>(point.z);
  hit.ray.tnear = 0;
  hit.ray.dir_x = static_cast<float>(direction.x);
  hit.ray.dir_y = static_cast<float>(direction.y);
  hit.ray.dir_z = static_cast<float>(direction.z);
  hit.ray.time = 0;
  hit.ray.tfar = widened(limit);
  hit.ray.mask = ~0U;
  hit.ray.id = 0;
  hit.ray.flags = 0;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

/// Distance along a ray to a plane near which a hit was found.
[[nodiscard]] inline double distance_to(const Plane& plane, const abut_vec3& origin, const abut_vec3& direction, double found,
                                        double extent) {
  const double exact = (plane.offset - dot(plane.normal, origin)) / dot(plane.normal, direction);
  const bool is_close = std::fabs(exact - found) <= largest_correction * extent;
  return std::max(is_close ? exact : found, 0.0);
}

/// Distance at which a line crosses a triangle, its edges included; none when they are parallel.
[[nodiscard]] std::optional<double> crossing_of_triangle(const TriangleList& list, const std::array<std::uint32_t, 3>& corners,
                                                         const abut_vec3& origin, const abut_vec3& direction);
[[nodiscard]] abut_vec3 normal_of_triangle(const TriangleList& list, const std::array<std::uint32_t, 3>& corners);

/// Sorts crossings by distance and reports those of neighbouring triangles at their edge once.
void merge_crossings(std::vector<AllHits::Crossing>& crossings, const abut_vec3& direction, std::vector<abut_pick>& out);

}  // namespace abut::picking
