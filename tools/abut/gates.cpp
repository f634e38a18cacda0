// SPDX-License-Identifier: Apache-2.0
#include "gates.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace cli {
namespace {

// Two geometries that are asked about.
struct Pair {
  const Scene* scene;
  const RuleBook* rules;
  std::size_t a, b;

  [[nodiscard]] const Geometry& geometry(std::size_t index) const { return scene->geometries[index]; }
  [[nodiscard]] const Part& part(std::size_t index) const { return scene->parts[geometry(index).part]; }
  [[nodiscard]] const abut_geometry_options& options(std::size_t index) const { return geometry(index).options; }
  [[nodiscard]] std::string name(std::size_t index) const { return part(index).name + "/" + geometry(index).name; }
};

std::string names_of_bits(const Names& names, std::uint64_t bits) {
  if (bits == 0 || bits == UINT64_MAX) {
    return bits == 0 ? "none" : "all";
  }
  std::string text;
  for (std::uint32_t bit = 0; bit < 64; ++bit) {
    if ((bits >> bit & 1U) != 0) {
      text += (text.empty() ? "" : ", ") + names.name_of(bit);
    }
  }
  return text;
}

std::string say_parts(const Pair& pair, bool is_open) {
  return is_open ? "they are on two parts" : "both are on the part " + pair.part(pair.a).name;
}

std::string motion_name(const Part& part) {
  constexpr std::array<const char*, 3> names{"dynamic", "animated", "static"};
  return names.at(part.motion);
}

std::string say_motion(const Pair& pair, bool is_open) {
  const Part& a = pair.part(pair.a);
  const Part& b = pair.part(pair.b);
  return a.name + " is " + motion_name(a) + " and " + b.name + " is " + motion_name(b) +
         (is_open ? "" : "; one of them must be dynamic");
}

bool is_parked(const Pair& pair, std::size_t index) { return pair.options(index).parking != ABUT_PARKING_NONE; }

std::string say_parking(const Pair& pair, bool is_open) {
  return is_open ? "neither is parked" : pair.name(is_parked(pair, pair.a) ? pair.a : pair.b) + " is parked";
}

std::uint64_t shared_exclusions(const Pair& pair) {
  return pair.options(pair.a).exclusion & pair.options(pair.b).exclusion;
}

std::string say_exclusion(const Pair& pair, bool is_open) {
  return is_open ? "they have no exclusion in common"
                 : "they have in common: " + names_of_bits(pair.scene->exclusions, shared_exclusions(pair));
}

bool meets(const Pair& pair, std::size_t one, std::size_t other) {
  return (pair.options(one).mask & pair.options(other).layers) != 0;
}

std::string say_layers(const Pair& pair, bool is_open) {
  if (is_open) {
    return "each has a layer that is in the mask of the other";
  }
  const std::size_t one = meets(pair, pair.a, pair.b) ? pair.b : pair.a;
  const std::size_t other = one == pair.a ? pair.b : pair.a;
  return "the mask of " + pair.name(one) + " is " + names_of_bits(pair.scene->layers, pair.options(one).mask) +
         "; the layers of " + pair.name(other) + " are " +
         names_of_bits(pair.scene->layers, pair.options(other).layers);
}

std::string say_rules(const Pair& pair, bool is_open) {
  const Verdict verdict = pair.rules->verdict(pair.a, pair.b);
  return verdict.rule == ABUT_RULE_NONE ? "no rule speaks of them"
                                        : verdict.path + (is_open ? " enables them" : " disables them");
}

std::string say_kinds(const Pair& pair, bool is_open) {
  const std::string a = abut_shape_kind_name(abut_shape_kind_of(pair.geometry(pair.a).shape));
  const std::string b = abut_shape_kind_name(abut_shape_kind_of(pair.geometry(pair.b).shape));
  return a + " and " + b + (is_open ? " have an algorithm" : " have none: abut pairs lists who meets whom");
}

struct Gate {
  std::string_view name;
  abut_apart_reasons reason;  // with which it is closed
  std::string (*says)(const Pair&, bool is_open);
};

constexpr std::array<Gate, 7> gates{{{"parts", ABUT_APART_PART, say_parts},
                                     {"motion", ABUT_APART_MOTION, say_motion},
                                     {"parking", ABUT_APART_PARKING, say_parking},
                                     {"exclusion", ABUT_APART_EXCLUSION, say_exclusion},
                                     {"layers", ABUT_APART_LAYERS, say_layers},
                                     {"rules", ABUT_APART_RULE, say_rules},
                                     {"kinds", ABUT_APART_KINDS, say_kinds}}};

}  // namespace

std::vector<std::string_view> Gates::names() {
  std::vector<std::string_view> all;
  std::ranges::transform(gates, std::back_inserter(all), &Gate::name);
  return all;
}

std::vector<GateAnswer> Gates::answers(std::size_t a, std::size_t b) const {
  const Pair pair{&world_->scene(), &rules_, a, b};
  const abut_apart_reasons reasons = world_->why_apart(a, b);
  std::vector<GateAnswer> all;
  for (const Gate& gate : gates) {
    const bool is_open = (reasons & gate.reason) == 0;
    all.push_back({gate.name, is_open, gate.says(pair, is_open)});
  }
  return all;
}

std::optional<std::string_view> Gates::closed(std::size_t a, std::size_t b) const {
  const abut_apart_reasons reasons = world_->why_apart(a, b);
  const auto found = std::ranges::find_if(gates, [&](const Gate& gate) { return (reasons & gate.reason) != 0; });
  return found == gates.end() ? std::nullopt : std::optional(found->name);
}

}  // namespace cli
