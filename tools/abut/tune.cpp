// SPDX-License-Identifier: Apache-2.0
// Errors are judged by the answers of abut itself at a tiny error bound, which the tests judge by an oracle. Times are
// the least of several, since others may have the processor meanwhile.
#include "tune.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include "algorithms.hpp"
#include "output_file.hpp"
#include "tune_pairs.hpp"

namespace cli {
namespace {

constexpr std::size_t case_count = 1024, timed_count = 128, repetitions = 9;
constexpr std::array bounds{0.0, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12};
constexpr double tiny_bound = 1e-15;
// Below this an answer is exact but for rounding, of which the size has 52 bits.
constexpr double exact = 2e-14;

struct Answer {
  double distance = 0, lower = 0, upper = 0;

  friend bool operator==(const Answer&, const Answer&) = default;
};

struct Route {
  abut_query_options options{};
  std::vector<Answer> answers;  // to the cases of its question
  double seconds = 0, worst_error = 0;
};

// One question, about some pairs. The deepest contact tells nothing about pairs that are apart.
struct Asked {
  abut_query query;
  std::vector<TunedPair> pairs;
  std::vector<std::span<const TunedPair>> timed;  // the mean of which counts
};

bool ask(abut_query query, const TunedPair& pair, const abut_query_options& options, Answer& out) {
  if (query == ABUT_QUERY_DISTANCE) {
    abut_distance found;
    const bool is_ok = abut_pair_distance(pair.a, &pair.pose_a, pair.b, &pair.pose_b, &options, &found) == ABUT_OK;
    out = {found.distance, found.lower, found.upper};
    return is_ok;
  }
  std::array<abut_contact, 8> found;
  std::size_t count = 0;
  const abut_status status =
      abut_pair_contacts(pair.a, &pair.pose_a, pair.b, &pair.pose_b, &options, found.data(), found.size(), &count);
  out = {found[0].distance, found[0].distance, found[0].distance};
  return status == ABUT_OK && count > 0;
}

abut_query_options options_of(abut_algorithm algorithm, double error_bound) {
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = algorithm;
  options.error_bound = error_bound;
  return options;
}

bool answers_all(const Asked& asked, Route& route) {
  route.answers.resize(asked.pairs.size());
  for (std::size_t i = 0; i < asked.pairs.size(); ++i) {
    if (!ask(asked.query, asked.pairs[i], route.options, route.answers[i])) {
      return false;
    }
  }
  return true;
}

// Those that answer every case, each of two that answer the same bits once.
std::vector<Route> distinct_routes(const Asked& asked) {
  std::vector<Route> routes;
  for (const abut_algorithm algorithm :
       {ABUT_ALGORITHM_AUTO, ABUT_ALGORITHM_ANALYTIC, ABUT_ALGORITHM_SAT, ABUT_ALGORITHM_GJK_EPA}) {
    for (const double bound : bounds) {
      Route route{options_of(algorithm, bound), {}};
      const auto is_same = [&](const Route& other) { return other.answers == route.answers; };
      if (answers_all(asked, route) && std::ranges::none_of(routes, is_same)) {
        routes.push_back(std::move(route));
      }
    }
  }
  return routes;
}

double seconds_of(abut_query query, std::span<const TunedPair> pairs, const abut_query_options& options) {
  Answer answer;
  const auto start = std::chrono::steady_clock::now();
  for (const TunedPair& pair : pairs) {
    static_cast<void>(ask(query, pair, options, answer));
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>(pairs.size());
}

// The repetitions of all routes take turns, so that whatever slows the machine slows all of them.
void measure_times(const Asked& asked, std::vector<Route>& routes) {
  for (const std::span<const TunedPair> pairs : asked.timed) {
    std::vector<double> least(routes.size(), std::numeric_limits<double>::infinity());
    for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
      for (std::size_t i = 0; i < routes.size(); ++i) {
        least[i] = std::min(least[i], seconds_of(asked.query, pairs, routes[i].options));
      }
    }
    for (std::size_t i = 0; i < routes.size(); ++i) {
      routes[i].seconds += least[i] / static_cast<double>(asked.timed.size());
    }
  }
}

// A search that ends by its bound may end anywhere below it, for other pairs than those that were measured. So what is
// promised is the bound itself, or where answers were exact as far as numbers go, a little more than rounding. Nothing
// where a search has not kept its bound.
double promised(double measured, double bound) {
  constexpr double none = std::numeric_limits<double>::infinity();
  return measured <= exact ? 5 * exact : measured <= bound + exact ? bound : none;
}

void judge(const Asked& asked, double usual_bound, std::vector<Route>& routes) {
  std::vector<double> worst(routes.size(), 0);
  const abut_query_options closest = options_of(ABUT_ALGORITHM_AUTO, tiny_bound);
  for (std::size_t i = 0; i < asked.pairs.size(); ++i) {
    Answer truth;
    if (!ask(ABUT_QUERY_DISTANCE, asked.pairs[i], closest, truth)) {
      throw Failure("a pair of shapes has no distance: " + std::string(abut_last_error_message()));
    }
    for (std::size_t k = 0; k < routes.size(); ++k) {
      const Answer& its = routes[k].answers[i];
      const double error = std::max(std::abs(its.distance - truth.distance), its.upper - its.lower);
      worst[k] = std::max(worst[k], error / asked.pairs[i].size);
    }
  }
  for (std::size_t k = 0; k < routes.size(); ++k) {
    const double bound = routes[k].options.error_bound;
    routes[k].worst_error = promised(worst[k], bound > 0 ? bound : usual_bound);
  }
}

// Without those that promise nothing, and those that another one beats. One that errs less beats another also where it
// takes up to a twentieth longer.
void keep_best(std::vector<Route>& routes) {
  constexpr double slack = 1.05;
  std::erase_if(routes, [](const Route& route) { return std::isinf(route.worst_error); });
  std::ranges::sort(routes, {}, [](const Route& route) { return std::pair(route.worst_error, route.seconds); });
  std::vector<Route> kept;
  for (Route& route : routes) {
    const auto is_beaten = [&](const Route& other) {
      return &other != &route && other.worst_error <= route.worst_error &&
             (other.worst_error < route.worst_error ? other.seconds <= slack * route.seconds
                                                    : other.seconds < route.seconds);
    };
    if (std::ranges::none_of(routes, is_beaten)) {
      kept.push_back(route);
    }
  }
  routes = std::move(kept);
}

std::string line_of(const Asked& asked, std::string_view kind_a, std::string_view kind_b, const Route& route) {
  std::array<char, 200> line{};
  const int length =
      std::snprintf(line.data(), line.size(), "%s %s %s %s %g %.3g %.2g\n",
                    asked.query == ABUT_QUERY_DISTANCE ? "distance" : "contacts", std::string(kind_a).c_str(),
                    std::string(kind_b).c_str(), algorithm_name(route.options.algorithm).c_str(),
                    route.options.error_bound, route.seconds, route.worst_error);
  return {line.data(), static_cast<std::size_t>(length)};
}

std::string lines_of(const Asked& asked, std::string_view kind_a, std::string_view kind_b) {
  std::vector<Route> routes = distinct_routes(asked);
  measure_times(asked, routes);
  judge(asked, is_curved(kind_a) || is_curved(kind_b) ? 1e-9 : 1e-12, routes);
  keep_best(routes);
  std::string text;
  for (const Route& route : routes) {
    text += line_of(asked, kind_a, kind_b, route);
  }
  return text;
}

std::vector<Asked> questions_about(const TunedPairs& pairs) {
  const std::span apart(pairs.apart), overlapping(pairs.overlapping);
  std::vector<TunedPair> all = pairs.apart;
  all.insert(all.end(), pairs.overlapping.begin(), pairs.overlapping.end());
  return {{ABUT_QUERY_DISTANCE, all, {apart.first(timed_count), overlapping.first(timed_count)}},
          {ABUT_QUERY_CONTACTS, pairs.overlapping, {overlapping.first(timed_count)}}};
}

// As Linux calls it.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
      return line.substr(line.find(": ") + 2);
    }
  }
  return "unknown processor";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", gmtime_r(&now, &parts));
  return text.data();
}

}  // namespace

void tune(const Arguments& arguments) {
  std::string text = "# abut routes 1\n# " + processor_name() + ", " + today() + ", abut " + abut_version_string() +
                     "\n# question kind kind algorithm error_bound seconds worst_error\n";
  const std::vector<std::string_view> kinds = tuned_kinds();
  std::array<std::string, 2> lines;
  std::uint64_t seed = 0;
  for (std::size_t a = 0; a < kinds.size(); ++a) {
    for (std::size_t b = a; b < kinds.size(); ++b) {
      const TunedPairs pairs = make_pairs(kinds[a], kinds[b], case_count, ++seed);
      for (const Asked& asked : questions_about(pairs)) {
        lines.at(asked.query) += lines_of(asked, kinds[a], kinds[b]);
      }
    }
  }
  OutputFile file(arguments.operands.empty() ? "-" : arguments.operands.front());
  file.write(text + lines[0] + lines[1]);
  file.finish();
}

std::string read_routes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.good() && !file.eof()) {
    throw BadInput(path + " cannot be read; expected a table of routes, as abut tune writes it");
  }
  return text;
}

}  // namespace cli
