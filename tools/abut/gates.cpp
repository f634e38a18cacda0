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

bool on_two_parts(const Pair& pair) { return pair.geometry(pair.a).part != pair.geometry(pair.b).part; }

std::string say_parts(const Pair& pair, bool is_open) {
  return is_open ? "they are on two parts" : "both are on the part " + pair.part(pair.a).name;
}

bool one_is_dynamic(const Pair& pair) {
  return pair.part(pair.a).motion == ABUT_MOTION_DYNAMIC || pair.part(pair.b).motion == ABUT_MOTION_DYNAMIC;
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

bool none_is_parked(const Pair& pair) { return !is_parked(pair, pair.a) && !is_parked(pair, pair.b); }

std::string say_parking(const Pair& pair, bool is_open) {
  return is_open ? "neither is parked" : pair.name(is_parked(pair, pair.a) ? pair.a : pair.b) + " is parked";
}

std::uint64_t shared_exclusions(const Pair& pair) {
  return pair.options(pair.a).exclusion & pair.options(pair.b).exclusion;
}

bool share_no_exclusion(const Pair& pair) { return shared_exclusions(pair) == 0; }

std::string say_exclusion(const Pair& pair, bool is_open) {
  return is_open ? "they have no exclusion in common"
                 : "they have in common: " + names_of_bits(pair.scene->exclusions, shared_exclusions(pair));
}

bool meets(const Pair& pair, std::size_t one, std::size_t other) {
  return (pair.options(one).mask & pair.options(other).layers) != 0;
}

bool meet_each_other(const Pair& pair) { return meets(pair, pair.a, pair.b) && meets(pair, pair.b, pair.a); }

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

bool no_rule_disables(const Pair& pair) {
  const auto verdict = pair.rules->verdict(*pair.scene, pair.a, pair.b);
  return !verdict || verdict->rule != ABUT_RULE_DISABLE;
}

std::string say_rules(const Pair& pair, bool is_open) {
  const auto verdict = pair.rules->verdict(*pair.scene, pair.a, pair.b);
  return verdict ? verdict->path + (is_open ? " enables them" : " disables them") : "no rule speaks of them";
}

bool have_algorithm(const Pair& pair) {
  std::uint32_t supported = 0;
  check(abut_pair_support(abut_shape_kind_of(pair.geometry(pair.a).shape),
                          abut_shape_kind_of(pair.geometry(pair.b).shape), ABUT_QUERY_CONTACTS, &supported),
        "cannot ask what two kinds answer");
  return supported != 0;
}

std::string say_kinds(const Pair& pair, bool is_open) {
  const std::string a = abut_shape_kind_name(abut_shape_kind_of(pair.geometry(pair.a).shape));
  const std::string b = abut_shape_kind_name(abut_shape_kind_of(pair.geometry(pair.b).shape));
  return a + " and " + b + (is_open ? " have an algorithm" : " have none: abut pairs lists who meets whom");
}

struct Gate {
  std::string_view name;
  bool (*is_open)(const Pair&);
  std::string (*says)(const Pair&, bool is_open);
};

constexpr std::array<Gate, 7> gates{{{"parts", on_two_parts, say_parts},
                                     {"motion", one_is_dynamic, say_motion},
                                     {"parking", none_is_parked, say_parking},
                                     {"exclusion", share_no_exclusion, say_exclusion},
                                     {"layers", meet_each_other, say_layers},
                                     {"rules", no_rule_disables, say_rules},
                                     {"kinds", have_algorithm, say_kinds}}};

}  // namespace

std::vector<std::string_view> Gates::names() {
  std::vector<std::string_view> all;
  std::ranges::transform(gates, std::back_inserter(all), &Gate::name);
  return all;
}

std::vector<GateAnswer> Gates::answers(std::size_t a, std::size_t b) const {
  const Pair pair{&world_->scene(), &rules_, a, b};
  std::vector<GateAnswer> all;
  for (const Gate& gate : gates) {
    const bool is_open = gate.is_open(pair);
    all.push_back({gate.name, is_open, gate.says(pair, is_open)});
  }
  return all;
}

std::optional<std::string_view> Gates::closed(std::size_t a, std::size_t b) const {
  const Pair pair{&world_->scene(), &rules_, a, b};
  const auto found = std::ranges::find_if(gates, [&](const Gate& gate) { return !gate.is_open(pair); });
  return found == gates.end() ? std::nullopt : std::optional(found->name);
}

}  // namespace cli
