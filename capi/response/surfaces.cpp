// SPDX-License-Identifier: Apache-2.0
// Meshes of response.h that follow particles.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

import abut.response;

namespace {

using abut::capi::check_number;
using abut::capi::guarded;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::Grains;
using abut::response::Surface;

constexpr double largest_weight = 1000, loosest_sum = 1e-6;

[[nodiscard]] std::array<char, 64> name_of(const char* argument, std::size_t i) {
  std::array<char, 64> name{};
  static_cast<void>(std::snprintf(name.data(), name.size(), "%s[%zu]", argument, i));
  return name;
}

// Weights of one vertex, which then have the sum 1.
[[nodiscard]] abut_status normalise(std::span<double> weights, std::size_t first) {
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const abut_status status = check_number(weights[i], name_of("weights", first + i).data(), -largest_weight,
                                            largest_weight, "it must lie between -1000 and 1000");
    if (status != ABUT_OK) return status;
  }
  const double sum = std::reduce(weights.begin(), weights.end());
  if (!(std::fabs(sum - 1) <= loosest_sum)) {
    return refuse(ABUT_OUT_OF_RANGE, name_of("weights", first).data(), weights[0],
                  "this one and the next three must have the sum 1");
  }
  for (double& weight : weights) weight /= sum;
  return ABUT_OK;
}

[[nodiscard]] abut_status map_vertices(abut_response& its, Surface surface) {
  const Grains* const particles = its.simulation.particles_of(surface.carrier);
  if (particles == nullptr) {
    return refuse(ABUT_STALE_ID, "carrier.slot", surface.carrier.slot, "its particles are no bodies of this response");
  }
  abut_geometry_info info;
  abut_geometry_info_init(&info, sizeof info);
  abut_status status = abut_geometry_describe(its.universe.get(), surface.geometry, &info);
  if (status == ABUT_STALE_ID) return abut::capi::refuse_stale("surface", surface.geometry);
  if (status != ABUT_OK) return status;
  const double* vertices = nullptr;
  std::size_t vertex_count = 0;
  if (abut_geometry_vertices(its.universe.get(), surface.geometry, &vertices, &vertex_count) != ABUT_OK)
    return refuse(ABUT_UNSUPPORTED, "surface.slot", surface.geometry.slot, "it has no vertices that could move");
  if (its.simulation.particles_of(surface.geometry) != nullptr) {
    return refuse(ABUT_INVALID_ARGUMENT, "surface.slot", surface.geometry.slot, "its vertices are bodies themselves");
  }
  if (its.simulation.mass_of(info.part)) {
    return refuse(ABUT_INVALID_ARGUMENT, "surface.slot", surface.geometry.slot,
                  "its part is a body, which its vertices cannot leave");
  }
  for (std::size_t i = 0; i < surface.nodes.size(); ++i) {
    if (surface.nodes[i] < particles->masses.size()) continue;
    return refuse(ABUT_INDEX_OUT_OF_RANGE, name_of("numbers", i).data(), surface.nodes[i],
                  "the carrier has not that many particles that are bodies");
  }
  for (std::size_t first = 0; status == ABUT_OK && first < surface.weights.size(); first += Surface::width)
    status = normalise(std::span(surface.weights).subspan(first, Surface::width), first);
  return status == ABUT_OK ? its.simulation.set_surface(std::move(surface)) : status;
}

}  // namespace

abut_status abut_response_map_vertices(abut_response* response, abut_geometry_id surface, abut_geometry_id carrier,
                                       const uint32_t* numbers, const double* weights, size_t count) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (numbers == nullptr) return refuse_null("numbers");
    if (weights == nullptr) return refuse_null("weights");
    if (const abut_status status = abut::capi::check_fits("count", count, Surface::width * sizeof(double));
        status != ABUT_OK)
      return status;
    if (count == 0 || count > std::numeric_limits<std::uint32_t>::max()) {
      return refuse(ABUT_OUT_OF_RANGE, "count", static_cast<double>(count), "a mesh has 1 to 4294967295 vertices");
    }
    // SAFETY: the caller answers for four numbers and weights of each vertex.
    ABUT_UNSAFE_BEGIN
    const std::span<const std::uint32_t> nodes(numbers, Surface::width * count);
    const std::span<const double> parts(weights, Surface::width * count);
    ABUT_UNSAFE_END
    return map_vertices(its, {.geometry = surface,
                              .carrier = carrier,
                              .nodes = {nodes.begin(), nodes.end()},
                              .weights = {parts.begin(), parts.end()}});
  });
}
