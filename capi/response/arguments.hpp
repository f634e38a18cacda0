// SPDX-License-Identifier: Apache-2.0
// Checks of what callers hand to response.h. Each writes this thread's message and answers the status; ABUT_OK when
// there is nothing to object to.
#ifndef ABUT_CAPI_RESPONSE_ARGUMENTS_HPP
#define ABUT_CAPI_RESPONSE_ARGUMENTS_HPP

#include <abut/response.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::capi {

// Products of a few such numbers stay finite.
inline constexpr double largest_number = 1e30, least_mass = 1e-30;
inline constexpr std::uint32_t most_threads = 256;

/// Finite, and from `least` to `most`; else "<argument> is <value>; <expectation>".
[[nodiscard]] abut_status check_number(double value, const char* argument, double least, double most,
                                       const char* expectation) noexcept;
[[nodiscard]] abut_status check_vector(const abut_vec3& vector, const char* argument) noexcept;
/// A symmetric positive definite matrix, whose numbers are finite. Its first number is `argument`[first].
[[nodiscard]] abut_status check_inertia(std::span<const double, 9> matrix, const char* argument,
                                        std::size_t first) noexcept;
[[nodiscard]] abut_status check_mass(const abut_mass_properties& mass, const char* argument) noexcept;
[[nodiscard]] abut_status check_density(double density, const char* argument) noexcept;

/// Numbers that contacts take from materials, and from what the caller makes of these.
[[nodiscard]] abut_status check_material(const abut_contact_material& material) noexcept;

/// The law that the callback of a kind has made.
[[nodiscard]] abut_status check_law(const abut_contact_law& law) noexcept;

[[nodiscard]] abut_status check_options(const abut_link_options& options) noexcept;
[[nodiscard]] abut_status check_options(const abut_response_options& options) noexcept;
[[nodiscard]] abut_status check_options(const abut_body_options& options) noexcept;

}  // namespace abut::capi

#endif
