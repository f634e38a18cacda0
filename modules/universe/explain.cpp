module abut.universe;
import abut.any_shape;
import abut.broadphase;
import abut.core;
import abut.core.standard;
import abut.math;
import abut.universe.jobs;
import abut.universe.pairs;
import abut.universe.plan;
import abut.universe.policies;
import abut.universe.rules;

namespace abut {
namespace {

std::vector<Plan::Stage> stages_of(const StepStats& stats, std::uint32_t max_contacts) {
  const std::string kept = max_contacts == 0 ? "all kept" : "at most " + to_text(std::uint64_t{max_contacts}) + " per patch";
  return {
      {"refresh", stats.refresh_microseconds, "poses to boxes: " + to_text(stats.moved) + " moved"},
      {"broad phase", stats.broadphase_microseconds,
       "boxes to pairs: " + count_of(stats.candidate_pairs + stats.filtered_pairs + stats.unsupported_pairs, "pair")},
      {"pairs", stats.pair_microseconds,
       count_of(stats.candidate_pairs, "candidate pair") + ", " + to_text(stats.kept_pairs) + " kept, " +
           to_text(stats.filtered_pairs) + " filtered"},
      {"narrow phase", stats.narrowphase_microseconds, "pairs to manifolds: " + to_text(stats.examined_pairs) + " examined, " + kept},
      {"contacts", stats.contact_microseconds,
       count_of(stats.touching_pairs, "touching pair") + ", " + count_of(stats.contacts, "contact") + ", " +
           count_of(stats.events, "event")},
  };
}

}  // namespace

Plan Universe::plan() const {
  Plan plan{.stats = stats_,
            .broadphase = name_of(broadphase_kind_),
            .broadphase_reason = broadphase_reason_,
            .is_margin = options_.tolerance_mode == ToleranceMode::margin,
            .max_contacts = options_.max_contacts,
            .threads = workers_.threads(),
            .rules = rules_.size(),
            .policies = policies_.size() - 1,
            .stages = stages_of(stats_, options_.max_contacts),
            .kinds = {},
            .left_out = {}};
  if (has_focus_) {
    plan.focus = count_focus();
  }
  std::uint64_t never_met = 0;
  for (std::size_t row = 0; row < shape_kind_count; ++row) {
    for (std::size_t column = row; column < shape_kind_count; ++column) {
      const KindTally& tally = tallies_[run_of(row, column)];
      if (tally.candidates == 0) {
        ++never_met;
        continue;
      }
      const RouteDescription route = describe_route(row, column);
      plan.kinds.push_back({kind_name(row), kind_name(column), tally.candidates, tally.examined, tally.touching, tally.contacts,
                            route.algorithm, route.reason});
    }
  }
  const auto leave_out = [&](std::string name, std::string why) { plan.left_out.push_back({std::move(name), std::move(why)}); };
  for (const BroadphaseKind kind :
       {BroadphaseKind::brute, BroadphaseKind::tree, BroadphaseKind::sweep_and_prune, BroadphaseKind::hash_grid}) {
    if (kind != broadphase_kind_) {
      leave_out(std::string(name_of(kind)), "another broad phase runs");
    }
  }
  if (never_met > 0) {
    leave_out(count_of(never_met, "pair") + " of kinds", "never met");
  }
  if (stats_.unsupported_pairs > 0) {
    leave_out(count_of(stats_.unsupported_pairs, "unsupported pair"), "no algorithm, by declaration");
  }
  if (stats_.parked > 0) {
    leave_out(count_of(stats_.parked, "geometry"), "parked");
  }
  if (rules_.is_empty()) {
    leave_out("rules", "none set");
  }
  if (!filter_) {
    leave_out("filter", "none set");
  }
  if (policies_.size() == 1) {
    leave_out("policies", "none set");
  }
  if (!has_focus_) {
    leave_out("focus", "none set");
  }
  if (!sleep_.is_used()) {
    leave_out("sleep", "set for no part");
  }
  if (workers_.threads() == 1) {
    leave_out("threads", "one does it all");
  }
  leave_out("continuous pass", "none");
  leave_out("picking", "not loaded");
  return plan;
}

std::string Universe::explain() const { return to_text(plan()); }
std::string Universe::explain_json() const { return to_json(plan()); }

}  // namespace abut
