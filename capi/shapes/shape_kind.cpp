// SPDX-License-Identifier: Apache-2.0
// Which kinds of shapes this build has, and what pairs of them answer.
#include "border.hpp"
#include "guard.hpp"
#include "options.hpp"

import abut.pairs.any_shape;

using namespace abut::capi;

size_t abut_shape_kind_count(void) { return abut::named_kind_count; }

abut_shape_kind abut_shape_kind_at(size_t index) {
  return index < abut::named_kind_count ? abut::kind_number(index) : abut_shape_kind{0};
}

abut_shape_kind abut_shape_kind_by_name(const char* name) {
  const auto place = name == nullptr ? std::nullopt : abut::find_kind(std::string_view(name));
  return place ? abut::kind_number(*place) : abut_shape_kind{0};
}

const char* abut_shape_kind_name(abut_shape_kind kind) {
  const auto place = abut::find_kind(kind);
  return place ? c_string(abut::kind_name(*place)) : nullptr;
}

size_t abut_shape_kind_parameter_count(abut_shape_kind kind) {
  const auto place = abut::find_kind(kind);
  return place ? abut::kind_parameter_count(*place) : 0;
}

const char* abut_shape_kind_parameter_name(abut_shape_kind kind, size_t index) {
  const auto place = abut::find_kind(kind);
  return place && index < abut::kind_parameter_count(*place) ? c_string(abut::kind_parameter_name(*place, index))
                                                             : nullptr;
}

abut_status abut_pair_support(abut_shape_kind kind_a, abut_shape_kind kind_b, abut_query query, uint32_t* out) {
  return guard([&]() -> abut_status {
    if (const abut_status status = check_not_null("out", out); status != ABUT_OK) {
      return status;
    }
    const auto place_a = abut::find_kind(kind_a), place_b = abut::find_kind(kind_b);
    if (!place_a || !place_b) {
      return refuse(abut::error_about(abut::Errc::unknown_value, place_a ? "kind_b" : "kind_a",
                                      std::uint64_t{place_a ? kind_b : kind_a}, "a kind of this build"));
    }
    if (query > ABUT_QUERY_CONTACTS) {
      return refuse(abut::error_about(abut::Errc::unknown_value, "query", std::uint64_t{query}, "at most 1"));
    }
    // Whatever has a route answers both queries.
    *out = abut::is_supported(abut::kind_in_pairs(*place_a), abut::kind_in_pairs(*place_b)) ? 1 : 0;
    return ABUT_OK;
  });
}
