// SPDX-License-Identifier: Apache-2.0
#include "response/problem_arguments.hpp"

#include "extension_arguments.hpp"
#include "response/arguments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <span>

namespace abut::capi {

namespace {

using response::across;
using response::ContactPlace;
using response::ContactRows;
using response::cross;
using response::dot;
using response::no_body;
using response::Row;
using response::scale;
using response::subtract;

constexpr double largest_friction = 1e6;

// An element of an array of the problem, by name.
struct Element {
  std::array<char, 64> name{};

  Element(const char* array, std::size_t index) noexcept {
    std::snprintf(name.data(), name.size(), "problem.%s[%zu]", array, index);
  }
};

[[nodiscard]] abut_status refuse_element(abut_status status, const char* array, std::size_t index, double value,
                                         const char* expectation) noexcept {
  return refuse(status, Element(array, index).name.data(), value, expectation);
}

struct [[gsl::Pointer]] Range {
  double least, most;
  const char* expectation;
};
constexpr Range any_number{-largest_number, largest_number, "it must be within 1e30"};
constexpr Range mass_range{least_mass, largest_number, "it must lie between 1e-30 and 1e30"};
constexpr Range friction_range{0, largest_friction, "it must lie between 0 and 1e6"};
constexpr Range compliance_range{0, largest_number, "it must lie between 0 and 1e30"};

enum class Presence : unsigned char { needed, optional };

// An array of the caller, checked; empty where it is null and may be.
[[nodiscard]] abut_status read(const char* name, const double* data, std::size_t count, const Range& range,
                               Presence presence, std::span<const double>& out) noexcept {
  out = {};
  if (count == 0) return ABUT_OK;
  if (data == nullptr) {
    if (presence == Presence::optional) return ABUT_OK;
    std::array<char, 64> full{};
    std::snprintf(full.data(), full.size(), "problem.%s", name);
    return refuse_null(full.data());
  }
  // SAFETY: the caller answers for as many numbers as bodies or contacts ask for.
  ABUT_UNSAFE_BEGIN
  out = std::span<const double>(data, count);
  ABUT_UNSAFE_END
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(out[i])) return refuse_element(ABUT_NOT_FINITE, name, i, out[i], "it must be finite");
    if (!(out[i] >= range.least && out[i] <= range.most))
      return refuse_element(ABUT_OUT_OF_RANGE, name, i, out[i], range.expectation);
  }
  return ABUT_OK;
}

[[nodiscard]] abut_vec3 vector_at(std::span<const double> numbers, std::size_t index) {
  return {numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2]};
}
[[nodiscard]] bool is_zero(const abut_vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
// The unit vector along one that is not zero.
[[nodiscard]] abut_vec3 unit(const abut_vec3& v) {
  const abut_vec3 tame = scale(v, 1 / std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}));
  return scale(tame, 1 / std::sqrt(dot(tame, tame)));
}

// All that is read, as spans.
struct [[gsl::Pointer]] Arrays {
  std::span<const double> masses, inertias, centres, free_velocities, points, normals, tangents, frictions, compliances,
      offsets, surface_velocities, first_velocities, first_impulses;
  std::span<const std::uint32_t> bodies;
};

[[nodiscard]] abut_status read_all(const abut_contact_problem& given, Arrays& out) noexcept {
  const std::size_t bodies = given.body_count, contacts = given.contact_count;
  using enum Presence;
  const auto each = [](auto... reads) {
    abut_status status = ABUT_OK;
    static_cast<void>((((status = reads()) == ABUT_OK) && ...));
    return status;
  };
  const abut_status status = each(
      [&] { return read("masses", given.masses, bodies, mass_range, needed, out.masses); },
      [&] { return read("inertias", given.inertias, 9 * bodies, any_number, needed, out.inertias); },
      [&] { return read("centres", given.centres, 3 * bodies, any_number, needed, out.centres); },
      [&] {
        return read("free_velocities", given.free_velocities, 6 * bodies, any_number, needed, out.free_velocities);
      },
      [&] { return read("points", given.points, 3 * contacts, any_number, needed, out.points); },
      [&] { return read("normals", given.normals, 3 * contacts, any_number, needed, out.normals); },
      [&] { return read("tangents", given.tangents, 3 * contacts, any_number, optional, out.tangents); },
      [&] { return read("frictions", given.frictions, 2 * contacts, friction_range, optional, out.frictions); },
      [&] { return read("compliances", given.compliances, contacts, compliance_range, optional, out.compliances); },
      [&] { return read("offsets", given.offsets, contacts, any_number, optional, out.offsets); },
      [&] {
        return read("surface_velocities", given.surface_velocities, 3 * contacts, any_number, optional,
                    out.surface_velocities);
      },
      [&] {
        return read("first_velocities", given.first_velocities, 6 * bodies, any_number, optional, out.first_velocities);
      },
      [&] {
        return read("first_impulses", given.first_impulses, 3 * contacts, any_number, optional, out.first_impulses);
      });
  if (status != ABUT_OK || contacts == 0) return status;
  if (given.bodies == nullptr) return refuse_null("problem.bodies");
  // SAFETY: the caller answers for two numbers a contact.
  ABUT_UNSAFE_BEGIN
  out.bodies = std::span<const std::uint32_t>(given.bodies, 2 * contacts);
  ABUT_UNSAFE_END
  return ABUT_OK;
}

[[nodiscard]] abut_status read_body(const Arrays& arrays, std::size_t i, PreparedProblem& out) {
  response::BodyMass body{.mass = arrays.masses[i], .inertia = {}};
  std::ranges::copy(arrays.inertias.subspan(9 * i, 9), body.inertia.begin());
  if (const abut_status status = check_inertia(body.inertia, "problem.inertias", 9 * i); status != ABUT_OK)
    return status;
  out.problem.bodies.push_back(body);
  Row& free = out.problem.free.emplace_back();
  std::ranges::copy(arrays.free_velocities.subspan(6 * i, 6), free.begin());
  Row& first = out.solution.velocities.emplace_back(free);
  if (!arrays.first_velocities.empty()) std::ranges::copy(arrays.first_velocities.subspan(6 * i, 6), first.begin());
  return ABUT_OK;
}

// The axes and frictions of a contact.
[[nodiscard]] abut_status read_frame(const Arrays& arrays, std::size_t k, ContactPlace& out) {
  const abut_vec3 normal = vector_at(arrays.normals, k);
  if (is_zero(normal)) return refuse_element(ABUT_ZERO_VECTOR, "normals", 3 * k, 0, "a normal must have a length");
  const abut_vec3 n = unit(normal);
  const double along = arrays.frictions.empty() ? 0 : arrays.frictions[2 * k];
  const double sideways = arrays.frictions.empty() ? 0 : arrays.frictions[2 * k + 1];
  abut_vec3 t = across(n);
  if (!arrays.tangents.empty()) {
    const abut_vec3 given = vector_at(arrays.tangents, k);
    const abut_vec3 part = is_zero(given) ? given : unit(given);
    const abut_vec3 flat = subtract(part, scale(n, dot(part, n)));
    if (!(dot(flat, flat) > 1e-16)) {
      return refuse_element(ABUT_ZERO_VECTOR, "tangents", 3 * k, given.x,
                            "a tangent must have a length beside the normal");
    }
    t = unit(flat);
  } else if (along != sideways) {
    return refuse_element(ABUT_INVALID_ARGUMENT, "frictions", 2 * k + 1, sideways,
                          "both frictions of a contact must be equal where problem.tangents is null");
  }
  out.axes = {t, cross(n, t), n};
  out.frictions = {along, sideways};
  return ABUT_OK;
}

[[nodiscard]] abut_status read_contact(const Arrays& arrays, std::size_t k, PreparedProblem& out) {
  const std::size_t bodies = out.problem.bodies.size();
  ContactPlace place{};
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const std::uint32_t body = arrays.bodies[2 * k + side];
    if (body != no_body && body >= bodies) {
      return refuse_element(ABUT_INDEX_OUT_OF_RANGE, "bodies", 2 * k + side, body,
                            "it must be less than problem.body_count, or ABUT_NO_BODY");
    }
  }
  if (arrays.bodies[2 * k] == arrays.bodies[2 * k + 1]) {
    return refuse_element(ABUT_INVALID_ARGUMENT, "bodies", 2 * k + 1, arrays.bodies[2 * k + 1],
                          "the two sides of a contact must differ");
  }
  if (const abut_status status = read_frame(arrays, k, place); status != ABUT_OK) return status;
  const abut_vec3 point = vector_at(arrays.points, k);
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const std::uint32_t body = arrays.bodies[2 * k + side];
    if (body == no_body) continue;
    const abut_vec3 arm = subtract(point, vector_at(arrays.centres, body));
    place.holders.push_back({.body = body, .weight = side == 0 ? -1.0 : 1.0, .arm = arm});
  }
  if (!arrays.surface_velocities.empty()) place.surface_velocity = vector_at(arrays.surface_velocities, k);
  ContactRows contact = response::contact_rows(place);
  contact.offset = arrays.offsets.empty() ? 0 : arrays.offsets[k];
  contact.drift[2] += contact.offset;
  contact.compliance = arrays.compliances.empty() ? 0 : arrays.compliances[k];
  contact.weight = response::weight_of(contact, out.problem.bodies);
  out.problem.contacts.push_back(contact);
  const abut_vec3 first = arrays.first_impulses.empty() ? abut_vec3{} : vector_at(arrays.first_impulses, k);
  out.solution.impulses.push_back(response::project(response::impulse_along(contact, first), contact.friction, 1, 1));
  return ABUT_OK;
}

}  // namespace

abut_status prepare(const abut_contact_problem& given, PreparedProblem& out) {
  if (!has_known_size(given)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "problem.struct_size", given.struct_size,
                  "fill the problem with abut_contact_problem_init");
  }
  if (given.reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "problem.reserved", given.reserved, "it must be 0");
  Arrays arrays;
  if (const abut_status status = read_all(given, arrays); status != ABUT_OK) return status;
  for (std::size_t i = 0; i < given.body_count; ++i) {
    if (const abut_status status = read_body(arrays, i, out); status != ABUT_OK) return status;
  }
  for (std::size_t k = 0; k < given.contact_count; ++k) {
    if (const abut_status status = read_contact(arrays, k, out); status != ABUT_OK) return status;
  }
  out.is_warm = !arrays.first_velocities.empty() || !arrays.first_impulses.empty();
  return ABUT_OK;
}

abut_status check_options(const abut_solver_options& options) noexcept {
  if (!has_known_size(options)) {
    return refuse(ABUT_WRONG_STRUCT_SIZE, "options.struct_size", options.struct_size,
                  "fill the options with abut_solver_options_init");
  }
  if (options.most_rounds == 0) return refuse(ABUT_OUT_OF_RANGE, "options.most_rounds", 0, "it must be at least 1");
  if (options.solver > ABUT_SOLVER_SWEEPS)
    return refuse(ABUT_UNKNOWN_VALUE, "options.solver", options.solver, "it must be a value of abut_solver");
  if (options.reserved != 0) return refuse(ABUT_INVALID_ARGUMENT, "options.reserved", options.reserved, "it must be 0");
  for (const auto& [name, value] :
       {std::pair("options.tolerance", options.tolerance), std::pair("options.speed", options.speed)}) {
    if (!std::isfinite(value)) return refuse(ABUT_NOT_FINITE, name, value, "it must be finite");
    if (!(value >= 0 && value <= largest_number))
      return refuse(ABUT_OUT_OF_RANGE, name, value, "it must lie between 0 and 1e30");
  }
  return ABUT_OK;
}

}  // namespace abut::capi
