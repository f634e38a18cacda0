// SPDX-License-Identifier: Apache-2.0
#include "explain_pair.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "algorithms.hpp"
#include "commands.hpp"
#include "explain_routes.hpp"
#include "failures.hpp"
#include "output_file.hpp"
#include "placed.hpp"

namespace cli {
namespace {

struct Ask {
  std::string name;
  abut_algorithm algorithm = ABUT_ALGORITHM_AUTO;
  double error_bound = 0;
  bool with_memory = false;
};

struct Answer {
  std::string name;
  abut_distance distance{};
  double microseconds = 0;
  std::string refusal;  // empty where there is an answer
};

// The one geometry that a name means.
Placed find_one(const World& world, const std::string& name) {
  std::vector<Placed> found = find_placed(world, name);
  if (found.size() > 1) {
    throw BadInput("'" + name + "' has " + std::to_string(found.size()) +
                   " geometries; expected PART/GEOMETRY, such as " + found.front().name);
  }
  return std::move(found.front());
}

std::vector<Ask> all_asks() {
  std::vector<Ask> asks{{.name = "default"}, {.name = "with a memory", .with_memory = true}};
  for (const auto& [name, bound] : {std::pair{"error_bound 1e-3", 1e-3}, std::pair{"error_bound 1e-6", 1e-6},
                                    std::pair{"error_bound 1e-9", 1e-9}, std::pair{"error_bound 1e-12", 1e-12}}) {
    asks.push_back({.name = name, .error_bound = bound});
  }
  for (const Choice& algorithm : std::span(algorithms).subspan(1)) {
    asks.push_back({.name = "algorithm " + std::string(algorithm.name), .algorithm = algorithm.value});
  }
  return asks;
}

// The least time of several, since others may have the processor meanwhile.
Answer answer(const Ask& ask, const Placed& a, const Placed& b) {
  constexpr int repeats = 200;
  abut_query_options options;
  abut_query_options_init(&options, sizeof options);
  options.algorithm = ask.algorithm;
  options.error_bound = ask.error_bound;
  abut_pair_memory memory{};
  Answer found{.name = ask.name, .microseconds = std::numeric_limits<double>::infinity(), .refusal = {}};
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const abut_status status =
        ask.with_memory
            ? abut_pair_distance_with_memory(a.shape, &a.pose, b.shape, &b.pose, &options, &memory, &found.distance)
            : abut_pair_distance(a.shape, &a.pose, b.shape, &b.pose, &options, &found.distance);
    const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
    if (status != ABUT_OK) {
      found.refusal = abut_last_error_message();
      return found;
    }
    found.microseconds = std::min(found.microseconds, elapsed.count());
  }
  return found;
}

std::size_t count_contacts(const Placed& a, const Placed& b) {
  std::size_t count = 0;
  check(abut_pair_contacts(a.shape, &a.pose, b.shape, &b.pose, nullptr, nullptr, 0, &count), "contacts of the pair");
  return count;
}

std::string table_of(const Placed& a, const Placed& b, const std::vector<Answer>& answers) {
  std::string text = shown(a) + " and " + shown(b) + ": " + std::to_string(count_contacts(a, b)) + " contacts\n";
  std::array<char, 256> line{};
  const auto add = [&](int length) { text.append(line.data(), static_cast<std::size_t>(std::max(length, 0))); };
  add(std::snprintf(line.data(), line.size(), "%-24s %-22s %-24s %-24s %10s %10s\n", "distance", "by", "lower", "upper",
                    "steps", "us"));
  for (const Answer& each : answers) {
    if (!each.refusal.empty()) {
      text += each.name + std::string(each.name.size() < 25 ? 25 - each.name.size() : 1, ' ') + each.refusal + "\n";
      continue;
    }
    const abut_distance& found = each.distance;
    add(std::snprintf(line.data(), line.size(), "%-24s %-22s %-24.17g %-24.17g %10u %10.3f\n", each.name.c_str(),
                      algorithm_name(found.algorithm).c_str(), found.lower, found.upper, found.iterations,
                      each.microseconds));
  }
  return text;
}

std::string json_of(const Placed& a, const Placed& b, const std::vector<Answer>& answers, const PairRoutes& routes) {
  nlohmann::ordered_json json{{"a", {{"name", a.name}, {"kind", kind_name(a.shape)}}},
                              {"b", {{"name", b.name}, {"kind", kind_name(b.shape)}}},
                              {"contacts", count_contacts(a, b)},
                              {"distances", nlohmann::ordered_json::array()}};
  for (const Answer& each : answers) {
    if (!each.refusal.empty()) {
      json["distances"].push_back({{"ask", each.name}, {"refusal", each.refusal}});
      continue;
    }
    json["distances"].push_back({{"ask", each.name},
                                 {"by", algorithm_name(each.distance.algorithm)},
                                 {"lower", each.distance.lower},
                                 {"upper", each.distance.upper},
                                 {"steps", each.distance.iterations},
                                 {"microseconds", each.microseconds}});
  }
  json["routes"] = json_of(routes);
  return json.dump(2) + "\n";
}

}  // namespace

void explain_pair(const Arguments& arguments) {
  const World world = world_at_last_step(arguments);
  const Placed a = find_one(world, arguments.operands[1]), b = find_one(world, arguments.operands[2]);
  std::vector<Answer> answers;
  for (const Ask& ask : all_asks()) {
    answers.push_back(answer(ask, a, b));
  }
  if (!answers.front().refusal.empty()) {
    throw BadInput(a.name + " and " + b.name + ": " + answers.front().refusal);
  }
  const PairRoutes routes = routes_of(arguments, a, b);
  print(arguments.json ? json_of(a, b, answers, routes) : table_of(a, b, answers) + text_of(routes));
}

}  // namespace cli
