// SPDX-License-Identifier: Apache-2.0
#include "problem_arguments.hpp"

#include "extension_arguments.hpp"

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

using response::ContactRows;
using response::no_body;
using response::Row;
using response::Triple;

// Products of a few such numbers stay finite.
constexpr double largest = 1e30, least_mass = 1e-30, largest_friction = 1e6;

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

struct Range {
  double least, most;
  const char* expectation;
};
constexpr Range any_number{-largest, largest, "it must be within 1e30"};
constexpr Range mass_range{least_mass, largest, "it must lie between 1e-30 and 1e30"};
constexpr Range friction_range{0, largest_friction, "it must lie between 0 and 1e6"};
constexpr Range compliance_range{0, largest, "it must lie between 0 and 1e30"};

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
[[nodiscard]] double dot(const abut_vec3& a, const abut_vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] abut_vec3 cross(const abut_vec3& a, const abut_vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] abut_vec3 subtract(const abut_vec3& a, const abut_vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] abut_vec3 scale(const abut_vec3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
[[nodiscard]] bool is_zero(const abut_vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }
// Of a vector that is not zero.
[[nodiscard]] abut_vec3 unit(const abut_vec3& v) {
  const abut_vec3 tame = scale(v, 1 / std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}));
  return scale(tame, 1 / std::sqrt(dot(tame, tame)));
}

// Any direction at right angles to a unit vector: Duff et al., "Building an orthonormal basis, revisited" (2017),
// https://jcgt.org/published/0006/01/01/.
[[nodiscard]] abut_vec3 across(const abut_vec3& n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z);
  return {1 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

// All that is read, as spans.
struct Arrays {
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
  const auto& m = body.inertia;
  for (const auto& [row, column] : {std::pair<std::size_t, std::size_t>(0, 1), {0, 2}, {1, 2}}) {
    const double upper = m[3 * row + column], lower = m[3 * column + row];
    if (std::fabs(upper - lower) > 1e-12 * std::max({m[0], m[4], m[8]})) {
      return refuse_element(ABUT_INVALID_ARGUMENT, "inertias", 9 * i + 3 * row + column, upper,
                            "the matrix of a body must be symmetric");
    }
  }
  const double d1 = m[4] - m[3] / m[0] * m[3], rest = m[7] - m[6] / m[0] * m[3];
  const double d2 = m[8] - m[6] / m[0] * m[6] - rest / d1 * rest;
  for (const auto& [pivot, place] : {std::pair(m[0], 0U), std::pair(d1, 4U), std::pair(d2, 8U)}) {
    if (!(pivot >= least_mass)) {
      return refuse_element(ABUT_OUT_OF_RANGE, "inertias", 9 * i + place, m[place],
                            "the matrix of a body must be positive definite, by at least 1e-30");
    }
  }
  out.problem.bodies.push_back(body);
  Row& free = out.problem.free.emplace_back();
  std::ranges::copy(arrays.free_velocities.subspan(6 * i, 6), free.begin());
  Row& first = out.solution.velocities.emplace_back(free);
  if (!arrays.first_velocities.empty()) std::ranges::copy(arrays.first_velocities.subspan(6 * i, 6), first.begin());
  return ABUT_OK;
}

[[nodiscard]] abut_status read_frame(const Arrays& arrays, std::size_t k, double& friction, ContactFrame& out) {
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
  friction = std::max(along, sideways);
  const double whole = friction > 0 ? friction : 1;
  out = {.axes = {t, cross(n, t), n}, .scales = {along / whole, sideways / whole, 1}};
  return ABUT_OK;
}

// Velocity of the point of a body along an axis: the axis, and the moment of it about the centre.
[[nodiscard]] Row row_of(const abut_vec3& axis, double factor, const abut_vec3& arm) {
  const abut_vec3 moment = cross(arm, axis);
  return {factor * axis.x, factor * axis.y, factor * axis.z, factor * moment.x, factor * moment.y, factor * moment.z};
}

[[nodiscard]] abut_status read_contact(const Arrays& arrays, std::size_t k, PreparedProblem& out) {
  const std::size_t bodies = out.problem.bodies.size();
  ContactRows contact{};
  contact.a = arrays.bodies[2 * k];
  contact.b = arrays.bodies[2 * k + 1];
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const std::uint32_t body = arrays.bodies[2 * k + side];
    if (body != no_body && body >= bodies) {
      return refuse_element(ABUT_INDEX_OUT_OF_RANGE, "bodies", 2 * k + side, body,
                            "it must be less than problem.body_count, or ABUT_NO_BODY");
    }
  }
  if (contact.a == contact.b) {
    return refuse_element(ABUT_INVALID_ARGUMENT, "bodies", 2 * k + 1, contact.b,
                          "the two sides of a contact must differ");
  }
  ContactFrame frame;
  if (const abut_status status = read_frame(arrays, k, contact.friction, frame); status != ABUT_OK) return status;
  const abut_vec3 point = vector_at(arrays.points, k);
  const auto arm = [&](std::uint32_t body) {
    return body == no_body ? abut_vec3{} : subtract(point, vector_at(arrays.centres, body));
  };
  const abut_vec3 arm_a = arm(contact.a), arm_b = arm(contact.b);
  const abut_vec3 surface = arrays.surface_velocities.empty() ? abut_vec3{} : vector_at(arrays.surface_velocities, k);
  Triple first{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double factor = frame.scales[i];
    contact.of_a[i] = row_of(frame.axes[i], -factor, arm_a);
    contact.of_b[i] = row_of(frame.axes[i], factor, arm_b);
    contact.drift[i] = factor * dot(surface, frame.axes[i]);
    if (!arrays.first_impulses.empty() && factor > 0)
      first[i] = dot(vector_at(arrays.first_impulses, k), frame.axes[i]) / factor;
  }
  contact.offset = arrays.offsets.empty() ? 0 : arrays.offsets[k];
  contact.drift[2] += contact.offset;
  contact.compliance = arrays.compliances.empty() ? 0 : arrays.compliances[k];
  contact.weight = response::weight_of(contact, out.problem.bodies);
  out.problem.contacts.push_back(contact);
  out.solution.impulses.push_back(response::project(first, contact.friction, 1, 1));
  out.frames.push_back(frame);
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
  for (const auto& [name, value] :
       {std::pair("options.tolerance", options.tolerance), std::pair("options.speed", options.speed)}) {
    if (!std::isfinite(value)) return refuse(ABUT_NOT_FINITE, name, value, "it must be finite");
    if (!(value >= 0 && value <= largest))
      return refuse(ABUT_OUT_OF_RANGE, name, value, "it must lie between 0 and 1e30");
  }
  return ABUT_OK;
}

}  // namespace abut::capi
