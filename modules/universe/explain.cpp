// SPDX-License-Identifier: Apache-2.0
// What a universe did and why, from what its stages know.
module abut.universe;
import abut.broadphase;
import abut.core.standard;
import abut.core;
import abut.detect.backend;
import abut.detect.lists.contacts;
import abut.detect.lists.islands;
import abut.detect.pairs.jobs;
import abut.math;
import abut.pairs.any_shape;
import abut.report.plan;
import abut.scene.rest.focus;
import abut.scene.rest.focus_tags;
import abut.scene.meetings;
import abut.scene.meetings.policies;
import abut.scene.meetings.rules;
import abut.scene.state.space;
import abut.scene.rest.velocity;

namespace abut {
namespace {

std::vector<Plan::Stage> stages_of(const StepStats& stats, std::uint32_t max_contacts) {
  const std::string kept =
      max_contacts == 0 ? "all kept" : "at most " + to_text(std::uint64_t{max_contacts}) + " per patch";
  return {
      {"refresh", stats.refresh_microseconds, "poses to boxes: " + to_text(stats.moved) + " moved"},
      {"broad phase", stats.broadphase_microseconds,
       "boxes to pairs: " + count_of(stats.candidate_pairs + stats.filtered_pairs + stats.unsupported_pairs, "pair")},
      {"pairs", stats.pair_microseconds,
       count_of(stats.candidate_pairs, "candidate pair") + ", " + to_text(stats.kept_pairs) + " kept, " +
           to_text(stats.filtered_pairs) + " filtered"},
      {"narrow phase", stats.narrowphase_microseconds,
       "pairs to manifolds: " + to_text(stats.examined_pairs) + " examined, " + kept},
      {"contacts", stats.contact_microseconds,
       count_of(stats.touching_pairs, "touching pair") + ", " + count_of(stats.contacts, "contact") + ", " +
           count_of(stats.events, "event")},
  };
}

Plan::IslandCounts count_of(const IslandList& islands) {
  std::uint64_t largest = 0;
  for (const Island& island : islands.islands()) {
    largest = std::max<std::uint64_t>(largest, island.count);
  }
  return {islands.islands().size(), islands.parts().size(), largest};
}

std::optional<double> time_of_pair(const KindTally& tally) {
  return tally.is_timed && tally.examined > 0 ? std::optional(tally.microseconds / static_cast<double>(tally.examined))
                                              : std::nullopt;
}

}  // namespace

Plan::FocusCounts Universe::count_focus() const {
  const FocusCentres& centres = focus_.centres();
  Plan::FocusCounts counts{centres.focus(), centres.size(), 0, 0};
  geometries_.for_each([&](GeometryId id, const Geometry&) {
    const std::uint32_t tag = places_.infos[id.slot - 1].tag;
    counts.near += tag == counts.focus.near_tag ? 1 : 0;
    counts.far += tag == counts.focus.far_tag ? 1 : 0;
  });
  return counts;
}

std::vector<Plan::LeftOut> Universe::left_out(std::uint64_t never_met, bool has_extensions) const {
  std::vector<Plan::LeftOut> list;
  const auto leave_out = [&](bool is_left_out, std::string name, std::string why) {
    if (is_left_out) {
      list.push_back({std::move(name), std::move(why)});
    }
  };
  for (const BroadphaseKind kind :
       {BroadphaseKind::brute, BroadphaseKind::tree, BroadphaseKind::sweep_and_prune, BroadphaseKind::hash_grid}) {
    leave_out(kind != space_.kind(), std::string(name_of(kind)), "another broad phase runs");
  }
  leave_out(never_met > 0, count_of(never_met, "pair") + " of kinds", "never met");
  leave_out(stats_.unsupported_pairs > 0, count_of(stats_.unsupported_pairs, "unsupported pair"),
            "no algorithm, by declaration");
  leave_out(stats_.parked > 0, count_of(stats_.parked, "geometry"), "parked");
  leave_out(meetings_.rules.is_empty(), "rules", "none set");
  leave_out(!meetings_.filter, "filter", "none set");
  leave_out(meetings_.policies.size() == 1, "policies", "none set");
  leave_out(!focus_.is_on(), "focus", "none set");
  leave_out(!sleep_.is_used(), "sleep", "set for no part");
  leave_out(!follows_islands_, "islands", sleep_.is_used() ? "connected for sleep, not numbered" : "not asked for");
  leave_out(velocities_.is_empty(), "velocities", "set for no part");
  leave_out(self_places_.empty(), "self pairs", "switched on for no geometry");
  leave_out(workers_.threads() == 1, "threads", "one does it all");
  leave_out(swept_places_.empty(), "continuous pass", "no geometry is fast or speculative");
  leave_out(!has_extensions, "extensions", "none attached");
  return list;
}

Plan Universe::plan(std::span<const Plan::Extension> extensions) const {
  Plan plan{.stats = stats_,
            .broadphase = name_of(space_.kind()),
            .broadphase_reason = space_.reason(),
            .is_margin = options_.tolerance_mode == ToleranceMode::margin,
            .max_contacts = options_.max_contacts,
            .threads = workers_.threads(),
            .rules = meetings_.rules.size(),
            .policies = meetings_.policies.size() - 1,
            .stages = stages_of(stats_, options_.max_contacts),
            .kinds = {},
            .left_out = {},
            .extensions = {extensions.begin(), extensions.end()}};
  if (backend_.is_on()) {
    plan.backend = {backend_.asked(), backend_.answered()};
  }
  if (focus_.is_on()) {
    plan.focus = count_focus();
  }
  if (follows_islands_) {
    plan.islands = count_of(islands_);
  }
  if (!velocities_.is_empty()) {
    plan.velocities = {velocities_.count(VelocitySource::given), velocities_.count(VelocitySource::poses)};
  }
  if (!swept_places_.empty()) {
    plan.paths = Plan::PathCounts{0, 0, impacts_.examined(), impacts_.all().size()};
    for (const std::uint32_t at : swept_places_) {
      const bool is_fast = places_.infos[at].sweeping == Sweeping::impacts;
      (is_fast ? plan.paths->fast : plan.paths->speculative) += 1;
    }
  }
  std::uint64_t never_met = 0;
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      const KindTally& tally = contacts_.tally(run_of(row, column));
      if (tally.candidates == 0) {
        ++never_met;
        continue;
      }
      const RouteDescription route = describe_route(row, column);
      plan.kinds.push_back({kind_name(row), kind_name(column), tally.candidates, tally.examined, tally.touching,
                            tally.contacts, route.algorithm, route.reason, time_of_pair(tally)});
    }
  }
  for (std::size_t kind = 0; kind < shape_kind_count; ++kind) {
    const KindTally& tally = contacts_.tally(self_run_of(kind));
    if (tally.candidates > 0) {
      const RouteDescription route = describe_self(kind);
      plan.kinds.push_back({kind_name(kind), "itself", tally.candidates, tally.examined, tally.touching, tally.contacts,
                            route.algorithm, route.reason, time_of_pair(tally)});
    }
  }
  plan.left_out = left_out(never_met, !extensions.empty());
  return plan;
}

// Whoever asks once may ask again: from the next detection on, times of pairs are measured.
std::string Universe::explain(std::span<const Plan::Extension> extensions) const {
  are_pairs_timed_.store(true, std::memory_order_relaxed);
  return to_text(plan(extensions));
}
std::string Universe::explain_json(std::span<const Plan::Extension> extensions) const {
  are_pairs_timed_.store(true, std::memory_order_relaxed);
  return to_json(plan(extensions));
}

}  // namespace abut
