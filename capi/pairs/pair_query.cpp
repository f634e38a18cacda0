// SPDX-License-Identifier: Apache-2.0
#include "pairs/pair_query.hpp"

namespace abut::capi {
namespace {

constexpr std::array<std::string_view, 6> algorithm_names{"ABUT_ALGORITHM_AUTO",       "ABUT_ALGORITHM_ANALYTIC",
                                                          "ABUT_ALGORITHM_SAT",        "ABUT_ALGORITHM_GJK_EPA",
                                                          "ABUT_ALGORITHM_LIBCCD_GJK", "ABUT_ALGORITHM_LIBCCD_MPR"};

}  // namespace

abut_status read_given_options(const abut_query_options& options, PairQuery& query) {
  abut_status status = check_query_options(options);
  if (status == ABUT_OK && !is_coordinate(options.margin)) {
    status = to_status(check_finite("options.margin", options.margin));
  }
  if (status != ABUT_OK) {
    return status;
  }
  query.settings.algorithm = static_cast<Algorithm>(options.algorithm);
  if (options.error_bound > 0) {
    query.settings.error_bound = options.error_bound;
  }
  query.settings.margin = options.margin;
  query.settings.welds = (options.flags & ABUT_QUERY_WELDS) != 0;
  query.max_contacts = options.max_contacts;
  query.max_pair_contacts = options.max_pair_contacts;
  query.threads = options.threads;
  return ABUT_OK;
}

abut_status read_given_options(const abut_query_options& options, Question question, const abut_shape* a,
                               const abut_shape* b, PairQuery& query) {
  const abut_status status = read_given_options(options, query);
  if (status == ABUT_OK && options.time_budget > 0) {
    take_route(question, kind_in_pairs(shape_of(a)), kind_in_pairs(shape_of(b)), options.time_budget, query.settings);
  }
  return status;
}

abut_status check_query_options(const abut_query_options& options) {
  if (const abut_status status = check_struct_size({"options"}, options); status != ABUT_OK) {
    return status;
  }
  if (const abut_status status = check_value({"options"}, ".algorithm", options.algorithm, ABUT_ALGORITHM_LIBCCD_MPR);
      status != ABUT_OK) {
    return status;
  }
  if (!(options.error_bound >= 0 && options.error_bound <= largest_coordinate)) {
    return to_status(check_not_negative("options.error_bound", options.error_bound));
  }
  if (!(options.time_budget >= 0 && options.time_budget <= largest_coordinate)) {
    return to_status(check_not_negative("options.time_budget", options.time_budget));
  }
  const abut_status status = check_threads(options.threads);
  return status != ABUT_OK ? status : check_bits({"options"}, ".flags", options.flags, ABUT_QUERY_WELDS);
}

abut_status refuse_outcome(Outcome outcome, const abut_shape* a, const abut_shape* b, Algorithm algorithm) {
  // Before words, whose memory may be refused: an answer has been given.
  if (outcome == Outcome::ok) {
    return ABUT_OK;
  }
  const std::string pair =
      std::string(kind_name(kind_of(shape_of(a)))) + " and " + std::string(kind_name(kind_of(shape_of(b))));
  const std::string with(algorithm_names[static_cast<std::size_t>(algorithm)]);
  if (outcome == Outcome::unsupported && algorithm == Algorithm::automatic) {
    return refuse(ABUT_UNSUPPORTED, "there is no algorithm for " + pair);
  }
  switch (outcome) {
    case Outcome::apart:
      return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + with +
                                          ", which only tells how deep shapes overlap; this " + pair + " are apart");
    case Outcome::unsupported:
      return refuse(ABUT_UNSUPPORTED, "options.algorithm is " + with + "; there is no such way for " + pair);
    case Outcome::not_converged: return refuse(ABUT_NOT_CONVERGED, with + " gave up on " + pair);
    case Outcome::ok: break;
  }
  return ABUT_OK;
}

}  // namespace abut::capi
