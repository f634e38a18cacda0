// SPDX-License-Identifier: Apache-2.0
// What a step found: contacts, and what began and ended.
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_contact_flags>(abut::contact_of_sensor) == ABUT_CONTACT_SENSOR);
static_assert(static_cast<abut_contact_flags>(abut::contact_speculative) == ABUT_CONTACT_SPECULATIVE);
static_assert(static_cast<abut_event_kind>(abut::EventKind::begin) == ABUT_EVENT_BEGIN);
static_assert(static_cast<abut_event_kind>(abut::EventKind::persist) == ABUT_EVENT_PERSIST);
static_assert(static_cast<abut_event_kind>(abut::EventKind::end) == ABUT_EVENT_END);
static_assert(static_cast<abut_event_flags>(abut::event_of_sensor) == ABUT_EVENT_SENSOR);
static_assert(static_cast<abut_event_flags>(abut::event_of_contact) == ABUT_EVENT_CONTACT);

namespace {

abut_contact from_found(const abut::Contact& contact) {
  abut_contact out = from_contact(contact.point);
  out.geometry_a = from_geometry(contact.geometry_a);
  out.geometry_b = from_geometry(contact.geometry_b);
  out.flags = contact.flags;
  out.age = contact.age;
  out.user_data = contact.user_data;
  out.material_a = contact.material_a;
  out.material_b = contact.material_b;
  out.toi = contact.toi;
  return out;
}

abut_local_points from_local(const abut::LocalPoints& points) { return {from_vec3(points.a), from_vec3(points.b)}; }

abut_event from_event(const abut::Event& event) {
  return {static_cast<abut_event_kind>(event.kind),
          event.flags,
          from_geometry(event.geometry_a),
          from_geometry(event.geometry_b),
          event.contact_id,
          event.first_contact,
          event.contact_count};
}

abut_status set_user_data(abut_universe& its, std::span<const std::uint64_t> user_data) {
  if (const auto done = its.universe.set_contact_user_data(user_data); !done) {
    return refuse(done.error());
  }
  its.contacts.forget();
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_contacts(const abut_universe* universe, const abut_contact** contacts, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"contacts", contacts}, {"count", count}}});
    if (status == ABUT_OK) {
      const std::span<const abut_contact> lent = its.contacts.get(its.universe.contacts(), from_found);
      *contacts = lent.data();
      *count = lent.size();
    }
    return status;
  });
}

abut_status abut_universe_local_points(const abut_universe* universe, const abut_local_points** points, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    abut_status status = check_none_null<2>({{{"points", points}, {"count", count}}});
    if (status == ABUT_OK && !its.universe.keeps_local_points()) {
      status = refuse(ABUT_UNSUPPORTED,
                      "universe keeps no local points; ABUT_UNIVERSE_LOCAL_POINTS in its options.flags is not set");
    }
    if (status == ABUT_OK) {
      const std::span<const abut_local_points> lent = its.local_points.get(its.universe.local_points(), from_local);
      *points = lent.data();
      *count = lent.size();
    }
    return status;
  });
}

abut_status abut_contacts_set_user_data(abut_universe* universe, const uint64_t* user_data, size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const std::uint64_t> values;
    const abut_status status = read_span("user_data", user_data, "count", count, values);
    return status != ABUT_OK ? status : set_user_data(its, values);
  });
}

abut_status abut_universe_events(const abut_universe* universe, const abut_event** events, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"events", events}, {"count", count}}});
    if (status == ABUT_OK) {
      const std::span<const abut_event> lent = its.events.get(its.universe.events(), from_event);
      *events = lent.data();
      *count = lent.size();
    }
    return status;
  });
}
