// SPDX-License-Identifier: Apache-2.0
// What is odd about a scene.
#include "universe/universe_handle.hpp"

import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_finding_code>(abut::FindingCode::nothing_moves) == ABUT_FINDING_NOTHING_MOVES);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::meets_nothing) == ABUT_FINDING_MEETS_NOTHING);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::kinds_unsupported) == ABUT_FINDING_KINDS_UNSUPPORTED);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::tolerance_too_large) ==
              ABUT_FINDING_TOLERANCE_TOO_LARGE);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::far_from_origin) == ABUT_FINDING_FAR_FROM_ORIGIN);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::excluded_from_all) == ABUT_FINDING_EXCLUDED_FROM_ALL);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::rule_disables_all) == ABUT_FINDING_RULE_DISABLES_ALL);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::exclusion_in_common) ==
              ABUT_FINDING_EXCLUSION_IN_COMMON);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::filter_keeps_none) == ABUT_FINDING_FILTER_KEEPS_NONE);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::all_parked) == ABUT_FINDING_ALL_PARKED);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::all_on_one_part) == ABUT_FINDING_ALL_ON_ONE_PART);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::inside_out) == ABUT_FINDING_INSIDE_OUT);
static_assert(static_cast<abut_finding_code>(abut::FindingCode::hollow) == ABUT_FINDING_HOLLOW);

namespace {

abut_finding from_finding(const abut::Finding& its) {
  abut_finding out{
      static_cast<abut_finding_code>(its.code), 0, from_geometry(its.geometry), from_geometry(its.other), {}};
  const std::span<char> message(out.message);
  std::copy_n(its.message.begin(), std::min(its.message.size(), message.size() - 1), message.begin());
  return out;
}

abut_status validate(const abut::Universe& universe, std::span<abut_finding> out, std::size_t* count) {
  const std::vector<abut::Finding> found = universe.validate();
  fill(std::span<const abut::Finding>(found), out, from_finding);
  *count = found.size();
  return ABUT_OK;
}

}  // namespace

abut_status abut_universe_validate(const abut_universe* universe, abut_finding* findings, size_t capacity,
                                   size_t* count) {
  return guard(universe, [&](const abut_universe& its) {
    std::span<abut_finding> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("findings", findings, "capacity", capacity, out);
    return status != ABUT_OK ? status : validate(its.universe, out, count);
  });
}
