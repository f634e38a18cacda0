// SPDX-License-Identifier: Apache-2.0
// What the contacts of two materials are like.
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.universe;

using namespace abut::capi;

namespace {

abut_contact_material from_material(const abut::ContactMaterial& its) {
  return {sizeof(abut_contact_material),
          0,
          its.friction_primary,
          its.friction_secondary,
          its.friction_spin,
          its.friction_roll,
          its.static_scale,
          its.slip,
          its.compliance,
          its.damping,
          its.restitution,
          its.restitution_threshold,
          its.adhesive_force};
}

abut::ContactMaterial to_material(const abut_contact_material& row) {
  return {.friction_primary = row.friction_primary,
          .friction_secondary = row.friction_secondary,
          .friction_spin = row.friction_spin,
          .friction_roll = row.friction_roll,
          .static_scale = row.static_scale,
          .slip = row.slip,
          .compliance = row.compliance,
          .damping = row.damping,
          .restitution = row.restitution,
          .restitution_threshold = row.restitution_threshold,
          .adhesive_force = row.adhesive_force};
}

abut_status set(abut_universe& its, std::uint32_t material_a, std::uint32_t material_b,
                const abut_contact_material* row) {
  std::optional<abut::ContactMaterial> wanted;
  if (row != nullptr) {
    const Where where{"row"};
    abut_status status = check_struct_size(where, *row);
    status = status != ABUT_OK ? status : check_reserved(where, row->reserved);
    if (status != ABUT_OK) {
      return status;
    }
    wanted = to_material(*row);
    if (const abut::Fault fault = abut::check_material(*wanted)) {
      return refuse(abut::Error{fault->code, "row." + fault->message});
    }
  }
  const auto done = its.universe.set_material(material_a, material_b, wanted);
  return done ? static_cast<abut_status>(ABUT_OK) : refuse(done.error());
}

}  // namespace

void abut_contact_material_init(abut_contact_material* material, uint32_t struct_size) {
  fill_defaults(from_material({}), struct_size, material);
}

abut_status abut_material_pair_set(abut_universe* universe, uint32_t material_a, uint32_t material_b,
                                   const abut_contact_material* row) {
  return guard(universe, [&](abut_universe& its) { return set(its, material_a, material_b, row); });
}

abut_status abut_material_pair_get(const abut_universe* universe, uint32_t material_a, uint32_t material_b,
                                   abut_contact_material* out) {
  return guard(universe, [&](const abut_universe& its) {
    abut_status status = check_not_null("out", out);
    status = status != ABUT_OK ? status : check_struct_size({"out"}, *out);
    if (status == ABUT_OK) {
      write_struct(from_material(its.universe.material(material_a, material_b)), out);
    }
    return status;
  });
}
