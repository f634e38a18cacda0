// SPDX-License-Identifier: Apache-2.0
// Checks of what callers hand to picking.h. Each writes this thread's message and answers the
// status; ABUT_OK when there is nothing to object to.
#ifndef ABUT_CAPI_PICKING_ARGUMENTS_HPP
#define ABUT_CAPI_PICKING_ARGUMENTS_HPP

#include <abut/picking.h>

#include "extension_arguments.hpp"

#include <cstddef>
#include <span>

namespace abut::capi {

[[nodiscard]] abut_status check_finite(const abut_vec3& vector, const char* argument) noexcept;
/// Coordinates are finite and within what abut.h accepts.
[[nodiscard]] abut_status check_position(const abut_vec3& vector, const char* argument) noexcept;
/// A camera of a later version is accepted when what this version does not know is zero.
[[nodiscard]] abut_status check_size(const abut_camera& camera) noexcept;
[[nodiscard]] abut_status check_camera(const abut_camera& camera) noexcept;
/// A coordinate in a picture, or a radius there.
[[nodiscard]] abut_status check_pixel(double pixels, const char* argument) noexcept;
[[nodiscard]] abut_status check_clip_planes(std::span<const abut_clip_plane> planes) noexcept;

/// A filter of rays of a universe, which may be null. On success `out` is null when it leaves nothing out.
[[nodiscard]] abut_status read_filter(const abut_universe* universe, const abut_query_filter* filter,
                                      const abut_query_filter*& out) noexcept;

/// A ray is all finite but its limit, has a direction, and a limit that is not negative.
[[nodiscard]] abut_status check_ray(const abut_ray& ray) noexcept;
/// Checks all rays before any is traced; the message names the first bad one.
[[nodiscard]] abut_status check_rays(std::span<const abut_ray> rays) noexcept;

}  // namespace abut::capi

#endif
