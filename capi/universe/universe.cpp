// SPDX-License-Identifier: Apache-2.0
// Universes as a whole.
#include "universe/universe_handle.hpp"
#include "options.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_broadphase>(abut::BroadphaseKind::automatic) == ABUT_BROADPHASE_AUTO);
static_assert(static_cast<abut_broadphase>(abut::BroadphaseKind::brute) == ABUT_BROADPHASE_BRUTE);
static_assert(static_cast<abut_broadphase>(abut::BroadphaseKind::tree) == ABUT_BROADPHASE_TREE);
static_assert(static_cast<abut_broadphase>(abut::BroadphaseKind::sweep_and_prune) == ABUT_BROADPHASE_SWEEP_AND_PRUNE);
static_assert(static_cast<abut_broadphase>(abut::BroadphaseKind::hash_grid) == ABUT_BROADPHASE_HASH_GRID);
static_assert(static_cast<abut_tolerance_mode>(abut::ToleranceMode::dead_band) == ABUT_TOLERANCE_DEAD_BAND);
static_assert(static_cast<abut_tolerance_mode>(abut::ToleranceMode::margin) == ABUT_TOLERANCE_MARGIN);
static_assert(static_cast<abut_event_bits>(abut::event_pairs) == ABUT_EVENTS_PAIRS);
static_assert(static_cast<abut_event_bits>(abut::event_persist) == ABUT_EVENTS_PERSIST);
static_assert(static_cast<abut_event_bits>(abut::event_contacts) == ABUT_EVENTS_CONTACTS);
static_assert(static_cast<abut_event_bits>(abut::event_elements) == ABUT_EVENTS_ELEMENTS);

namespace {

constexpr abut_universe_options default_options{sizeof(abut_universe_options),
                                                ABUT_BROADPHASE_AUTO,
                                                ABUT_TOLERANCE_DEAD_BAND,
                                                4,
                                                {0, 0, 0},
                                                1,
                                                ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST,
                                                0,
                                                0};

abut_status check_options(const abut_universe_options& options) {
  const Where where{"options"};
  abut_status status = check_struct_size(where, options);
  status =
      status != ABUT_OK ? status : check_value(where, ".broadphase", options.broadphase, ABUT_BROADPHASE_HASH_GRID);
  status =
      status != ABUT_OK ? status : check_value(where, ".tolerance_mode", options.tolerance_mode, ABUT_TOLERANCE_MARGIN);
  status = status != ABUT_OK ? status : check_position(where, ".origin", options.origin);
  status = status != ABUT_OK ? status : check_threads(options.threads);
  status = status != ABUT_OK
               ? status
               : check_bits(where, ".events", options.events,
                            ABUT_EVENTS_PAIRS | ABUT_EVENTS_PERSIST | ABUT_EVENTS_CONTACTS | ABUT_EVENTS_ELEMENTS);
  return status != ABUT_OK
             ? status
             : check_bits(where, ".flags", options.flags, ABUT_UNIVERSE_LOCAL_POINTS | ABUT_UNIVERSE_WELDS);
}

abut_status create(const abut_universe_options& options, abut_universe** out) {
  if (const abut_status status = check_options(options); status != ABUT_OK) {
    return status;
  }
  abut::UniverseOptions wanted;
  wanted.broadphase = static_cast<abut::BroadphaseKind>(options.broadphase);
  wanted.tolerance_mode = static_cast<abut::ToleranceMode>(options.tolerance_mode);
  wanted.max_contacts = options.max_contacts;
  wanted.max_pair_contacts = options.max_pair_contacts;
  wanted.origin = to_vec3(options.origin);
  wanted.threads = options.threads;
  wanted.events = options.events;
  wanted.keeps_local_points = (options.flags & ABUT_UNIVERSE_LOCAL_POINTS) != 0;
  wanted.welds = (options.flags & ABUT_UNIVERSE_WELDS) != 0;
  *out = std::make_unique<abut_universe>(wanted, next_universe_number()).release();
  return ABUT_OK;
}

// Writes a list by count-then-fill.
template <class CId, class Id, class Convert>
abut_status write_ids(const std::vector<Id>& found, std::span<CId> out, std::size_t* count, Convert&& convert) {
  fill(std::span<const Id>(found), out, convert);
  *count = found.size();
  return ABUT_OK;
}

void write_text(const std::string& found, std::span<char> out, std::size_t* needed) {
  if (!out.empty()) {
    const std::size_t length = std::min(found.size(), out.size() - 1);
    std::copy_n(found.begin(), length, out.begin());
    out[length] = '\0';
  }
  *needed = found.size() + 1;
}

using Words = std::string (abut::Universe::*)(std::span<const abut::Plan::Extension>) const;

abut_status explain(const abut_universe* universe, Words words, char* text, std::size_t capacity, std::size_t* needed) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<char> out;
    abut_status status = check_not_null("needed", needed);
    status = status != ABUT_OK ? status : read_span("text", text, "capacity", capacity, out);
    if (status == ABUT_OK) {
      write_text((its.universe.*words)(its.extensions.all()), out, needed);
    }
    return status;
  });
}

}  // namespace

abut_universe::abut_universe(const abut::UniverseOptions& options, std::uint32_t number) : universe(options, number) {}
abut_universe::~abut_universe() = default;

void abut::capi::let_go(const abut_universe& universe) noexcept {
  // The last owner has to see what all others have done with it.
  if (universe.owners.fetch_sub(1, std::memory_order_acq_rel) == 1) {
    const std::unique_ptr<const abut_universe> last(&universe);
  }
}

std::uint32_t abut::capi::next_universe_number() {
  static constinit std::atomic<std::uint32_t> next{1};
  return next.fetch_add(1, std::memory_order_relaxed);
}

void abut_universe_options_init(abut_universe_options* options, uint32_t struct_size) {
  fill_defaults(default_options, struct_size, options);
}

abut_status abut_universe_create(const abut_universe_options* options, abut_universe** out) {
  return guard([&] {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : create(options == nullptr ? default_options : *options, out);
  });
}

void abut_universe_destroy(abut_universe* universe) {
  const bool is_in_use = universe != nullptr && universe->universe.is_stepping();
  if (universe != nullptr && !is_in_use) {
    let_go(*universe);
  }
}

abut_status abut_universe_parts(const abut_universe* universe, abut_part_id* parts, size_t capacity, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_part_id> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("parts", parts, "capacity", capacity, out);
    return status != ABUT_OK ? status : write_ids(its.universe.parts(), out, count, from_part);
  });
}

abut_status abut_universe_geometries(const abut_universe* universe, abut_geometry_id* geometries, size_t capacity,
                                     size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_geometry_id> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    return status != ABUT_OK ? status : write_ids(its.universe.geometries(), out, count, from_geometry);
  });
}

abut_status abut_universe_revision(const abut_universe* universe, abut_revision* out) {
  return guard(universe, [&](const abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const abut::Revision revision = its.universe.revision();
    *out = {revision.geometries, revision.poses};
    return abut_status{ABUT_OK};
  });
}

abut_status abut_universe_counters(const abut_universe* universe, const uint64_t** geometries, const uint64_t** poses) {
  return guard(universe, [&](const abut_universe& its) {
    abut_status status = check_not_null("geometries", geometries);
    status = status != ABUT_OK ? status : check_not_null("poses", poses);
    if (status == ABUT_OK) {
      const abut::Revision& revision = its.universe.revision();
      *geometries = &revision.geometries;
      *poses = &revision.poses;
    }
    return status;
  });
}

abut_status abut_universe_changes(const abut_universe* universe, const abut_revision* since,
                                  abut_geometry_id* geometries, size_t capacity, size_t* count, uint32_t* is_known) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_geometry_id> out;
    abut_status status = check_none_null<3>({{{"since", since}, {"count", count}, {"is_known", is_known}}});
    status = status != ABUT_OK ? status : read_span("geometries", geometries, "capacity", capacity, out);
    if (status != ABUT_OK) {
      return status;
    }
    const auto found = its.universe.changed_since({since->geometries, since->poses});
    *is_known = found ? 1 : 0;
    return write_ids(found.value_or(std::vector<abut::GeometryId>{}), out, count, from_geometry);
  });
}

abut_status abut_universe_explain(const abut_universe* universe, char* text, size_t capacity, size_t* needed) {
  return explain(universe, &abut::Universe::explain, text, capacity, needed);
}

abut_status abut_universe_explain_json(const abut_universe* universe, char* text, size_t capacity, size_t* needed) {
  return explain(universe, &abut::Universe::explain_json, text, capacity, needed);
}
