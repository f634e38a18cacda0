// SPDX-License-Identifier: Apache-2.0
// The plan for programs.
module abut.report.plan;
import abut.core.standard;
import abut.scene.rest.focus;
import abut.report.json;
import abut.scene.state.options;

namespace abut {
namespace {

void write_counts(Json& json, const StepStats& stats) {
  const std::pair<std::string_view, std::uint64_t> counts[] = {
      {"parts", stats.parts},
      {"geometries", stats.geometries},
      {"parked", stats.parked},
      {"moved", stats.moved},
      {"candidate_pairs", stats.candidate_pairs},
      {"filtered_pairs", stats.filtered_pairs},
      {"examined_pairs", stats.examined_pairs},
      {"kept_pairs", stats.kept_pairs},
      {"unsupported_pairs", stats.unsupported_pairs},
      {"touching_pairs", stats.touching_pairs},
      {"contacts", stats.contacts},
      {"events", stats.events},
      {"bytes", stats.bytes},
      {"asleep", stats.asleep},
  };
  json.name("counts");
  json.open('{');
  for (const auto& [name, count] : counts) {
    json.member(name, count);
  }
  json.close('}');
}

void write_backend(Json& json, const Plan::BackendCounts& counts) {
  json.name("backend");
  json.open('{');
  json.member("asked", counts.asked);
  json.member("answered", counts.answered);
  json.close('}');
}

void write_focus(Json& json, const Plan::FocusCounts& counts) {
  json.name("focus");
  json.open('{');
  json.member("centres", counts.centres);
  json.member("near_tag", std::uint64_t{counts.focus.near_tag});
  json.member("far_tag", std::uint64_t{counts.focus.far_tag});
  json.member("near_distance", counts.focus.near_distance);
  json.member("far_distance", counts.focus.far_distance);
  json.member("near", counts.near);
  json.member("far", counts.far);
  json.close('}');
}

void write_islands(Json& json, const Plan::IslandCounts& counts) {
  json.name("islands");
  json.open('{');
  json.member("islands", counts.islands);
  json.member("parts", counts.parts);
  json.member("largest", counts.largest);
  json.close('}');
}

void write_velocities(Json& json, const Plan::VelocityCounts& counts) {
  json.name("velocities");
  json.open('{');
  json.member("given", counts.given);
  json.member("from_poses", counts.measured);
  json.close('}');
}

void write_paths(Json& json, const Plan::PathCounts& counts) {
  json.name("paths");
  json.open('{');
  json.member("fast", counts.fast);
  json.member("speculative", counts.speculative);
  json.member("pairs", counts.pairs);
  json.member("impacts", counts.impacts);
  json.close('}');
}

void write(Json& json, const Plan::Stage& stage) {
  json.member("name", stage.name);
  json.member("microseconds", stage.microseconds);
  json.member("what", std::string_view(stage.what));
}

void write(Json& json, const Plan::KindPair& its) {
  json.member("a", its.kind_a);
  json.member("b", its.kind_b);
  json.member("candidates", its.candidates);
  json.member("examined", its.examined);
  json.member("touching", its.touching);
  json.member("contacts", its.contacts);
  if (its.microseconds) {
    json.member("microseconds", *its.microseconds);
  }
  json.member("algorithm", its.algorithm);
  json.member("reason", its.reason);
}

void write(Json& json, const Plan::Extension& its) {
  json.member("name", std::string_view(its.name));
  json.member("count", its.count);
}

void write(Json& json, const Plan::LeftOut& its) {
  json.member("name", std::string_view(its.name));
  json.member("why", std::string_view(its.why));
}

template <class Value>
void write_list(Json& json, std::string_view name, const std::vector<Value>& values) {
  json.name(name);
  json.open('[');
  for (const Value& value : values) {
    json.open('{');
    write(json, value);
    json.close('}');
  }
  json.close(']');
}

}  // namespace

std::string to_json(const Plan& plan) {
  Json json;
  json.open('{');
  write_counts(json, plan.stats);
  write_list(json, "stages", plan.stages);
  json.name("broadphase");
  json.open('{');
  json.member("algorithm", plan.broadphase);
  json.member("reason", plan.broadphase_reason);
  json.close('}');
  json.member("tolerance_mode", std::string_view(plan.is_margin ? "margin" : "dead_band"));
  json.member("max_contacts", std::uint64_t{plan.max_contacts});
  json.member("threads", std::uint64_t{plan.threads});
  json.member("rules", plan.rules);
  json.member("policies", plan.policies);
  if (plan.backend) {
    write_backend(json, *plan.backend);
  }
  if (plan.focus) {
    write_focus(json, *plan.focus);
  }
  if (plan.islands) {
    write_islands(json, *plan.islands);
  }
  if (plan.velocities) {
    write_velocities(json, *plan.velocities);
  }
  if (plan.paths) {
    write_paths(json, *plan.paths);
  }
  write_list(json, "extensions", plan.extensions);
  write_list(json, "pairs_of_kinds", plan.kinds);
  write_list(json, "left_out", plan.left_out);
  json.close('}');
  return std::move(json).text();
}

}  // namespace abut
