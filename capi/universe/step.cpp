// SPDX-License-Identifier: Apache-2.0
// Steps of a universe, and how they went.
#include "log.hpp"
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.math;
import abut.universe;

using namespace abut::capi;

namespace {

// What is odd about the scene, once, where somebody hears it. The step is over: lack of memory for words is not told.
void tell_findings(abut_universe& its) noexcept {
  if (its.has_told_findings || !is_heard(ABUT_LOG_WARNING)) {
    return;
  }
  its.has_told_findings = true;
  try {
    for (const abut::Finding& finding : its.universe.validate()) {
      tell(ABUT_LOG_WARNING, finding.message);
    }
  } catch (const std::bad_alloc&) {
    its.has_told_findings = false;
  }
}

// What was lent out is that of the step before once a detection has found something else. A filter may have asked for
// it on the way.
abut_status forget_lent(abut_universe& its) {
  its.contacts.forget();
  its.local_points.forget();
  its.element_contacts.forget();
  its.events.forget();
  its.impacts.forget();
  its.sleep_changes.forget();
  its.islands.forget();
  its.island_parts.forget();
  tell_findings(its);
  return ABUT_OK;
}

abut_status step(abut_universe& its, double dt) {
  const auto done = its.universe.step(dt);
  return done ? forget_lent(its) : refuse(done.error());
}

abut_status check_ids(const abut::Universe& universe, std::string_view name, std::span<const abut_geometry_id> ids) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!exists(universe, ids[i])) {
      return refuse_stale({name, i}, ids[i]);
    }
  }
  return ABUT_OK;
}

abut_status detect_pairs(abut_universe& its, std::span<const abut_geometry_id> a, std::span<const abut_geometry_id> b) {
  abut_status status = check_ids(its.universe, "a", a);
  status = status != ABUT_OK ? status : check_ids(its.universe, "b", b);
  if (status != ABUT_OK) {
    return status;
  }
  std::vector<std::pair<abut::GeometryId, abut::GeometryId>> pairs;
  pairs.reserve(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    pairs.emplace_back(to_geometry(a[i]), to_geometry(b[i]));
  }
  const auto done = its.universe.detect_pairs(pairs);
  return done ? forget_lent(its) : refuse(done.error());
}

// Sides may be infinite: half of the world is a region.
abut_status check_side(std::string_view axis, double minimum, double maximum) {
  for (const auto& [name, value] : {std::pair{".minimum", minimum}, std::pair{".maximum", maximum}}) {
    if (std::isnan(value)) {
      return refuse(error_about(abut::Errc::not_finite, "region" + std::string(name) + std::string(axis), value,
                                "a number or infinite"));
    }
  }
  if (minimum > maximum) {
    return refuse(error_about(abut::Errc::invalid_argument, "region.minimum" + std::string(axis), minimum,
                              "at most region.maximum" + std::string(axis) + ", which is " + abut::to_text(maximum)));
  }
  return ABUT_OK;
}

abut_status detect_region(abut_universe& its, const abut_aabb& region) {
  abut_status status = check_side(".x", region.minimum.x, region.maximum.x);
  status = status != ABUT_OK ? status : check_side(".y", region.minimum.y, region.maximum.y);
  status = status != ABUT_OK ? status : check_side(".z", region.minimum.z, region.maximum.z);
  if (status != ABUT_OK) {
    return status;
  }
  const auto done = its.universe.detect_region({to_vec3(region.minimum), to_vec3(region.maximum)});
  return done ? forget_lent(its) : refuse(done.error());
}

abut_status write_stats(const abut::StepStats& stats, abut_step_stats* out) {
  if (const abut_status status = check_struct_size({"out"}, *out); status != ABUT_OK) {
    return status;
  }
  write_struct({sizeof(abut_step_stats),
                0,
                stats.parts,
                stats.geometries,
                stats.parked,
                stats.moved,
                stats.candidate_pairs,
                stats.filtered_pairs,
                stats.examined_pairs,
                stats.kept_pairs,
                stats.touching_pairs,
                stats.contacts,
                stats.unsupported_pairs,
                stats.events,
                stats.bytes,
                stats.refresh_microseconds,
                stats.broadphase_microseconds,
                stats.pair_microseconds,
                stats.narrowphase_microseconds,
                stats.contact_microseconds,
                stats.asleep},
               out);
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_step(abut_universe* universe, double dt) {
  return guard(universe, [&](abut_universe& its) { return step(its, dt); });
}

abut_status abut_universe_detect_all(abut_universe* universe) {
  return guard(universe, [](abut_universe& its) {
    its.universe.detect_all();
    return forget_lent(its);
  });
}

abut_status abut_universe_detect_changed(abut_universe* universe) {
  return guard(universe, [](abut_universe& its) {
    its.universe.detect_changed();
    return forget_lent(its);
  });
}

abut_status abut_universe_detect_pairs(abut_universe* universe, const abut_geometry_id* a, const abut_geometry_id* b,
                                       size_t count) {
  return guard(universe, [&](abut_universe& its) {
    std::span<const abut_geometry_id> first, second;
    abut_status status = read_span("a", a, "count", count, first);
    status = status != ABUT_OK ? status : read_span("b", b, "count", count, second);
    return status != ABUT_OK ? status : detect_pairs(its, first, second);
  });
}

abut_status abut_universe_detect_region(abut_universe* universe, const abut_aabb* region) {
  return guard(universe, [&](abut_universe& its) {
    const abut_status status = check_not_null("region", region);
    return status != ABUT_OK ? status : detect_region(its, *region);
  });
}

abut_status abut_universe_refresh(abut_universe* universe) {
  return guard(universe, [](abut_universe& its) {
    its.universe.refresh();
    return abut_status{ABUT_OK};
  });
}

abut_status abut_universe_hash(const abut_universe* universe, uint64_t* out) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    if (status == ABUT_OK) {
      *out = its.universe.hash();
    }
    return status;
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
