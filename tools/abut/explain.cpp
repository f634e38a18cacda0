// SPDX-License-Identifier: Apache-2.0
#include "explain.hpp"

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "digits.hpp"
#include "near_pairs.hpp"
#include "output_file.hpp"
#include "placed.hpp"

namespace cli {
namespace {

std::string text_of(const World& world, const std::vector<KeptApart>& kept) {
  std::string text = "boxes that overlap and never meet\n";
  for (const KeptApart& its : kept) {
    text += "  " + std::string(its.gate) + ": " + counted(its.pairs, "pair") + (its.pairs == 1 ? ", " : ", such as ") +
            placed(world, its.example.first).name + " and " + placed(world, its.example.second).name + "\n";
  }
  return text + (kept.empty() ? "  none\n" : "");
}

nlohmann::ordered_json json_of(const World& world, const std::vector<KeptApart>& kept) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const KeptApart& its : kept) {
    json.push_back({{"by", its.gate},
                    {"pairs", its.pairs},
                    {"a", placed(world, its.example.first).name},
                    {"b", placed(world, its.example.second).name}});
  }
  return json;
}

}  // namespace

void explain(const Arguments& arguments) {
  const World world = world_at_last_step(arguments);
  const std::vector<KeptApart> kept = kept_apart(world);
  if (!arguments.json) {
    print(plan_of(world.universe()) + text_of(world, kept));
    return;
  }
  nlohmann::ordered_json plan = nlohmann::ordered_json::parse(json_plan_of(world.universe()));
  plan["kept_apart"] = json_of(world, kept);
  print(plan.dump(2) + "\n");
}

}  // namespace cli
