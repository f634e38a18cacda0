// SPDX-License-Identifier: Apache-2.0
// What will surprise whoever built a response.
module;

#include <abut/response.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

module abut.response;

namespace abut::response {

namespace {

abut_response_finding& add(std::vector<abut_response_finding>& out, abut_response_finding_code code,
                           const std::string& message) {
  abut_response_finding& its = out.emplace_back();
  its.code = code;
  const std::span<char> place(its.message);
  std::ranges::copy(std::string_view(message).substr(0, place.size() - 1), place.begin());
  return its;
}

[[nodiscard]] std::string named(const char* what, std::uint32_t slot) { return what + std::to_string(slot); }

// Parameters that a kind does not read.
[[nodiscard]] std::string unused_of(const Kind& kind, const Parameters& parameters) {
  const auto reads = [&](std::string_view name) {
    const bool is_friction = name == "mu" || name == "mu1" || name == "mu2" || name == "static";
    const bool bounces = name == "e" || name == "threshold";
    switch (kind.response) {
      case Response::none: return false;
      case Response::penalty: return !is_friction && name != "break" && name != "epsilon";
      case Response::stick:
        return name == "k" || name == "compliance" || name == "d" || name == "break" || bounces || is_friction;
      case Response::augmented: return name != "break";
      case Response::friction:
      case Response::slide:
      case Response::custom: return name != "break" && name != "epsilon";
    }
    return true;
  };
  for (const char* const name :
       {"mu", "mu1", "mu2", "static", "k", "compliance", "d", "e", "threshold", "adhesion", "break", "epsilon"}) {
    if (parameters.has(name) && !reads(name)) return name;
  }
  // A damper acts beside a spring.
  if (parameters.has("d") && !parameters.has("k") && !parameters.has("compliance")) return "d";
  return {};
}

}  // namespace

abut_status Simulation::find_in_bodies(std::vector<abut_response_finding>& out) const {
  for (const Body& body : bodies_) {
    if (!source_->has(body.part)) continue;
    const std::string part = named("part ", body.part.slot);
    bool is_dynamic = true, is_awake = true;
    abut_velocity velocity{};
    std::vector<GeometryFacts> geometries;
    abut_status status = source_->is_dynamic(body.part, is_dynamic);
    if (status == ABUT_OK) status = source_->is_awake(body.part, is_awake);
    if (status == ABUT_OK) status = source_->velocity(body.part, velocity);
    if (status == ABUT_OK) status = source_->geometries_of(body.part, geometries);
    if (status != ABUT_OK) return status;
    if (!is_dynamic)
      add(out, ABUT_RESPONSE_FINDING_NOT_DYNAMIC, part + " is a body, but not dynamic: it stands still").part =
          body.part;
    if (is_dynamic && !is_awake && length(velocity.linear) + length(velocity.angular) > 0)
      add(out, ABUT_RESPONSE_FINDING_ASLEEP,
          part + " has a velocity and sleeps; abut_part_wake or a force sets it in motion")
          .part = body.part;
    for (const GeometryFacts& its : geometries) {
      if ((its.flags & ABUT_GEOMETRY_SENSOR) != 0) continue;
      const auto tell = [&](abut_response_finding_code code, const char* what) {
        abut_response_finding& told = add(out, code, named("geometry ", its.geometry.slot) + what);
        told.part = body.part;
        told.geometry = its.geometry;
      };
      if (!(its.tolerance > 0))
        tell(ABUT_RESPONSE_FINDING_NO_TOLERANCE, " has the tolerance 0: contacts come when it overlaps already");
      if (!stops_at_impacts()) continue;
      if ((its.flags & ABUT_GEOMETRY_FAST) == 0)
        tell(ABUT_RESPONSE_FINDING_NOT_FAST, " is not ABUT_GEOMETRY_FAST: no step stops where it touches");
      if ((its.flags & ABUT_GEOMETRY_SPECULATIVE) != 0)
        tell(ABUT_RESPONSE_FINDING_SPECULATIVE, " is ABUT_GEOMETRY_SPECULATIVE, which steps with impacts do without");
    }
  }
  return ABUT_OK;
}

void Simulation::find_in_rules(std::vector<abut_response_finding>& out) const {
  const auto is_any = [](const Rules::Rule& rule) {
    return rule.a.kind == ABUT_RESPONSE_SIDE_ANY && rule.b.kind == ABUT_RESPONSE_SIDE_ANY;
  };
  const auto is_gone = [&](const abut_response_side& side) {
    if (side.kind == ABUT_RESPONSE_SIDE_GEOMETRY) return !source_->has(abut_geometry_id{side.slot, side.generation});
    return side.kind == ABUT_RESPONSE_SIDE_PART && !source_->has(abut_part_id{side.slot, side.generation});
  };
  bool is_shut = false;
  for (std::uint32_t i = 0; i < rules_.rules().size(); ++i) {
    const Rules::Rule& rule = rules_.rules()[i];
    const Kind& kind = rules_.kinds()[rule.kind];
    const auto tell = [&](abut_response_finding_code code, const std::string& what) {
      add(out, code, named("rule ", i) + what).rule = i;
    };
    if (is_shut) tell(ABUT_RESPONSE_FINDING_UNREACHABLE, " comes after one that fits everything");
    if (is_gone(rule.a) || is_gone(rule.b))
      tell(ABUT_RESPONSE_FINDING_GONE, " names a geometry or a part that has been destroyed");
    if (rule.parameters.has("e") && !stops_at_impacts())
      tell(ABUT_RESPONSE_FINDING_NO_IMPACTS, " has a restitution, which counts with ABUT_RESPONSE_IMPACTS alone");
    if (kind.response == Response::penalty && !rule.parameters.has("k") && !rule.parameters.has("compliance"))
      tell(ABUT_RESPONSE_FINDING_NO_STIFFNESS, " has the kind penalty and no k: rigid, unless materials yield");
    if (const std::string name = unused_of(kind, rule.parameters); !name.empty())
      tell(ABUT_RESPONSE_FINDING_UNUSED, " gives " + name + ", which the kind " + kind.name + " does not read there");
    is_shut = is_shut || is_any(rule);
  }
}

abut_status Simulation::validate(std::vector<abut_response_finding>& out) const {
  bool has_margin = true;
  if (const abut_status status = source_->has_margin(has_margin); status != ABUT_OK) return status;
  if (!has_margin)
    add(out, ABUT_RESPONSE_FINDING_DEAD_BAND,
        "the universe has ABUT_TOLERANCE_DEAD_BAND: bodies at rest lose their contacts; use ABUT_TOLERANCE_MARGIN");
  if (const abut_status status = find_in_bodies(out); status != ABUT_OK) return status;
  find_in_rules(out);
  constexpr double far_apart = 1e3;
  const auto [light, heavy] = std::ranges::minmax_element(bodies_, {}, [](const Body& body) { return body.mass.mass; });
  if (options_.solver == ABUT_SOLVER_SWEEPS && light != bodies_.end() &&
      heavy->mass.mass > far_apart * light->mass.mass)
    add(out, ABUT_RESPONSE_FINDING_SLOW_SWEEPS,
        "masses differ by more than 1,000, where sweeps hardly converge; use ABUT_SOLVER_NEWTON");
  if (const Kind* const kind = rules_.without_law(); kind != nullptr)
    add(out, ABUT_RESPONSE_FINDING_NO_FUNCTION,
        "the kind " + kind->name + " has no function yet; abut_response_add_kind gives it one");
  std::ranges::sort(out, {}, [](const abut_response_finding& its) {
    return std::tuple(its.code, its.rule, its.part.slot, its.geometry.slot);
  });
  return ABUT_OK;
}

}  // namespace abut::response
