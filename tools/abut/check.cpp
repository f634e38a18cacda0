// SPDX-License-Identifier: Apache-2.0
#include "check.hpp"

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "digits.hpp"
#include "document.hpp"
#include "encounter.hpp"
#include "output_file.hpp"

namespace cli {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<abut_finding> findings_of(const World& world) {
  std::size_t count = 0;
  check(abut_universe_validate(world.universe(), nullptr, 0, &count), "cannot validate the scene");
  std::vector<abut_finding> findings(count);
  check(abut_universe_validate(world.universe(), findings.data(), count, &count), "cannot validate the scene");
  return findings;
}

std::string name_of(const World& world, abut_geometry_id id) {
  return id.slot == 0 ? "" : world.part_name(id) + "/" + world.geometry_name(id);
}

std::string sentence_of(const World& world, const abut_finding& finding) {
  const std::string a = name_of(world, finding.geometry), b = name_of(world, finding.other);
  const std::string who = a + (b.empty() ? "" : " and " + b);
  return "odd: " + (who.empty() ? "" : who + ": ") + finding.message + "\n";
}

bool check_whole(const Arguments& arguments, const World& world) {
  const std::vector<abut_finding> findings = findings_of(world);
  const abut_step_stats stats = stats_of(world.universe());
  OrderedJson json{{"parts", stats.parts},
                   {"geometries", stats.geometries},
                   {"touching_pairs", stats.touching_pairs},
                   {"contacts", stats.contacts},
                   {"findings", OrderedJson::array()}};
  std::string text = shown_name(arguments.operands[0]) + ": " + counted(stats.parts, "part") + ", " +
                     std::to_string(stats.geometries) + (stats.geometries == 1 ? " geometry; " : " geometries; ") +
                     counted(stats.touching_pairs, "pair") + (stats.touching_pairs == 1 ? " touches" : " touch") +
                     " at step " + std::to_string(world.scene().steps) + "\n";
  for (const abut_finding& finding : findings) {
    json["findings"].push_back(
        {{"a", name_of(world, finding.geometry)}, {"b", name_of(world, finding.other)}, {"message", finding.message}});
    text += sentence_of(world, finding);
  }
  text += findings.empty() ? "nothing odd was found\n" : "";
  print(arguments.json ? json.dump(2) + "\n" : text);
  return !findings.empty();
}

std::string text_of(const Encounter& its, std::uint64_t step) {
  const std::string at = " at step " + std::to_string(step);
  const auto pad = [](std::string word, std::size_t width) {
    word.resize(std::max(word.size(), width), ' ');
    return word;
  };
  const std::string found =
      its.elements > 0 ? counted(its.elements, "element contact") : counted(its.contacts, "contact");
  std::string text =
      shown(its.a) + " and " + shown(its.b) +
      (its.touches ? " touch" + at + ": " + found + "\n" : " do not touch" + at + ": " + its.stopped_by + "\n");
  for (const GateAnswer& answer : its.answers) {
    text += "  " + pad(std::string(answer.name), 10) + (answer.is_open ? "yes  " : "NO   ") + answer.says + "\n";
  }
  return text;
}

OrderedJson json_of(const Encounter& its) {
  OrderedJson json{{"a", its.a.name},
                   {"kind_a", kind_name(its.a.shape)},
                   {"b", its.b.name},
                   {"kind_b", kind_name(its.b.shape)},
                   {"touch", its.touches},
                   {"contacts", its.contacts},
                   {"element_contacts", its.elements},
                   {"stopped_by", nullptr},
                   {"distance", nullptr},
                   {"answers", OrderedJson::array()}};
  if (!its.touches) {
    json["stopped_by"] = its.stopped_by;
  }
  if (its.distance) {
    json["distance"] = its.distance->distance;
  }
  for (const GateAnswer& answer : its.answers) {
    json["answers"].push_back({{"name", answer.name}, {"yes", answer.is_open}, {"says", answer.says}});
  }
  return json;
}

void check_pairs(const Arguments& arguments, const World& world) {
  constexpr std::size_t most = 100;
  const std::string &name_a = arguments.operands[1], &name_b = arguments.operands[2];
  const std::vector<Placed> a = find_placed(world, name_a), b = find_placed(world, name_b);
  if (a.size() * b.size() > most) {
    throw BadInput("'" + name_a + "' has " + std::to_string(a.size()) + " geometries and '" + name_b + "' has " +
                   std::to_string(b.size()) + "; expected at most " + std::to_string(most) +
                   " pairs: name some as PART/GEOMETRY");
  }
  const Encounters encounters(world);
  std::string text;
  OrderedJson json = OrderedJson::array();
  for (const Placed& one : a) {
    for (const Placed& other : b) {
      if (one.index != other.index) {
        const Encounter its = encounters.between(one.index, other.index);
        text += text_of(its, world.scene().steps);
        json.push_back(json_of(its));
      }
    }
  }
  if (text.empty()) {
    throw BadInput("'" + name_a + "' and '" + name_b + "' are one geometry; expected two");
  }
  print(arguments.json ? json.dump(2) + "\n" : text);
}

}  // namespace

bool check_scene(const Arguments& arguments) {
  const World world = world_at_last_step(arguments);
  if (arguments.operands.size() == 1) {
    return check_whole(arguments, world);
  }
  check_pairs(arguments, world);
  return false;
}

}  // namespace cli
