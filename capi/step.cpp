// Steps of a universe and what they found.
#include "universe_handle.hpp"
#include "options.hpp"

import abut.core;
import abut.shape;
import abut.universe;

using namespace abut::capi;

namespace {

abut_status step(abut_universe& its, double dt) {
  if (const auto done = its.universe.step(dt); !done) {
    return refuse(done.error());
  }
  const std::span<const abut::Contact> found = its.universe.contacts();
  its.contacts.resize(found.size());
  fill(found, std::span(its.contacts), [](const abut::Contact& contact) {
    abut_contact out = from_contact(contact.point);
    out.geometry_a = from_geometry(contact.geometry_a);
    out.geometry_b = from_geometry(contact.geometry_b);
    out.age = contact.age;
    out.user_data = contact.user_data;
    return out;
  });
  return ABUT_OK;
}

abut_status set_user_data(abut_universe& its, std::span<const std::uint64_t> user_data) {
  if (const auto done = its.universe.set_contact_user_data(user_data); !done) {
    return refuse(done.error());
  }
  for (std::size_t i = 0; i < user_data.size(); ++i) {
    its.contacts[i].user_data = user_data[i];
  }
  return ABUT_OK;
}

abut_status write_stats(const abut::StepStats& stats, abut_step_stats* out) {
  if (const abut_status status = check_struct_size({"out"}, *out); status != ABUT_OK) {
    return status;
  }
  write_struct({sizeof(abut_step_stats), 0, stats.parts, stats.geometries, stats.moved, stats.candidate_pairs,
                stats.touching_pairs, stats.contacts, stats.unsupported_pairs, stats.bytes, stats.refresh_microseconds,
                stats.broadphase_microseconds, stats.narrowphase_microseconds, stats.contact_microseconds},
               out);
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_step(abut_universe* universe, double dt) {
  return guard(universe, [&](abut_universe& its) { return step(its, dt); });
}

abut_status abut_universe_contacts(const abut_universe* universe, const abut_contact** contacts, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"contacts", contacts}, {"count", count}}});
    if (status == ABUT_OK) {
      *contacts = its.contacts.data();
      *count = its.contacts.size();
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

void abut_step_stats_init(abut_step_stats* stats, uint32_t struct_size) {
  fill_defaults(abut_step_stats{}, struct_size, stats);
}

abut_status abut_universe_stats(const abut_universe* universe, abut_step_stats* out) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : write_stats(its.universe.stats(), out);
  });
}
