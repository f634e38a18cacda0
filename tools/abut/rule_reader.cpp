// SPDX-License-Identifier: Apache-2.0
#include "rule_reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "algorithms.hpp"
#include "nearest.hpp"

namespace cli {
namespace {

constexpr std::array<Choice, 2> effects{{{"enable", ABUT_RULE_ENABLE}, {"disable", ABUT_RULE_DISABLE}}};
constexpr std::array<Choice, 5> details{{{"manifold", ABUT_DETAIL_MANIFOLD},
                                         {"point", ABUT_DETAIL_POINT},
                                         {"box", ABUT_DETAIL_BOX},
                                         {"touch", ABUT_DETAIL_TOUCH},
                                         {"elements", ABUT_DETAIL_ELEMENTS}}};

constexpr std::array<std::pair<const char*, double abut_policy::*>, 4> of_elements{
    {{"contact_distance", &abut_policy::contact_distance},
     {"rest_distance", &abut_policy::rest_distance},
     {"cone_angle", &abut_policy::cone_angle},
     {"cone_factor", &abut_policy::cone_factor}}};

// The parts that a name means: all copies of an entry, or one copy such as "crate[2]".
std::vector<std::size_t> parts_named(const Node& node, const PartRanges& ranges, const Scene& scene) {
  const std::string& name = node.text();
  const auto found = ranges.find(name.substr(0, name.find('[')));
  std::vector<std::size_t> parts;
  if (found != ranges.end()) {
    const bool all = found->first == name;
    for (std::size_t i = found->second.first; i < found->second.second; ++i) {
      if (all || scene.parts[i].name == name) {
        parts.push_back(i);
      }
    }
  }
  if (parts.empty()) {
    std::vector<std::string> known;
    for (const auto& [each, range] : ranges) {
      known.push_back(each);
    }
    node.refuse("the name of a part of the scene" + what_there_is("part with a name", name, known));
  }
  return parts;
}

std::vector<Collidable> geometries_named(const Node& node, const std::vector<std::size_t>& parts, const Scene& scene) {
  const std::string& name = node.text();
  std::vector<Collidable> collidables;
  for (const std::size_t part : parts) {
    // Geometries are ordered by their parts.
    const auto [begin, end] =
        std::equal_range(scene.geometries.begin(), scene.geometries.end(), Geometry{part, "", {}, {}, Part::no_script},
                         [](const Geometry& a, const Geometry& b) { return a.part < b.part; });
    const auto found = std::find_if(begin, end, [&](const Geometry& geometry) { return geometry.name == name; });
    if (found == end) {
      std::vector<std::string> known;
      std::transform(begin, end, std::back_inserter(known), [](const Geometry& geometry) { return geometry.name; });
      node.refuse("the name of a geometry of the part" + what_there_is("geometry", name, known));
    }
    collidables.push_back({ABUT_COLLIDABLE_GEOMETRY, static_cast<std::size_t>(found - scene.geometries.begin())});
  }
  return collidables;
}

std::vector<Collidable> read_collidables(const Node& node, const PartRanges& ranges, const Scene& scene) {
  if (node.is_text() && node.text() == "any") {
    return {{ABUT_COLLIDABLE_ANY, 0}};
  }
  if (!node.is_object()) {
    node.refuse("\"any\", {\"label\": ...}, {\"part\": ...} or {\"part\": ..., \"geometry\": ...}");
  }
  Fields fields(node);
  const auto label = fields.find("label");
  const auto part = fields.find("part");
  const auto geometry = fields.find("geometry");
  fields.done();
  if (label.has_value() == part.has_value() || (geometry && !part)) {
    node.refuse("either a label, or a part with or without one of its geometries");
  }
  if (label) {
    return {{ABUT_COLLIDABLE_LABEL, scene.labels.number(*label)}};
  }
  const std::vector<std::size_t> parts = parts_named(*part, ranges, scene);
  if (geometry) {
    return geometries_named(*geometry, parts, scene);
  }
  std::vector<Collidable> collidables;
  for (const std::size_t index : parts) {
    collidables.push_back({ABUT_COLLIDABLE_PART, index});
  }
  return collidables;
}

std::pair<std::uint32_t, std::uint32_t> read_tags(const Node& node, const Names& tags) {
  const std::vector<Node> both = node.is_list() ? node.list("tags") : std::vector<Node>{};
  if (both.size() != 2) {
    node.refuse("two tags, by name or number");
  }
  return {tags.number(both[0]), tags.number(both[1])};
}

abut_policy read_policy(Fields& fields) {
  abut_policy policy;
  abut_policy_init(&policy, sizeof policy);
  if (const auto algorithm = fields.find("algorithm")) {
    policy.algorithm = algorithm->choice(algorithms);
  }
  if (const auto detail = fields.find("detail")) {
    policy.detail = detail->choice(details);
  }
  if (const auto period = fields.find("period")) {
    policy.period = period->whole32(1);
  }
  if (const auto tolerance = fields.find("tolerance")) {
    policy.tolerance = tolerance->not_negative();
  }
  if (const auto error_bound = fields.find("error_bound")) {
    policy.error_bound = error_bound->not_negative();
  }
  if (const auto time_budget = fields.find("time_budget")) {
    policy.time_budget = time_budget->not_negative();
  }
  for (const auto& [name, member] : of_elements) {
    if (const auto value = fields.find(name)) {
      policy.*member = value->not_negative();
    }
  }
  return policy;
}

}  // namespace

void read_rules(const std::optional<Node>& node, const PartRanges& ranges, Scene& scene) {
  if (!node) {
    return;
  }
  constexpr std::size_t most = 1'000'000;
  for (const Node& element : node->list("rules")) {
    Fields fields(element);
    const std::vector<Collidable> a = read_collidables(fields.need("a"), ranges, scene);
    const std::vector<Collidable> b = read_collidables(fields.need("b"), ranges, scene);
    const abut_rule rule = fields.need("rule").choice(effects);
    fields.done();
    if (a.size() * b.size() > most) {
      element.refuse("at most " + std::to_string(most) + " pairs in a rule; give the geometries labels and name these");
    }
    for (const Collidable& one : a) {
      for (const Collidable& other : b) {
        scene.rules.push_back({element.path(), one, other, rule});
      }
    }
  }
}

void read_policies(const std::optional<Node>& node, Scene& scene) {
  if (!node) {
    return;
  }
  for (const Node& element : node->list("policies")) {
    Fields fields(element);
    const auto [a, b] = read_tags(fields.need("tags"), scene.tags);
    const abut_policy policy = read_policy(fields);
    fields.done();
    scene.policies.push_back({element.path(), a, b, policy});
  }
}

void read_focus(const std::optional<Node>& node, Scene& scene) {
  if (!node) {
    return;
  }
  Fields fields(*node);
  Focus its;
  abut_focus_init(&its.focus, sizeof its.focus);
  for (const Node& centre : fields.need("centres").list("centres")) {
    its.centres.push_back(centre.vector());
  }
  its.focus.near_tag = scene.tags.number(fields.need("near_tag"));
  its.focus.far_tag = scene.tags.number(fields.need("far_tag"));
  its.focus.near_distance = fields.need("near_distance").not_negative();
  its.focus.far_distance = fields.need("far_distance").not_negative();
  fields.done();
  scene.focus = its;
}

}  // namespace cli
