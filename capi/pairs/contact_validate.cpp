// SPDX-License-Identifier: Apache-2.0
// Checks of a contact record by itself, whoever made it.
#include "convert.hpp"
#include "guard.hpp"
#include "options.hpp"

import abut.capability;
import abut.core;
import abut.math;

using namespace abut::capi;

namespace {

constexpr std::uint32_t known_flags = ABUT_CONTACT_SENSOR | ABUT_CONTACT_SPECULATIVE | ABUT_CONTACT_REDUCED_AWAY;
// Records are exact within a few roundings; those of a file that keeps ten digits pass as well.
constexpr double slack = 1e-9;

double length(const abut::Vec3& v) { return std::sqrt(abut::dot(v, v)); }

abut_status check_unit(std::string_view field, const abut_vec3& v) {
  const double found = length(to_vec3(v));
  if (std::fabs(found - 1) <= slack) {
    return ABUT_OK;
  }
  return refuse(ABUT_INVALID_ARGUMENT,
                "contact" + std::string(field) + " has length " + abut::to_text(found) + "; it must be 1 within 1e-9");
}

abut_status check_vectors(const abut_contact& contact) {
  const Where where{"contact"};
  for (const auto& [field, v] : {std::pair{".point_a", contact.point_a}, std::pair{".point_b", contact.point_b},
                                 std::pair{".normal", contact.normal}, std::pair{".tangent", contact.tangent}}) {
    if (const abut_status status = check_position(where, field, v); status != ABUT_OK) {
      return status;
    }
  }
  abut_status status = check_unit(".normal", contact.normal);
  status = status != ABUT_OK ? status : check_unit(".tangent", contact.tangent);
  const double cosine = abut::dot(to_vec3(contact.normal), to_vec3(contact.tangent));
  if (status == ABUT_OK && std::fabs(cosine) > slack) {
    status = refuse(ABUT_INVALID_ARGUMENT,
                    "dot(contact.tangent, contact.normal) is " + abut::to_text(cosine) + "; it must be 0 within 1e-9");
  }
  return status;
}

abut_status check_distance(const abut_contact& contact) {
  if (!is_coordinate(contact.distance)) {
    return to_status(abut::check_finite("contact.distance", contact.distance));
  }
  const abut::Vec3 a = to_vec3(contact.point_a), b = to_vec3(contact.point_b);
  const double expected = abut::dot(b - a, to_vec3(contact.normal));
  // Near the origin points do not tell how large the shapes are, whose rounding they have.
  if (std::fabs(contact.distance - expected) <= slack * std::max(length(a) + length(b), 1.0)) {
    return ABUT_OK;
  }
  return refuse(error_about(abut::Errc::invalid_argument, "contact.distance", contact.distance,
                            "dot(point_b - point_a, normal), which is " + abut::to_text(expected)));
}

abut_status check_toi(double toi) {
  if (!std::isfinite(toi)) {
    return to_status(abut::check_finite("contact.toi", toi));
  }
  return toi >= 0 && toi <= 1 ? static_cast<abut_status>(ABUT_OK)
                              : refuse(error_about(abut::Errc::out_of_range, "contact.toi", toi, "between 0 and 1"));
}

abut_status check_words(const abut_contact& contact) {
  const Where where{"contact"};
  abut_status status = check_value(where, ".feature_a.kind", contact.feature_a.kind, ABUT_FEATURE_PARTICLE);
  status =
      status != ABUT_OK ? status : check_value(where, ".feature_b.kind", contact.feature_b.kind, ABUT_FEATURE_PARTICLE);
  status = status != ABUT_OK ? status : check_bits(where, ".flags", contact.flags, known_flags);
  if (status == ABUT_OK && contact.reserved != 0) {
    status =
        refuse(error_about(abut::Errc::invalid_argument, "contact.reserved", std::uint64_t{contact.reserved}, "zero"));
  }
  return status;
}

}  // namespace

abut_status abut_contact_validate(const abut_contact* contact) {
  return guard([&] {
    abut_status status = check_not_null("contact", contact);
    status = status != ABUT_OK ? status : check_vectors(*contact);
    status = status != ABUT_OK ? status : check_distance(*contact);
    status = status != ABUT_OK ? status : check_toi(contact->toi);
    return status != ABUT_OK ? status : check_words(*contact);
  });
}
