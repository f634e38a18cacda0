// SPDX-License-Identifier: Apache-2.0
module;

#include <abut/response.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

module abut.response;

namespace abut::response {

namespace {

constexpr std::size_t longest_name = 63;

[[nodiscard]] bool holds(const abut_response_side& side, const GeometryFacts& its) {
  switch (side.kind) {
    case ABUT_RESPONSE_SIDE_ANY: return true;
    case ABUT_RESPONSE_SIDE_GEOMETRY:
      return side.slot == its.geometry.slot && side.generation == its.geometry.generation;
    case ABUT_RESPONSE_SIDE_PART: return side.slot == its.part.slot && side.generation == its.part.generation;
    case ABUT_RESPONSE_SIDE_LABEL: return side.slot == its.label;
    case ABUT_RESPONSE_SIDE_TAG: return side.slot == its.tag;
    case ABUT_RESPONSE_SIDE_MATERIAL: return side.slot == its.material;
    default: return false;
  }
}

[[nodiscard]] Refusal refusal(abut_status status, const char* argument, std::string_view value, const char* why) {
  return {status, std::string(argument) + " is \"" + std::string(value) + "\"; " + why};
}

}  // namespace

Rules::Rules()
    : kinds_{{"friction", Response::friction, {}},   {"penalty", Response::penalty, {}},
             {"augmented", Response::augmented, {}}, {"stick", Response::stick, {}},
             {"slide", Response::slide, {}},         {"none", Response::none, {}}} {}

std::optional<Refusal> Rules::add_kind(std::string_view name, CustomLaw law) {
  if (name.empty() || name.size() > longest_name)
    return refusal(ABUT_INVALID_ARGUMENT, "name", name, "it must have 1 to 63 bytes");
  if (const auto known = std::ranges::find(kinds_, name, &Kind::name); known != kinds_.end()) {
    if (known->response != Response::custom || known->law)
      return refusal(ABUT_INVALID_ARGUMENT, "name", name, "there is a kind of that name");
    known->law = std::move(law);
    return std::nullopt;
  }
  kinds_.push_back({std::string(name), Response::custom, std::move(law)});
  return std::nullopt;
}

const Kind* Rules::without_law() const {
  const auto found =
      std::ranges::find_if(kinds_, [](const Kind& kind) { return kind.response == Response::custom && !kind.law; });
  return found == kinds_.end() ? nullptr : &*found;
}

std::optional<Refusal> Rules::replaced(std::string_view text, std::string& out) const {
  out.clear();
  while (!text.empty()) {
    const std::size_t start = text.find('$');
    out += text.substr(0, start);
    if (start == std::string_view::npos) return std::nullopt;
    text.remove_prefix(start + 1);
    const std::size_t end = text.find('$');
    if (end == std::string_view::npos)
      return refusal(ABUT_INVALID_ARGUMENT, "parameters", text, "a variable ends with $");
    const auto variable = variables_.find(std::string(text.substr(0, end)));
    if (variable == variables_.end())
      return refusal(ABUT_INVALID_ARGUMENT, "parameters", text.substr(0, end), "there is no variable of that name");
    out += variable->second;
    text.remove_prefix(end + 1);
  }
  return std::nullopt;
}

std::optional<Refusal> Rules::read(std::string_view kind, std::string_view text, std::uint32_t& number,
                                   Parameters& parameters) const {
  const auto found = std::ranges::find(kinds_, kind, &Kind::name);
  if (found == kinds_.end())
    return refusal(ABUT_INVALID_ARGUMENT, "kind", kind, "abut_response_kinds names those that there are");
  number = static_cast<std::uint32_t>(found - kinds_.begin());
  std::string whole;
  if (std::optional<Refusal> refused = replaced(text, whole)) return refused;
  return parameters.read(whole);
}

std::optional<Refusal> Rules::add(const abut_response_side& a, const abut_response_side& b, std::string_view kind,
                                  std::string_view parameters, std::uint32_t& number) {
  Rule rule{.a = a, .b = b, .kind = 0, .parameters = {}};
  if (std::optional<Refusal> refused = read(kind, parameters, rule.kind, rule.parameters)) return refused;
  rules_.push_back(std::move(rule));
  number = static_cast<std::uint32_t>(rules_.size() - 1);
  return std::nullopt;
}

std::optional<Refusal> Rules::set_parameters(std::uint32_t rule, std::string_view parameters) {
  std::string whole;
  if (std::optional<Refusal> refused = replaced(parameters, whole)) return refused;
  return rules_.at(rule).parameters.read(whole);
}

std::optional<Refusal> Rules::set_geometry(abut_geometry_id geometry, std::string_view kind,
                                           std::string_view parameters) {
  Own own{.kind = 0, .parameters = {}};
  if (std::optional<Refusal> refused = read(kind, parameters, own.kind, own.parameters)) return refused;
  own_.insert_or_assign(key_of(geometry), std::move(own));
  return std::nullopt;
}

bool Rules::restore(const abut_response_side& a, const abut_response_side& b, std::uint32_t kind,
                    std::string_view text) {
  Rule rule{.a = a, .b = b, .kind = kind, .parameters = {}};
  if (kind >= kinds_.size() || rule.parameters.read(text)) return false;
  if (a.kind > ABUT_RESPONSE_SIDE_MATERIAL || b.kind > ABUT_RESPONSE_SIDE_MATERIAL) return false;
  rules_.push_back(std::move(rule));
  return true;
}

bool Rules::restore(abut_geometry_id geometry, std::uint32_t kind, std::string_view text) {
  Own own{.kind = kind, .parameters = {}};
  if (kind >= kinds_.size() || own.parameters.read(text)) return false;
  own_.insert_or_assign(key_of(geometry), std::move(own));
  return true;
}

Choice Rules::choose(const GeometryFacts& a, const GeometryFacts& b) const {
  if (!own_.empty()) {
    const bool is_in_order = a.geometry.slot <= b.geometry.slot;
    for (const GeometryFacts* side : {is_in_order ? &a : &b, is_in_order ? &b : &a}) {
      const auto own = own_.find(key_of(side->geometry));
      if (own == own_.end()) continue;
      return {
          .kind = own->second.kind, .parameters = &own->second.parameters, .rule = {}, .of_a_geometry = side->geometry};
    }
  }
  for (std::uint32_t i = 0; i < rules_.size(); ++i) {
    const Rule& rule = rules_[i];
    if ((holds(rule.a, a) && holds(rule.b, b)) || (holds(rule.a, b) && holds(rule.b, a)))
      return {.kind = rule.kind, .parameters = &rule.parameters, .rule = i, .of_a_geometry = {}};
  }
  return {};
}

std::string Rules::explain(const Choice& choice, const Terms& terms) const {
  std::string out;
  if (choice.of_a_geometry) {
    out = "geometry " + std::to_string(choice.of_a_geometry->slot);
  } else {
    out = choice.rule ? "rule " + std::to_string(*choice.rule) : "no rule";
  }
  out += ": " + kinds_.at(choice.kind).name;
  const abut_contact_material& its = terms.material;
  const auto add = [&](const char* name, double value) { out += std::string(", ") + name + " " + text_of(value); };
  add("mu1", its.friction_primary);
  add("mu2", its.friction_secondary);
  add("static", its.static_scale);
  add("compliance", its.compliance);
  add("d", its.damping);
  add("e", its.restitution);
  add("threshold", its.restitution_threshold);
  add("adhesion", its.adhesive_force);
  const Response response = kinds_[choice.kind].response;
  if (response == Response::stick) add("break", terms.break_force);
  if (response == Response::augmented) add("epsilon", terms.epsilon);
  return out;
}

}  // namespace abut::response
