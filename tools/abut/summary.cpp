// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace cli {
namespace {

struct Count {
  const char* field;
  const char* title;
  std::uint64_t abut_step_stats::* value;
};
constexpr std::array<Count, 9> counts{{{"moved", "moved geometries", &abut_step_stats::moved},
                                       {"candidate_pairs", "candidate pairs", &abut_step_stats::candidate_pairs},
                                       {"filtered_pairs", "filtered pairs", &abut_step_stats::filtered_pairs},
                                       {"examined_pairs", "examined pairs", &abut_step_stats::examined_pairs},
                                       {"touching_pairs", "touching pairs", &abut_step_stats::touching_pairs},
                                       {"unsupported_pairs", "unsupported pairs", &abut_step_stats::unsupported_pairs},
                                       {"contacts", "contacts", &abut_step_stats::contacts},
                                       {"events", "events", &abut_step_stats::events},
                                       {"asleep", "parts asleep", &abut_step_stats::asleep}}};

struct Stage {
  const char* field;
  const char* title;
  double abut_step_stats::* microseconds;
};
constexpr std::array<Stage, 5> stages{
    {{"refresh", "refresh: poses to boxes", &abut_step_stats::refresh_microseconds},
     {"broadphase", "broad phase: boxes to pairs", &abut_step_stats::broadphase_microseconds},
     {"pairs", "pairs: filters and memory", &abut_step_stats::pair_microseconds},
     {"narrowphase", "narrow phase: to manifolds", &abut_step_stats::narrowphase_microseconds},
     {"contacts", "contacts and events", &abut_step_stats::contact_microseconds}}};

// Whole numbers of counts, thousandths of milliseconds.
std::string row(const char* title, const Measure& measure, int decimals) {
  std::array<char, 160> line{};
  const int size = std::snprintf(line.data(), line.size(), "%-28s %12.*f %12.*f %12.*f %12.*f %14.*f\n", title,
                                 decimals, measure.minimum(), std::max(decimals, 1), measure.mean(), decimals,
                                 measure.maximum(), decimals, measure.last(), decimals, measure.total());
  return {line.data(), std::min(static_cast<std::size_t>(size), line.size() - 1)};
}

std::string header(const char* title) {
  std::array<char, 160> line{};
  const int size = std::snprintf(line.data(), line.size(), "\n%-28s %12s %12s %12s %12s %14s\n", title, "min", "mean",
                                 "max", "last step", "all steps");
  return {line.data(), static_cast<std::size_t>(size)};
}

nlohmann::ordered_json json_of(const Measure& measure) {
  return {{"min", measure.minimum()},
          {"mean", measure.mean()},
          {"max", measure.maximum()},
          {"last", measure.last()},
          {"total", measure.total()}};
}

std::string hash_of(const World& world) {
  std::uint64_t hash = 0;
  check(abut_universe_hash(world.universe(), &hash), "cannot ask for the hash of the step");
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

}  // namespace

void Measure::add(double value) {
  minimum_ = count_ > 0.0 ? std::min(minimum_, value) : value;
  maximum_ = count_ > 0.0 ? std::max(maximum_, value) : value;
  last_ = value;
  total_ += value;
  count_ += 1.0;
}

void Summary::add(const World& world, double milliseconds) {
  const abut_step_stats stats = stats_of(world.universe());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    counts_[i].add(static_cast<double>(stats.*counts[i].value));
  }
  elements_.add(static_cast<double>(world.element_contacts().size()));
  for (std::size_t i = 0; i < stages.size(); ++i) {
    milliseconds_[i].add(1e-3 * stats.*stages[i].microseconds);
  }
  milliseconds_.back().add(milliseconds);
  ++steps_;
}

std::string Summary::table(const World& world) const {
  const Scene& scene = world.scene();
  std::string text = "abut " + std::string(abut_version_string()) + ": " + std::to_string(scene.parts.size()) +
                     " parts, " + std::to_string(scene.geometries.size()) + " geometries, " +
                     std::to_string(scene.shapes.count()) + " shapes; " + std::to_string(steps_) + " steps of " +
                     Json(scene.dt).dump() + " " + scene.time_unit + "\n";
  text += header("counts per step");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    text += row(counts[i].title, counts_[i], 0);
  }
  text += row("element contacts", elements_, 0);
  text += header("milliseconds per step");
  for (std::size_t i = 0; i < stages.size(); ++i) {
    text += row(stages[i].title, milliseconds_[i], 3);
  }
  text += row("whole step", milliseconds_.back(), 3);
  return text + "\nhash of the last step " + hash_of(world) + "\n";
}

std::string Summary::json(const World& world) const {
  const Scene& scene = world.scene();
  nlohmann::ordered_json out{{"version", abut_version_string()},
                             {"units", {{"length", scene.length_unit}, {"time", scene.time_unit}}},
                             {"steps", steps_},
                             {"dt", scene.dt},
                             {"parts", scene.parts.size()},
                             {"geometries", scene.geometries.size()},
                             {"shapes", scene.shapes.count()}};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    out["counts"][counts[i].field] = json_of(counts_[i]);
  }
  out["counts"]["element_contacts"] = json_of(elements_);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    out["milliseconds"][stages[i].field] = json_of(milliseconds_[i]);
  }
  out["milliseconds"]["step"] = json_of(milliseconds_.back());
  out["hash"] = hash_of(world);
  return out.dump(2) + "\n";
}

}  // namespace cli
