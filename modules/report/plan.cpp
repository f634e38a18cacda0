// SPDX-License-Identifier: Apache-2.0
module abut.report.plan;
import abut.core;
import abut.core.standard;
import abut.scene.rest.focus;
import abut.scene.state.options;

namespace abut {
namespace {

std::string line_of(const Plan::Stage& stage) {
  std::string line = "  " + std::string(stage.name);
  line.resize(16, ' ');
  const std::string spent = to_text(std::round(10 * stage.microseconds) / 10) + " us";
  line.append(spent.size() < 12 ? 12 - spent.size() : 0, ' ');
  return line + spent + "  " + stage.what + "\n";
}

std::string line_of(const Plan::KindPair& its) {
  const std::string spent =
      its.microseconds ? "; " + to_text(std::round(1000 * *its.microseconds) / 1000) + " us a pair" : "";
  return "  " + std::string(its.kind_a) + " - " + std::string(its.kind_b) + ": " +
         count_of(its.candidates, "candidate") + ", " + to_text(its.examined) + " examined, " + to_text(its.touching) +
         " touching, " + count_of(its.contacts, "contact") + spent + "; " + std::string(its.algorithm) + " (" +
         std::string(its.reason) + ")\n";
}

std::string line_of(const Plan::BackendCounts& counts) {
  return "back end: " + count_of(counts.asked, "pair") + " asked, " + to_text(counts.answered) + " answered\n";
}

std::string line_of(const Plan::FocusCounts& counts) {
  const Focus& focus = counts.focus;
  return "focus: " + count_of(counts.centres, "centre") + "; " + count_of(counts.near, "geometry") + " near (tag " +
         to_text(std::uint64_t{focus.near_tag}) + ", within " + to_text(focus.near_distance) + "), " +
         to_text(counts.far) + " far (tag " + to_text(std::uint64_t{focus.far_tag}) + ", beyond " +
         to_text(focus.far_distance) + ")\n";
}

std::string line_of(const Plan::IslandCounts& counts) {
  return "islands: " + to_text(counts.islands) + " of " + count_of(counts.parts, "part") + ", the largest of " +
         to_text(counts.largest) + "\n";
}

std::string line_of(const Plan::VelocityCounts& counts) {
  return "velocities: " + to_text(counts.given) + " given, " + to_text(counts.measured) + " from poses\n";
}

std::string line_of(const Plan::PathCounts& counts) {
  return "paths: " + count_of(counts.fast, "fast geometry") + ", " + to_text(counts.speculative) + " speculative, " +
         count_of(counts.pairs, "pair") + " examined, " + count_of(counts.impacts, "impact") + "\n";
}

std::string line_of(std::span<const Plan::Extension> extensions) {
  std::string line;
  for (const Plan::Extension& its : extensions) {
    line += (line.empty() ? "extensions: " : ", ") + to_text(its.count) + " " + its.name;
  }
  return line.empty() ? line : line + "\n";
}

// What is only there when the scene uses it.
std::string lines_of_extras(const Plan& plan) {
  return (plan.backend ? line_of(*plan.backend) : "") + (plan.focus ? line_of(*plan.focus) : "") +
         (plan.islands ? line_of(*plan.islands) : "") + (plan.velocities ? line_of(*plan.velocities) : "") +
         (plan.paths ? line_of(*plan.paths) : "") + line_of(plan.extensions);
}

}  // namespace

std::string count_of(std::uint64_t count, std::string_view noun) {
  std::string text = to_text(count) + " " + std::string(noun);
  if (count == 1) {
    return text;
  }
  if (!noun.ends_with('y')) {
    return text + "s";
  }
  text.pop_back();
  return text + "ies";
}

std::string to_text(const Plan& plan) {
  const StepStats& stats = plan.stats;
  const std::string asleep = stats.asleep > 0 ? " (" + to_text(stats.asleep) + " asleep)" : "";
  std::string text = "universe: " + count_of(stats.parts, "part") + asleep + ", " +
                     count_of(stats.geometries, "geometry") + ", " + count_of(stats.bytes, "byte") +
                     "\nstages of the last step\n";
  for (const Plan::Stage& stage : plan.stages) {
    text += line_of(stage);
  }
  text += "broad phase: " + std::string(plan.broadphase) + ", " + std::string(plan.broadphase_reason) + "\n";
  text += "threads: " + to_text(std::uint64_t{plan.threads}) + "\ntolerance: ";
  text += plan.is_margin ? "margin, a separation below the sum of both is reported\n"
                         : "dead band, an overlap beyond the sum of both is reported\n";
  text += lines_of_extras(plan) + "pairs of kinds\n";
  for (const Plan::KindPair& its : plan.kinds) {
    text += line_of(its);
  }
  text += "left out\n";
  for (const Plan::LeftOut& its : plan.left_out) {
    text += "  " + its.name + ": " + its.why + "\n";
  }
  return text;
}

}  // namespace abut
