// SPDX-License-Identifier: Apache-2.0
// Springs and tetrahedra of response.h.
#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/arguments.hpp"
#include "response/handle.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <vector>

#include "defaults.hpp"

import abut.response;

namespace {

using abut::capi::check_number;
using abut::capi::guarded;
using abut::capi::largest_number;
using abut::capi::refuse;
using abut::capi::refuse_null;
using abut::response::Grains;
using abut::response::Spring;
using abut::response::Tetrahedron;

constexpr abut_elastic_options usual_elastic{
    .struct_size = sizeof(abut_elastic_options), .reserved = 0, .young = 1e6, .poisson = 0.3, .damping = 0};
constexpr double largest_poisson = 0.499;

using Name = std::array<char, 64>;
[[nodiscard]] Name name_of(const char* argument, std::size_t i) {
  Name name{};
  static_cast<void>(std::snprintf(name.data(), name.size(), "%s[%zu]", argument, i));
  return name;
}

[[nodiscard]] abut_status check_sizes(std::span<const double> numbers, const char* argument) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const abut_status status =
        check_number(numbers[i], name_of(argument, i).data(), 0, largest_number, "it must lie between 0 and 1e30");
    if (status != ABUT_OK) return status;
  }
  return ABUT_OK;
}

// Numbers of particles, `width` to an element, which differ.
[[nodiscard]] abut_status check_nodes(std::span<const std::uint32_t> nodes, std::size_t width, std::size_t count,
                                      const char* argument) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] >= count) {
      return refuse(ABUT_INDEX_OUT_OF_RANGE, name_of(argument, i).data(), nodes[i],
                    "the geometry has not that many particles that are bodies");
    }
    for (std::size_t j = i - i % width; j < i; ++j) {
      if (nodes[j] == nodes[i])
        return refuse(ABUT_INVALID_ARGUMENT, name_of(argument, i).data(), nodes[i], "it must differ from the others");
    }
  }
  return ABUT_OK;
}

[[nodiscard]] abut_status refuse_no_particles(abut_geometry_id geometry) {
  return refuse(ABUT_STALE_ID, "geometry.slot", geometry.slot, "its particles are no bodies of this response");
}

[[nodiscard]] abut_vec3 place_of(const Grains& particles, std::uint32_t node) {
  const std::size_t first = 3 * std::size_t{node};
  return {particles.xyz[first], particles.xyz[first + 1], particles.xyz[first + 2]};
}

[[nodiscard]] abut_status check_options(const abut_elastic_options& options) {
  if (!abut::capi::has_known_size(options)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "options.struct_size", options.struct_size,
                  "fill the options with abut_elastic_options_init");
  }
  if (options.reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "options.reserved", options.reserved, "it must be 0");
  abut_status status =
      check_number(options.young, "options.young", 0, largest_number, "it must lie between 0 and 1e30");
  if (status == ABUT_OK) {
    status = check_number(options.poisson, "options.poisson", 0, largest_poisson, "it must lie between 0 and 0.499");
  }
  if (status == ABUT_OK) {
    status = check_number(options.damping, "options.damping", 0, largest_number, "it must lie between 0 and 1e30");
  }
  return status;
}

[[nodiscard]] abut_status add_springs(abut_response& its, abut_geometry_id geometry,
                                      std::span<const std::uint32_t> pairs, std::span<const double> stiffnesses,
                                      std::span<const double> dampings, std::span<const double> rest_lengths) {
  const Grains* const particles = its.simulation.particles_of(geometry);
  if (particles == nullptr) return refuse_no_particles(geometry);
  abut_status status = check_nodes(pairs, 2, particles->masses.size(), "pairs");
  if (status == ABUT_OK) status = check_sizes(stiffnesses, "stiffnesses");
  if (status == ABUT_OK) status = check_sizes(dampings, "dampings");
  if (status == ABUT_OK) status = check_sizes(rest_lengths, "rest_lengths");
  if (status != ABUT_OK) return status;
  std::vector<Spring> springs;
  springs.reserve(stiffnesses.size());
  for (std::size_t i = 0; i < stiffnesses.size(); ++i) {
    const std::uint32_t a = pairs[2 * i], b = pairs[2 * i + 1];
    const double present =
        abut::response::length(abut::response::subtract(place_of(*particles, b), place_of(*particles, a)));
    springs.push_back({.a = a,
                       .b = b,
                       .rest = rest_lengths.empty() ? present : rest_lengths[i],
                       .stiffness = stiffnesses[i],
                       .damping = dampings.empty() ? 0 : dampings[i]});
  }
  its.simulation.add_springs(geometry, springs);
  return ABUT_OK;
}

[[nodiscard]] abut_status add_tetrahedra(abut_response& its, abut_geometry_id geometry,
                                         std::span<const std::uint32_t> nodes, const abut_elastic_options& options) {
  const Grains* const particles = its.simulation.particles_of(geometry);
  if (particles == nullptr) return refuse_no_particles(geometry);
  const abut_status status = check_nodes(nodes, 4, particles->masses.size(), "tetrahedra");
  if (status != ABUT_OK) return status;
  std::vector<Tetrahedron> elements;
  elements.reserve(nodes.size() / 4);
  for (std::size_t i = 0; i < nodes.size(); i += 4) {
    const std::array<std::uint32_t, 4> own{nodes[i], nodes[i + 1], nodes[i + 2], nodes[i + 3]};
    const std::array<abut_vec3, 4> corners{place_of(*particles, own[0]), place_of(*particles, own[1]),
                                           place_of(*particles, own[2]), place_of(*particles, own[3])};
    const std::optional<Tetrahedron> made =
        abut::response::tetrahedron_of(own, corners, options.young, options.poisson, options.damping);
    if (!made) {
      return refuse(ABUT_INVALID_ARGUMENT, name_of("tetrahedra", i).data(), nodes[i],
                    "its tetrahedron has no volume, since its corners lie in a plane");
    }
    elements.push_back(*made);
  }
  its.simulation.add_tetrahedra(geometry, elements);
  return ABUT_OK;
}

}  // namespace

abut_status abut_response_add_springs(abut_response* response, abut_geometry_id geometry, const uint32_t* pairs,
                                      const double* stiffnesses, const double* dampings, const double* rest_lengths,
                                      size_t count) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (const abut_status status = abut::capi::check_fits("count", count, 2 * sizeof(std::uint32_t)); status != ABUT_OK)
      return status;
    if (pairs == nullptr && count != 0) return refuse_null("pairs");
    if (stiffnesses == nullptr && count != 0) return refuse_null("stiffnesses");
    // SAFETY: the caller answers for `count` springs.
    ABUT_UNSAFE_BEGIN
    const std::span<const std::uint32_t> nodes(pairs, 2 * count);
    const std::span<const double> stiff(stiffnesses, count), damped(dampings, dampings == nullptr ? 0 : count);
    const std::span<const double> rest(rest_lengths, rest_lengths == nullptr ? 0 : count);
    ABUT_UNSAFE_END
    return add_springs(its, geometry, nodes, stiff, damped, rest);
  });
}

void abut_elastic_options_init(abut_elastic_options* options, uint32_t struct_size) {
  abut::capi::fill_defaults(usual_elastic, struct_size, options);
}

abut_status abut_response_add_tetrahedra(abut_response* response, abut_geometry_id geometry, const uint32_t* tetrahedra,
                                         size_t count, const abut_elastic_options* options) {
  return guarded(response, [&](abut_response& its) -> abut_status {
    if (const abut_status status = abut::capi::check_fits("count", count, 4 * sizeof(std::uint32_t)); status != ABUT_OK)
      return status;
    if (tetrahedra == nullptr && count != 0) return refuse_null("tetrahedra");
    if (options != nullptr) {
      if (const abut_status status = check_options(*options); status != ABUT_OK) return status;
    }
    // SAFETY: the caller answers for `count` tetrahedra.
    ABUT_UNSAFE_BEGIN
    const std::span<const std::uint32_t> nodes(tetrahedra, 4 * count);
    ABUT_UNSAFE_END
    return add_tetrahedra(its, geometry, nodes, options == nullptr ? usual_elastic : *options);
  });
}
