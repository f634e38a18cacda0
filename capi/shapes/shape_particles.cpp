// SPDX-License-Identifier: Apache-2.0
// Particles, with one radius or with radii of their own.
#include "border.hpp"
#include "guard.hpp"
#include "shapes/shape_make.hpp"

import abut.capability;

using namespace abut::capi;

namespace {

// Four numbers a particle, as the kind takes them where radii differ.
abut_status create_with_radii(std::span<const double> xyz, std::span<const double> radii, abut_shape** out) {
  if (const abut_status status = to_status(abut::check_all_finite("xyz", xyz)); status != ABUT_OK) {
    return status;
  }
  std::vector<double> places;
  places.reserve(4 * radii.size());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (!(radii[i] >= 0 && radii[i] <= abut::largest_coordinate)) {
      return to_status(abut::check_not_negative("radii[" + std::to_string(i) + "]", radii[i]));
    }
    places.insert(places.end(), {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2], radii[i]});
  }
  return create_named("particles", {std::array{0.0}, places, {}}, out);
}

}  // namespace

abut_status abut_particles_create(const double* xyz, size_t count, double radius, abut_shape** out) {
  return guard([&] {
    Numbers numbers;
    abut_status status = check_not_null("out", out);
    status = status != ABUT_OK ? status : read_span<3>("xyz", xyz, "count", count, numbers.reals);
    if (status == ABUT_OK) {
      // Radius 0 means something else to the generic door.
      if (const abut::Fault fault = abut::check_positive("radius", radius)) {
        return refuse(*fault);
      }
    }
    numbers.parameters = std::span(&radius, 1);
    return status != ABUT_OK ? status : create_named("particles", numbers, out);
  });
}

abut_status abut_particles_create_with_radii(const double* xyz, const double* radii, size_t count, abut_shape** out) {
  return guard([&] {
    std::span<const double> places, sizes;
    abut_status status = check_not_null("out", out);
    status = status != ABUT_OK ? status : read_span<3>("xyz", xyz, "count", count, places);
    status = status != ABUT_OK ? status : read_span("radii", radii, "count", count, sizes);
    return status != ABUT_OK ? status : create_with_radii(places, sizes, out);
  });
}
