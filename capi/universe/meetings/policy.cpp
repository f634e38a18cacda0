// SPDX-License-Identifier: Apache-2.0
// How the pairs of two tags are treated.
#include "options.hpp"
#include "universe/universe_handle.hpp"

import abut.capability;
import abut.core;
import abut.universe;

using namespace abut::capi;

static_assert(static_cast<abut_detail>(abut::Detail::manifold) == ABUT_DETAIL_MANIFOLD);
static_assert(static_cast<abut_detail>(abut::Detail::point) == ABUT_DETAIL_POINT);
static_assert(static_cast<abut_detail>(abut::Detail::box) == ABUT_DETAIL_BOX);
static_assert(static_cast<abut_detail>(abut::Detail::touch) == ABUT_DETAIL_TOUCH);
static_assert(static_cast<abut_detail>(abut::Detail::elements) == ABUT_DETAIL_ELEMENTS);

namespace {

constexpr abut_policy default_policy{sizeof(abut_policy),
                                     ABUT_ALGORITHM_AUTO,
                                     ABUT_DETAIL_MANIFOLD,
                                     1,
                                     -1,
                                     0,
                                     ABUT_CLOSEST_FEATURES,
                                     0,
                                     0,
                                     0,
                                     0,
                                     0,
                                     0,
                                     0.5,
                                     0};
constexpr std::uint32_t all_kinds = 15;

abut_status check_tags(std::uint32_t tag_a, std::uint32_t tag_b) {
  const abut_status status = check_tag({"tag_a"}, "", tag_a);
  return status != ABUT_OK ? status : check_tag({"tag_b"}, "", tag_b);
}

abut_status check_policy(const abut_policy& policy) {
  const Where where{"policy"};
  abut_status status = check_struct_size(where, policy);
  status = status != ABUT_OK ? status : check_value(where, ".algorithm", policy.algorithm, ABUT_ALGORITHM_LIBCCD_MPR);
  status = status != ABUT_OK ? status : check_value(where, ".detail", policy.detail, ABUT_DETAIL_ELEMENTS);
  status = status != ABUT_OK ? status : check_value(where, ".method", policy.method, ABUT_CLOSEST_LOCAL_MINIMA);
  status = status != ABUT_OK ? status : check_bits(where, ".kinds", policy.kinds, all_kinds);
  status = status != ABUT_OK ? status : check_bits(where, ".flags", policy.flags, ABUT_ELEMENTS_FRONTS_ONLY);
  return status != ABUT_OK ? status : check_reserved(where, policy.reserved);
}

abut_status check_has_elements(const abut::Universe& universe, const abut_policy& policy) {
  if (policy.detail != ABUT_DETAIL_ELEMENTS) {
    return ABUT_OK;
  }
  if (!abut::finds_elements) {
    return refuse(ABUT_UNSUPPORTED,
                  "policy.detail is ABUT_DETAIL_ELEMENTS (4), and this build of abut is without the feature "
                  "\"deforming\"");
  }
  return universe.tolerance_mode() == abut::ToleranceMode::margin
             ? static_cast<abut_status>(ABUT_OK)
             : refuse(ABUT_UNSUPPORTED,
                      "policy.detail is ABUT_DETAIL_ELEMENTS (4), which takes a universe with ABUT_TOLERANCE_MARGIN");
}

abut::Policy to_policy(const abut_policy& policy) {
  return {static_cast<abut::Algorithm>(policy.algorithm),
          static_cast<abut::Detail>(policy.detail),
          policy.period,
          policy.tolerance,
          policy.error_bound,
          policy.time_budget,
          {policy.method, policy.kinds, (policy.flags & ABUT_ELEMENTS_FRONTS_ONLY) != 0, policy.contact_distance,
           policy.rest_distance, policy.cone_angle, policy.cone_factor}};
}

abut_status set(abut_universe& its, std::uint32_t tag_a, std::uint32_t tag_b, const abut_policy& policy) {
  abut_status status = check_policy(policy);
  status = status != ABUT_OK ? status : check_has_elements(its.universe, policy);
  status = status != ABUT_OK ? status : check_tags(tag_a, tag_b);
  if (status != ABUT_OK) {
    return status;
  }
  const auto done = its.universe.set_policy(tag_a, tag_b, to_policy(policy));
  return done ? static_cast<abut_status>(ABUT_OK) : refuse_field({"policy"}, done.error());
}

abut_status get(const abut_universe& its, std::uint32_t tag_a, std::uint32_t tag_b, abut_policy* out) {
  abut_status status = check_struct_size({"out"}, *out);
  status = status != ABUT_OK ? status : check_tags(tag_a, tag_b);
  if (status != ABUT_OK) {
    return status;
  }
  const auto found = its.universe.policy(tag_a, tag_b);
  if (!found) {
    return refuse(found.error());
  }
  const abut::Policy& policy = found.value();
  const abut::ElementRule& elements = policy.elements;
  write_struct(
      {sizeof(abut_policy), static_cast<abut_algorithm>(policy.algorithm), static_cast<abut_detail>(policy.detail),
       policy.period, policy.tolerance, policy.error_bound, elements.method, elements.kinds,
       elements.is_front_only ? abut_elements_flags{ABUT_ELEMENTS_FRONTS_ONLY} : 0, 0, elements.contact_distance,
       elements.rest_distance, elements.cone_angle, elements.cone_factor, policy.time_budget},
      out);
  return ABUT_OK;
}

}  // namespace

void abut_policy_init(abut_policy* policy, uint32_t struct_size) { fill_defaults(default_policy, struct_size, policy); }

abut_status abut_policy_set(abut_universe* universe, uint32_t tag_a, uint32_t tag_b, const abut_policy* policy) {
  return guard(universe, [&](abut_universe& its) {
    return set(its, tag_a, tag_b, policy == nullptr ? default_policy : *policy);
  });
}

abut_status abut_policy_get(const abut_universe* universe, uint32_t tag_a, uint32_t tag_b, abut_policy* out) {
  return guard(universe, [&](const abut_universe& its) {
    const abut_status status = check_not_null("out", out);
    return status != ABUT_OK ? status : get(its, tag_a, tag_b, out);
  });
}
