// SPDX-License-Identifier: Apache-2.0
// Measured routes of pairs of kinds, and which of them a time budget takes.
#include "guard.hpp"
#include "pairs/pair_query.hpp"

import abut.capability;
import abut.core;
import abut.pairs.any_shape;
import abut.pairs.two_shapes.measured_routes;

using namespace abut::capi;

static_assert(static_cast<abut_query>(abut::Question::distance) == ABUT_QUERY_DISTANCE);
static_assert(static_cast<abut_query>(abut::Question::contacts) == ABUT_QUERY_CONTACTS);

namespace {

abut_route from_route(const abut::MeasuredRoute& route, const abut_query_options& options) {
  const bool is_in_time = options.time_budget == 0 || route.seconds <= options.time_budget;
  const bool is_in_bound = options.error_bound == 0 || route.worst_error <= options.error_bound;
  return {static_cast<abut_algorithm>(route.algorithm),
          (is_in_time ? ABUT_ROUTE_IN_TIME : 0U) | (is_in_bound ? ABUT_ROUTE_IN_BOUND : 0U), route.error_bound,
          route.seconds, route.worst_error};
}

// The routes of checked kinds, by their places among kinds in pairs.
void tell_routes(abut::Question question, std::size_t kind_a, std::size_t kind_b, const abut_query_options& options,
                 std::span<abut_route> out, std::size_t& count) {
  const std::span<const abut::MeasuredRoute> routes = abut::measured_routes(question, kind_a, kind_b);
  fill(routes, out, [&](const abut::MeasuredRoute& route) { return from_route(route, options); });
  const bool may_choose = options.time_budget > 0 && options.algorithm == ABUT_ALGORITHM_AUTO;
  const auto chosen =
      may_choose ? abut::choose_route(routes, {options.time_budget, options.error_bound}) : std::nullopt;
  if (chosen && *chosen < out.size()) {
    out[*chosen].flags |= ABUT_ROUTE_CHOSEN;
  }
  count = routes.size();
}

}  // namespace

abut_status abut_pair_routes(abut_shape_kind kind_a, abut_shape_kind kind_b, abut_query query,
                             const abut_query_options* options, abut_route* routes, size_t capacity, size_t* count) {
  return guard([&]() -> abut_status {
    const abut_query_options& asked = options == nullptr ? default_query_options : *options;
    std::span<abut_route> out;
    abut_status status = check_not_null("count", count);
    status = status != ABUT_OK ? status : read_span("routes", routes, "capacity", capacity, out);
    PairQuery query_of_options;
    status = status != ABUT_OK ? status : read_given_options(asked, query_of_options);
    status = status != ABUT_OK ? status : check_value({"query"}, "", query, ABUT_QUERY_CONTACTS);
    if (status != ABUT_OK) {
      return status;
    }
    const auto place_a = abut::find_kind(kind_a), place_b = abut::find_kind(kind_b);
    if (!place_a || !place_b) {
      return refuse(abut::error_about(abut::Errc::unknown_value, place_a ? "kind_b" : "kind_a",
                                      std::uint64_t{place_a ? kind_b : kind_a}, "a kind of this build"));
    }
    tell_routes(static_cast<abut::Question>(query), abut::kind_in_pairs(*place_a), abut::kind_in_pairs(*place_b), asked,
                out, *count);
    return ABUT_OK;
  });
}

abut_status abut_routes_load(const char* text) {
  return guard([&]() -> abut_status {
    if (text == nullptr) {
      abut::restore_routes();
      return ABUT_OK;
    }
    return to_status(abut::load_routes(std::string_view(text)));
  });
}
