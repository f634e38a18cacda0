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

#include "commands.hpp"
#include "failures.hpp"
#include "output_file.hpp"
#include "world.hpp"

namespace cli {
namespace {

struct Placed {
  std::string name;
  const abut_shape* shape;
  abut_pose pose;
};

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

constexpr std::array<const char*, 6> algorithm_names{"auto", "analytic", "sat", "gjk_epa", "libccd_gjk", "libccd_mpr"};

// By the name of a part, of which it is the first geometry, or by PART/GEOMETRY.
Placed find_placed(const World& world, const std::string& name) {
  for (std::size_t i = 0; i < world.scene().geometries.size(); ++i) {
    const Geometry& geometry = world.scene().geometries[i];
    const std::string& part = world.scene().parts[geometry.part].name;
    const std::string whole = part + "/" + geometry.name;
    if (name == part || name == whole) {
      return {whole, geometry.shape, world.pose_of(i)};
    }
  }
  throw BadInput("there is no geometry '" + name + "'; expected the name of a part, or PART/GEOMETRY");
}

std::vector<Ask> all_asks() {
  std::vector<Ask> asks{{.name = "default"}, {.name = "with a memory", .with_memory = true}};
  for (const auto& [name, bound] : {std::pair{"error_bound 1e-3", 1e-3}, std::pair{"error_bound 1e-6", 1e-6},
                                    std::pair{"error_bound 1e-9", 1e-9}, std::pair{"error_bound 1e-12", 1e-12}}) {
    asks.push_back({.name = name, .error_bound = bound});
  }
  for (abut_algorithm algorithm = ABUT_ALGORITHM_ANALYTIC; algorithm <= ABUT_ALGORITHM_LIBCCD_MPR; ++algorithm) {
    asks.push_back({.name = std::string("algorithm ") + algorithm_names.at(algorithm), .algorithm = algorithm});
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

std::string kind_of(const Placed& placed) { return abut_shape_kind_name(abut_shape_kind_of(placed.shape)); }

std::string table_of(const Placed& a, const Placed& b, const std::vector<Answer>& answers) {
  std::string text = a.name + " (" + kind_of(a) + ") and " + b.name + " (" + kind_of(b) +
                     "): " + std::to_string(count_contacts(a, b)) + " contacts\n";
  std::array<char, 256> line{};
  const auto add = [&](int length) { text.append(line.data(), static_cast<std::size_t>(std::max(length, 0))); };
  add(std::snprintf(line.data(), line.size(), "%-24s %-11s %-24s %-24s %10s %10s\n", "distance", "by", "lower", "upper",
                    "steps", "us"));
  for (const Answer& each : answers) {
    if (!each.refusal.empty()) {
      text += each.name + std::string(each.name.size() < 25 ? 25 - each.name.size() : 1, ' ') + each.refusal + "\n";
      continue;
    }
    const abut_distance& found = each.distance;
    add(std::snprintf(line.data(), line.size(), "%-24s %-11s %-24.17g %-24.17g %10u %10.3f\n", each.name.c_str(),
                      algorithm_names.at(found.algorithm), found.lower, found.upper, found.iterations,
                      each.microseconds));
  }
  return text;
}

std::string json_of(const Placed& a, const Placed& b, const std::vector<Answer>& answers) {
  nlohmann::ordered_json json{{"a", {{"name", a.name}, {"kind", kind_of(a)}}},
                              {"b", {{"name", b.name}, {"kind", kind_of(b)}}},
                              {"contacts", count_contacts(a, b)},
                              {"distances", nlohmann::ordered_json::array()}};
  for (const Answer& each : answers) {
    if (!each.refusal.empty()) {
      json["distances"].push_back({{"ask", each.name}, {"refusal", each.refusal}});
      continue;
    }
    json["distances"].push_back({{"ask", each.name},
                                 {"by", algorithm_names.at(each.distance.algorithm)},
                                 {"lower", each.distance.lower},
                                 {"upper", each.distance.upper},
                                 {"steps", each.distance.iterations},
                                 {"microseconds", each.microseconds}});
  }
  return json.dump(2) + "\n";
}

}  // namespace

void explain_pair(const Arguments& arguments) {
  const World world = world_at_last_step(arguments);
  const Placed a = find_placed(world, arguments.geometry_a), b = find_placed(world, arguments.geometry_b);
  std::vector<Answer> answers;
  for (const Ask& ask : all_asks()) {
    answers.push_back(answer(ask, a, b));
  }
  if (!answers.front().refusal.empty()) {
    throw BadInput(a.name + " and " + b.name + ": " + answers.front().refusal);
  }
  print(arguments.json ? json_of(a, b, answers) : table_of(a, b, answers));
}

}  // namespace cli
