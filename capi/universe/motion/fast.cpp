// SPDX-License-Identifier: Apache-2.0
// What fast geometries touch on their paths.
#include "options.hpp"
#include "universe/geometries/shape_change.hpp"
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

namespace {

abut_step_impact from_impact(const abut::StepImpact& impact) {
  return {from_geometry(impact.geometry_a),
          from_geometry(impact.geometry_b),
          impact.lower,
          impact.upper,
          impact.first_contact,
          impact.contact_count,
          impact.is_undecided ? 1u : 0u,
          0};
}

}  // namespace

abut_status abut_universe_impacts(const abut_universe* universe, const abut_step_impact** impacts, size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_none_null<2>({{{"impacts", impacts}, {"count", count}}});
    if (status == ABUT_OK) {
      const std::span<const abut_step_impact> lent = its.impacts.get(its.universe.impacts(), from_impact);
      *impacts = lent.data();
      *count = lent.size();
    }
    return status;
  });
}

abut_status abut_universe_advance_to_first_impact(abut_universe* universe, double dt, abut_step_impact* out) {
  return guard(universe, [&](abut_universe& its) {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    std::vector<abut_geometry_id> leading;
    for (const abut::GeometryId geometry : its.universe.geometries_that_lead()) {
      leading.push_back(from_geometry(geometry));
    }
    return change_shapes(its, leading, [&]() -> abut::Result<void> {
      const auto first = its.universe.advance_to_first_impact(dt);
      if (!first) {
        return first.error();
      }
      *out = from_impact(first.value());
      return {};
    });
  });
}
