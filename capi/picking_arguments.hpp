// Checks of what callers hand to picking.h. Each writes this thread's message and answers the
// status; ABUT_OK when there is nothing to object to.
#ifndef ABUT_CAPI_PICKING_ARGUMENTS_HPP
#define ABUT_CAPI_PICKING_ARGUMENTS_HPP

#include <abut/picking.h>

#include <cmath>
#include <cstddef>
#include <span>

namespace abut::capi {

/// Refuses: "<argument> is <value>; <expectation>".
[[nodiscard]] abut_status refuse(abut_status status, const char* argument, double value,
                                 const char* expectation) noexcept;
[[nodiscard]] abut_status refuse(abut_status status, const char* message) noexcept;
[[nodiscard]] abut_status refuse_null(const char* argument) noexcept;

[[nodiscard]] abut_status check_finite(const abut_vec3& vector, const char* argument) noexcept;
/// A camera of a later version is accepted when what this version does not know is zero.
[[nodiscard]] abut_status check_size(const abut_camera& camera) noexcept;
[[nodiscard]] abut_status check_camera(const abut_camera& camera) noexcept;

/// Why a ray is refused, in full; ABUT_OK for a ray that is good.
[[nodiscard]] abut_status explain_ray(const abut_ray& ray) noexcept;

/// Whether a ray can be traced: all finite but the limit, a direction, a limit that is not negative.
[[nodiscard]] inline bool is_good(const abut_ray& ray) noexcept {
  // x - x is 0 for a finite x and NaN for any other.
  const double finite = (ray.origin.x - ray.origin.x) + (ray.origin.y - ray.origin.y) + (ray.origin.z - ray.origin.z) +
                        (ray.direction.x - ray.direction.x) + (ray.direction.y - ray.direction.y) +
                        (ray.direction.z - ray.direction.z);
  const double size = std::fabs(ray.direction.x) + std::fabs(ray.direction.y) + std::fabs(ray.direction.z);
  return finite == 0 && size > 0 && ray.max_distance >= 0;
}

/// Checks all rays before any is traced; the message names the first bad one.
[[nodiscard]] abut_status check_rays(std::span<const abut_ray> rays) noexcept;

}  // namespace abut::capi

#endif
