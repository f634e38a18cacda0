// SPDX-License-Identifier: Apache-2.0
#include "explain_routes.hpp"

#include <algorithm>
#include <cstdio>

#include "algorithms.hpp"
#include "failures.hpp"
#include "tune.hpp"

namespace cli {
namespace {

constexpr std::array question_names{"distance", "contacts"};

bool is_chosen(const abut_route& route) { return (route.flags & ABUT_ROUTE_CHOSEN) != 0; }

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

std::vector<abut_route> ask(abut_query query, const abut_query_options& options, const Placed& a, const Placed& b) {
  const abut_shape_kind kind_a = abut_shape_kind_of(a.shape), kind_b = abut_shape_kind_of(b.shape);
  std::size_t count = 0;
  check(abut_pair_routes(kind_a, kind_b, query, &options, nullptr, 0, &count), "routes of the pair");
  std::vector<abut_route> routes(count);
  check(abut_pair_routes(kind_a, kind_b, query, &options, routes.data(), routes.size(), &count), "routes of the pair");
  return routes;
}

// What the options take of some routes, and why.
std::string choice_of(const std::vector<abut_route>& routes, double error_bound, double time_budget) {
  const std::string bound = error_bound > 0 ? "an error bound of " + number(error_bound) : "no error bound";
  if (routes.empty()) {
    return "nobody has measured this pair of kinds: the default";
  }
  if (time_budget == 0) {
    return "no time budget: the default, with " + bound;
  }
  const std::string wish = "a time budget of " + number(time_budget) + " s and " + bound;
  const auto chosen = std::ranges::find_if(routes, is_chosen);
  if (chosen == routes.end()) {
    return wish + ": nothing keeps the bound by measure, so the default with that bound";
  }
  const std::string taken = algorithm_name(chosen->algorithm) + " with " +
                            (error_bound > 0           ? "the error bound that is asked for"
                             : chosen->error_bound > 0 ? "an error bound of " + number(chosen->error_bound)
                                                       : "the default error bound");
  if ((chosen->flags & ABUT_ROUTE_IN_TIME) != 0) {
    return wish + ": " + taken;
  }
  const char* const what = error_bound > 0 ? "nothing that keeps the bound fits" : "nothing fits";
  return wish + ": " + what + ", so the cheapest, " + taken;
}

}  // namespace

PairRoutes routes_of(const Arguments& arguments, const Placed& a, const Placed& b) {
  if (!arguments.routes.empty() && abut_routes_load(read_routes(arguments.routes).c_str()) != ABUT_OK) {
    throw BadInput(arguments.routes + ": " + abut_last_error_message());
  }
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.error_bound = arguments.error_bound;
  options.time_budget = arguments.time_budget;
  PairRoutes routes{{}, options.error_bound, options.time_budget};
  for (const abut_query query : {ABUT_QUERY_DISTANCE, ABUT_QUERY_CONTACTS}) {
    routes.of.at(query) = ask(query, options, a, b);
  }
  return routes;
}

std::string text_of(const PairRoutes& routes) {
  std::string text;
  for (std::size_t query = 0; query < routes.of.size(); ++query) {
    std::array<char, 256> line{};
    const auto add = [&](int length) { text.append(line.data(), static_cast<std::size_t>(std::max(length, 0))); };
    add(std::snprintf(line.data(), line.size(), "%-24s %-22s %-24s %-24s %10s\n",
                      (std::string("measured, ") + question_names.at(query)).c_str(), "by", "error bound",
                      "worst error promised", "us"));
    for (const abut_route& route : routes.of.at(query)) {
      add(std::snprintf(line.data(), line.size(), "%-24s %-22s %-24s %-24g %10.3f\n", is_chosen(route) ? "taken" : "",
                        algorithm_name(route.algorithm).c_str(),
                        route.error_bound > 0 ? number(route.error_bound).c_str() : "default", route.worst_error,
                        1e6 * route.seconds));
    }
    text += choice_of(routes.of.at(query), routes.error_bound, routes.time_budget) + "\n";
  }
  return text;
}

nlohmann::ordered_json json_of(const PairRoutes& routes) {
  nlohmann::ordered_json json{{"error_bound", routes.error_bound}, {"time_budget", routes.time_budget}};
  for (std::size_t query = 0; query < routes.of.size(); ++query) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const abut_route& route : routes.of.at(query)) {
      list.push_back({{"by", algorithm_name(route.algorithm)},
                      {"error_bound", route.error_bound},
                      {"worst_error", route.worst_error},
                      {"seconds", route.seconds},
                      {"taken", is_chosen(route)},
                      {"in_time", (route.flags & ABUT_ROUTE_IN_TIME) != 0},
                      {"in_bound", (route.flags & ABUT_ROUTE_IN_BOUND) != 0}});
    }
    json[question_names.at(query)] = {
        {"routes", list}, {"choice", choice_of(routes.of.at(query), routes.error_bound, routes.time_budget)}};
  }
  return json;
}

}  // namespace cli
