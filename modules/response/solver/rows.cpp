// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/abut.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

// Velocity of a point of a body along an axis: the axis, and its moment about the centre of mass.
[[nodiscard]] Row row_of(const abut_vec3& axis, double factor, const abut_vec3& arm) {
  const abut_vec3 moment = cross(arm, axis);
  return {factor * axis.x, factor * axis.y, factor * axis.z, factor * moment.x, factor * moment.y, factor * moment.z};
}

// How much shorter an impulse becomes where a hold yields; 1 where it does not.
[[nodiscard]] double part_of_most(const ContactRows& contact, const Triple& given) {
  const double size = norm_of(given[0], given[1], given[2]);
  return size > contact.most ? contact.most / size : 1;
}

}  // namespace

ContactRows contact_rows(const ContactPlace& place) {
  ContactRows out{};
  out.axes = place.axes;
  out.friction = std::max(place.frictions[0], place.frictions[1]);
  const double whole = out.friction > 0 ? out.friction : 1;
  out.scales = {place.frictions[0] / whole, place.frictions[1] / whole, 1};
  for (std::size_t i = 0; i < out.axes.size(); ++i)
    out.drift[i] = out.scales[i] * dot(place.surface_velocity, out.axes[i]);
  for (const Holder& holder : place.holders) {
    BodyRows& its = out.bodies.emplace_back(BodyRows{.body = holder.body, .rows = {}});
    for (std::size_t i = 0; i < out.axes.size(); ++i)
      its.rows[i] = row_of(out.axes[i], holder.weight * out.scales[i], holder.arm);
  }
  return out;
}

Triple allowed(const ContactRows& contact, const Triple& given, double tangent, double normal) {
  if (contact.law == Law::contact) return project(given, contact.friction, tangent, normal);
  const double part = part_of_most(contact, given);
  return {part * given[0], part * given[1], part * given[2]};
}

ConePoint allowed_with_derivative(const ContactRows& contact, const Triple& given, double tangent, double normal) {
  if (contact.law == Law::contact) return project_with_derivative(given, contact.friction, tangent, normal);
  const double part = part_of_most(contact, given);
  ConePoint out{.point = {part * given[0], part * given[1], part * given[2]}, .derivative = {}};
  const double square = given[0] * given[0] + given[1] * given[1] + given[2] * given[2];
  for (std::size_t i = 0; i < given.size(); ++i) {
    for (std::size_t j = 0; j < given.size(); ++j) {
      const double along = part < 1 ? given[i] * given[j] / square : 0;
      out.derivative[i][j] = part * ((i == j ? 1 : 0) - along);
    }
  }
  return out;
}

abut_vec3 world_impulse(const ContactRows& contact, const Triple& impulse) {
  abut_vec3 out{};
  for (std::size_t i = 0; i < impulse.size(); ++i)
    out = add(out, scale(contact.axes[i], contact.scales[i] * impulse[i]));
  return out;
}

Triple impulse_along(const ContactRows& contact, const abut_vec3& impulse) {
  Triple out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (contact.scales[i] > 0) out[i] = dot(impulse, contact.axes[i]) / contact.scales[i];
  }
  return out;
}

}  // namespace abut::response
