// SPDX-License-Identifier: Apache-2.0
// What a step found of vertices, edges and faces.
#include "deforming/stencil.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

namespace {

abut_element_contact from_element_contact(const abut::ElementContact& contact, std::uint32_t age) {
  return {from_geometry(contact.geometry_a),
          from_geometry(contact.geometry_b),
          from_stencil(contact.stencil),
          contact.gap,
          contact.id,
          age,
          0};
}

}  // namespace

abut_status abut_universe_element_contacts(const abut_universe* universe, const abut_element_contact** contacts,
                                           size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"contacts", contacts}, {"count", count}}});
    if (status == ABUT_OK) {
      const abut::ElementStage& found = its.universe.elements();
      const std::span<const abut_element_contact> lent =
          its.element_contacts.get_filled(found.contact_count(), [&](std::span<abut_element_contact> out) {
            std::size_t place = 0;
            found.visit([&](const abut::ElementContact& contact, std::uint32_t age) {
              out[place++] = from_element_contact(contact, age);
            });
          });
      *contacts = lent.data();
      *count = lent.size();
    }
    return status;
  });
}
