// SPDX-License-Identifier: Apache-2.0
// Error against run time of questions about meshes whose vertices move, step by step. The timed part takes the vertices
// of a step too.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "deforming_truth.hpp"
#include "flags.hpp"
#include "statistics.hpp"

namespace bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* usage = R"(usage: abut_bench_deforming --json FILE [--steps N] [--repetitions N] [--only TEXT]

Writes times and errors of each question about meshes that deform.
  --steps N         of each scene (6)
  --repetitions N   of each timing (3)
  --only TEXT       only questions with this in their name, such as impact
)";

// A distance, or a time, that is off by more is on another side of the reach, or another touch.
constexpr double rounding = 1e-9;

double diameter(const Deforming& mesh) {
  Point low = mesh.start.front(), high = low;
  for (const Point& p : mesh.start) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

double size_of(const DeformingCase& step) { return diameter(step.a) + diameter(step.is_of_one() ? step.a : step.b); }

double longest_way(const DeformingCase& step) {
  double longest = 0;
  for (const Deforming* mesh : {&step.a, &step.b}) {
    for (std::size_t i = 0; i < mesh->start.size(); ++i) {
      const Point &p = mesh->start[i], &q = mesh->end[i];
      longest = std::max(longest, std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
    }
  }
  return longest;
}

// The errors of one contender over all steps, and the answers that do not count.
struct Judged {
  std::vector<double> errors;
  std::size_t cases = 0, missed = 0, too_many = 0;

  // The share of pairs that are missed or too many.
  void add_sets(const Found& truth, const Found& found) {
    ++cases;
    if (!found.has_pairs) {
      errors.push_back(found.is_yes == truth.is_yes ? 0 : 1);
      return;
    }
    std::map<std::array<std::uint32_t, 3>, int> difference;
    for (const ElementPair& pair : truth.pairs) {
      ++difference[pair.key()];
    }
    for (const ElementPair& pair : found.pairs) {
      --difference[pair.key()];
    }
    std::size_t wrong = 0;
    for (const auto& [key, count] : difference) {
      wrong += static_cast<std::size_t>(std::abs(count));
    }
    errors.push_back(static_cast<double>(wrong) / static_cast<double>(std::max<std::size_t>(truth.pairs.size(), 1)));
  }

  // The way by which each first touch is off.
  void add_times(const Found& truth, const Found& found, const DeformingCase& step) {
    const double scale = longest_way(step) / size_of(step);
    std::map<std::array<std::uint32_t, 3>, double> times;
    for (const ElementPair& pair : found.pairs) {
      times[pair.key()] = pair.value;
    }
    for (const ElementPair& pair : truth.pairs) {
      ++cases;
      const auto its = times.find(pair.key());
      if (its == times.end()) {
        ++missed;
      } else {
        errors.push_back(std::fabs(its->second - pair.value) * scale);
        times.erase(its);
      }
    }
    cases += times.size();
    too_many += times.size();
  }

  void add_distances(const Found& truth, const Found& found, const DeformingCase& step) {
    for (std::size_t i = 0; i < truth.distances.size(); ++i) {
      const double is = truth.distances[i], got = found.distances.at(i);
      const bool is_told = std::isfinite(got), is_there = std::isfinite(is);
      // At the end of the reach rounding decides.
      const bool is_at_end = is_told != is_there && std::fmin(is, got) > step.reach * (1 - rounding);
      if ((!is_told && !is_there) || is_at_end) {
        continue;
      }
      ++cases;
      if (is_told && is_there) {
        errors.push_back(std::fabs(got - is) / size_of(step));
      } else {
        ++(is_there ? missed : too_many);
      }
    }
  }

  void add(Asked asked, const Found& truth, const Found& found, const DeformingCase& step) {
    switch (asked) {
      case Asked::candidates:
      case Asked::overlap: add_sets(truth, found); break;
      case Asked::impact: add_times(truth, found, step); break;
      case Asked::closest:
      case Asked::distance: add_distances(truth, found, step); break;
    }
  }
};

std::vector<NamedWay> all_ways(Asked asked, const DeformingCase& first) {
  std::vector<NamedWay> ways = abut_ways(asked, first);
  std::array more{plain_ways(asked), bullet_ways(asked, first), fcl_ways(asked, first)};
  for (std::vector<NamedWay>& its : more) {
    std::ranges::move(its, std::back_inserter(ways));
  }
  return ways;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Steps in which sheets cross have no distance; those without a touch have no time.
bool is_judged(Asked asked, const DeformingCase& step, const Found& truth) {
  switch (asked) {
    case Asked::distance: return !step.is_of_one() && truth.distances.front() > 0;
    case Asked::overlap: return true;
    case Asked::closest: return std::ranges::any_of(truth.distances, [](double d) { return std::isfinite(d); });
    case Asked::candidates:
    case Asked::impact: return !truth.pairs.empty();
  }
  return true;
}

void ask(Asked asked, const DeformingScene& scene, std::size_t repetitions, Json& rows) {
  std::vector<DeformingCase> steps;
  std::vector<Found> truths;
  for (const DeformingCase& step : scene.cases) {
    if (asked == Asked::distance && (step.is_of_one() || deforming_truth(Asked::overlap, step).is_yes)) {
      continue;
    }
    Found truth = deforming_truth(asked, step);
    if (is_judged(asked, step, truth)) {
      steps.push_back(step);
      truths.push_back(std::move(truth));
    }
  }
  if (steps.empty()) {
    return;
  }
  std::vector<NamedWay> ways = all_ways(asked, steps.front());
  std::vector<Judged> judged(ways.size());
  std::vector<std::vector<double>> times(ways.size());
  std::vector<Found> found(ways.size());
  for (std::size_t way = 0; way < ways.size(); ++way) {
    for (std::size_t i = 0; i < steps.size(); ++i) {
      ways[way].way->answer(steps[i], found[way]);
      judged[way].add(asked, truths[i], found[way], steps[i]);
    }
  }
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t way = 0; way < ways.size(); ++way) {
      const double start = processor_seconds();
      for (const DeformingCase& step : steps) {
        ways[way].way->answer(step, found[way]);
      }
      times[way].push_back((processor_seconds() - start) / static_cast<double>(steps.size()));
    }
  }
  for (std::size_t way = 0; way < ways.size(); ++way) {
    Json row{{"question", asked_name(asked)},
             {"condition", "ordinary"},
             {"pair", scene.name},
             {"contender", ways[way].name},
             {"nanoseconds", 1e9 * median(times[way])}};
    const Judged& its = judged[way];
    if (!its.errors.empty()) {
      row["median"] = median(its.errors);
      row["p99"] = percentile(its.errors, 99);
      row["worst"] = *std::ranges::max_element(its.errors);
    }
    row["cases"] = its.cases;
    row["failures"] = {{"ended", 0}, {"none", its.missed}, {"not_finite", 0}, {"wrong_side", its.too_many}};
    rows.push_back(std::move(row));
  }
}

void run(const std::vector<std::string>& words) {
  std::size_t steps = 6, repetitions = 3;
  std::string only;
  std::filesystem::path json;
  for (const auto& [name, value] : flags_of(words, usage)) {
    if (name == "--json") {
      json = value;
    } else if (name == "--steps") {
      steps = count_of(name, value);
    } else if (name == "--repetitions") {
      repetitions = count_of(name, value);
    } else if (name == "--only") {
      only = value;
    } else {
      refuse(name, usage);
    }
  }
  if (json.empty()) {
    throw std::runtime_error(std::string("--json is missing\n") + usage);
  }
  Json rows = Json::array();
  const DeformingScene folds = sheet_in_folds(steps), two = two_sheets(steps);
  for (const Asked asked : all_asked) {
    if (asked_name(asked).find(only) == std::string_view::npos) {
      continue;
    }
    std::fprintf(stderr, "%s, meshes that deform\n", std::string(asked_name(asked)).c_str());
    ask(asked, folds, repetitions, rows);
    ask(asked, two, repetitions, rows);
  }
  std::ofstream file(json);
  file << Json{{"steps", steps}, {"repetitions", repetitions}, {"rows", rows}}.dump() << '\n';
  if (!file.flush()) {
    throw std::runtime_error(json.string() + " cannot be written");
  }
}

}  // namespace
}  // namespace bench

int main(int count, char** words) { return bench::main_of(count, words, bench::usage, bench::run); }
