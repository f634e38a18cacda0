// Checks of what callers hand to picking.h. Each writes this thread's message and answers the
// status; ABUT_OK when there is nothing to object to.
#ifndef ABUT_CAPI_PICKING_ARGUMENTS_HPP
#define ABUT_CAPI_PICKING_ARGUMENTS_HPP

#include <abut/picking.h>

#include <cstddef>
#include <cstdint>
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
/// In two registers, since the check stands before each single ray.
[[nodiscard]] inline bool is_good(const abut_ray& ray) noexcept {
  using Four = double __attribute__((ext_vector_type(4)));
  using Flags = std::int64_t __attribute__((ext_vector_type(4)));
  constexpr Four zero = {0, 0, 0, 0};
  constexpr Flags of_direction = {-1, -1, -1, 0};
  const Four from{ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x};
  const Four along{ray.direction.x, ray.direction.y, ray.direction.z, ray.max_distance};
  // x - x is 0 for a finite x and NaN for any other.
  const Flags is_finite = (from - from == zero) & ((along - along == zero) | ~of_direction);
  return __builtin_reduce_and(is_finite) != 0 && __builtin_reduce_or((along != zero) & of_direction) != 0 &&
         ray.max_distance >= 0;
}

/// Checks all rays before any is traced; the message names the first bad one.
[[nodiscard]] abut_status check_rays(std::span<const abut_ray> rays) noexcept;

}  // namespace abut::capi

#endif
