module;
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
module abut.universe;
import abut.any_shape;
import abut.broadphase;
import abut.core;
import abut.math;
import abut.universe.pairs;

namespace abut {
namespace {

std::string count_of(std::uint64_t count, std::string_view noun) {
  return to_text(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string microseconds(double value) { return to_text(std::round(10 * value) / 10) + " us"; }

std::string stage(std::string_view name, double time, const std::string& what) {
  std::string line = "  " + std::string(name);
  line.resize(16, ' ');
  std::string spent = microseconds(time);
  spent.insert(0, spent.size() < 12 ? 12 - spent.size() : 0, ' ');
  return line + spent + "  " + what + "\n";
}

std::string names_of(std::size_t row, std::size_t column) {
  return std::string(kind_name(row)) + " - " + std::string(kind_name(column));
}

}  // namespace

std::string Universe::explain() const {
  const bool has_tree = std::holds_alternative<Tree>(broadphase_);
  const std::string geometries = to_text(static_cast<std::uint64_t>(geometries_.size()));
  const std::string count = geometries_.size() == 1 ? "1 geometry" : geometries + " geometries";
  std::string text = "universe: " + count_of(parts_.size(), "part") + ", " + count + ", " + count_of(stats_.bytes, "byte") + "\n";

  text += "stages of the last step\n";
  text += stage("refresh", stats_.refresh_microseconds, "poses to boxes: " + to_text(stats_.moved) + " moved");
  text += stage("broad phase", stats_.broadphase_microseconds,
                std::string(has_tree ? "box trees" : "every pair of boxes") + ": " +
                    count_of(stats_.candidate_pairs, "candidate pair"));
  text += stage("narrow phase", stats_.narrowphase_microseconds,
                "pairs to manifolds: " + count_of(stats_.touching_pairs, "touching pair"));
  text += stage("contacts", stats_.contact_microseconds,
                count_of(stats_.contacts, "contact") + ", " +
                    (options_.max_contacts == 0 ? "all kept" : "at most " + to_text(std::uint64_t{options_.max_contacts}) + " per patch"));

  text += "broad phase: ";
  text += has_tree ? "tree" : "brute force";
  text += options_.broadphase == Broadphase::automatic ? " by the number of geometries, " + geometries : ", as asked for";
  text += "\ntolerance: ";
  text += options_.tolerance_mode == ToleranceMode::margin ? "margin, a separation below the sum of both is reported"
                                                           : "dead band, an overlap beyond the sum of both is reported";
  text += "\npairs of kinds\n";
  std::uint64_t never_met = 0;
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      const KindTally& tally = tallies_[PairRuns::run_of(row, column)];
      if (tally.candidates == 0) {
        ++never_met;
        continue;
      }
      const RouteDescription route = describe_route(row, column);
      text += "  " + names_of(row, column) + ": " + count_of(tally.candidates, "candidate") + ", " + to_text(tally.touching) +
              " touching, " + count_of(tally.contacts, "contact") + "; " + std::string(route.algorithm) + " (" +
              std::string(route.reason) + ")\n";
    }
  }
  text += "left out\n";
  text += has_tree ? "  brute force: " + count + "\n" : "  trees: " + count + ", brute force\n";
  if (never_met > 0) {
    text += "  " + count_of(never_met, "pair") + " of kinds that never met\n";
  }
  if (stats_.unsupported_pairs > 0) {
    text += "  " + count_of(stats_.unsupported_pairs, "candidate") + " without an algorithm by declaration\n";
  }
  text += "  continuous pass: none\n  picking: not loaded\n";
  return text;
}

}  // namespace abut
