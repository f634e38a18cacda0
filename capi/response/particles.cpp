// SPDX-License-Identifier: Apache-2.0
// Grains of response.h.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <span>
#include <utility>

import abut.response;

namespace {

using abut::capi::check_number;
using abut::capi::guarded;
using abut::capi::largest_number;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::Grains;

[[nodiscard]] abut_status check_numbers(std::span<const double> numbers, const char* argument, double least) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::array<char, 64> name{};
    static_cast<void>(std::snprintf(name.data(), name.size(), "%s[%zu]", argument, i));
    const abut_status status =
        check_number(numbers[i], name.data(), least, largest_number,
                     least < 0 ? "it must be within 1e30" : "it must be 0, or lie between 1e-30 and 1e30");
    if (status != ABUT_OK) return status;
    if (least == 0 && numbers[i] > 0 && numbers[i] < abut::capi::least_mass)
      return refuse(ABUT_OUT_OF_RANGE, name.data(), numbers[i], "it must be 0, or lie between 1e-30 and 1e30");
  }
  return ABUT_OK;
}

[[nodiscard]] abut_status refuse_no_particles(abut_geometry_id geometry) noexcept {
  return refuse(ABUT_STALE_ID, "geometry.slot", geometry.slot, "its particles are no bodies of this response");
}

}  // namespace

abut_status abut_response_add_particles(abut_response* response, abut_geometry_id geometry, const double* masses,
                                        const double* xyz, const double* velocities, std::size_t count) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (masses == nullptr) return refuse_null("masses");
    if (xyz == nullptr) return refuse_null("xyz");
    if (const abut_status status = abut::capi::check_fits("count", count, 3 * sizeof(double)); status != ABUT_OK)
      return status;
    if (count == 0 || count > std::numeric_limits<std::uint32_t>::max()) {
      return refuse(ABUT_OUT_OF_RANGE, "count", static_cast<double>(count), "a geometry has 1 to 4294967295 particles");
    }
    abut_geometry_info info;
    abut_geometry_info_init(&info, sizeof info);
    abut_status status = abut_geometry_describe(its.universe.get(), geometry, &info);
    if (status != ABUT_OK) return status;
    if (its.simulation.mass_of(info.part)) {
      return refuse(ABUT_INVALID_ARGUMENT, "geometry.slot", geometry.slot,
                    "its part is a body, which its particles cannot leave");
    }
    // SAFETY: the caller answers for `count` masses, and three times as many other numbers.
    ABUT_UNSAFE_BEGIN
    const std::span<const double> weights(masses, count), places(xyz, 3 * count);
    const std::span<const double> moving(velocities, velocities == nullptr ? 0 : 3 * count);
    ABUT_UNSAFE_END
    status = check_numbers(weights, "masses", 0);
    if (status == ABUT_OK) status = check_numbers(places, "xyz", -largest_number);
    if (status == ABUT_OK) status = check_numbers(moving, "velocities", -largest_number);
    if (status != ABUT_OK) return status;
    Grains particles{.geometry = geometry,
                     .masses = {weights.begin(), weights.end()},
                     .xyz = {places.begin(), places.end()},
                     .velocities = {moving.begin(), moving.end()},
                     .springs = {},
                     .tetrahedra = {}};
    particles.velocities.resize(3 * count);
    return its.simulation.set_particles(std::move(particles));
  });
}

abut_status abut_response_remove_particles(abut_response* response, abut_geometry_id geometry) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    return its.simulation.remove_particles(geometry) ? ABUT_OK : refuse_no_particles(geometry);
  });
}

abut_status abut_response_particles(const abut_response* response, abut_geometry_id geometry, const double** xyz,
                                    const double** velocities, std::size_t* count) {
  if (response == nullptr) return refuse_null("response");
  if (xyz == nullptr) return refuse_null("xyz");
  if (velocities == nullptr) return refuse_null("velocities");
  if (count == nullptr) return refuse_null("count");
  const Grains* const found = response->simulation.particles_of(geometry);
  if (found == nullptr) return refuse_no_particles(geometry);
  *xyz = found->xyz.data();
  *velocities = found->velocities.data();
  *count = found->masses.size();
  return ABUT_OK;
}
