// SPDX-License-Identifier: Apache-2.0
#include "scene.hpp"

#include <array>

#include <nlohmann/json.hpp>

#include "document.hpp"
#include "dynamics_reader.hpp"
#include "part_reader.hpp"
#include "rule_reader.hpp"

namespace cli {
namespace {

constexpr std::array<Choice, 5> broadphases{{{"auto", ABUT_BROADPHASE_AUTO},
                                             {"brute", ABUT_BROADPHASE_BRUTE},
                                             {"tree", ABUT_BROADPHASE_TREE},
                                             {"sweep_and_prune", ABUT_BROADPHASE_SWEEP_AND_PRUNE},
                                             {"hash_grid", ABUT_BROADPHASE_HASH_GRID}}};
constexpr std::array<Choice, 2> tolerance_modes{
    {{"dead_band", ABUT_TOLERANCE_DEAD_BAND}, {"margin", ABUT_TOLERANCE_MARGIN}}};
constexpr std::array<Choice, 4> event_kinds{{{"pairs", ABUT_EVENTS_PAIRS},
                                             {"persist", ABUT_EVENTS_PERSIST},
                                             {"contacts", ABUT_EVENTS_CONTACTS},
                                             {"elements", ABUT_EVENTS_ELEMENTS}}};

void read_units(const std::optional<Node>& node, Scene& scene) {
  if (!node) {
    return;
  }
  Fields fields(*node);
  if (const auto length = fields.find("length")) {
    scene.length_unit = length->name();
  }
  if (const auto time = fields.find("time")) {
    scene.time_unit = time->name();
  }
  fields.done();
}

void read_universe(const std::optional<Node>& node, Scene& scene) {
  abut_universe_options& options = scene.universe;
  abut_universe_options_init(&options, sizeof options);
  if (!node) {
    return;
  }
  Fields fields(*node);
  if (const auto broadphase = fields.find("broadphase")) {
    options.broadphase = broadphase->choice(broadphases);
  }
  if (const auto mode = fields.find("tolerance_mode")) {
    options.tolerance_mode = mode->choice(tolerance_modes);
  }
  if (const auto most = fields.find("max_contacts")) {
    options.max_contacts = most->whole32(0);
  }
  if (const auto most = fields.find("max_pair_contacts")) {
    options.max_pair_contacts = most->whole32(0);
  }
  if (const auto welds = fields.find("welds"); welds && welds->flag()) {
    options.flags |= ABUT_UNIVERSE_WELDS;
  }
  if (const auto islands = fields.find("islands")) {
    scene.follows_islands = islands->flag();
  }
  if (const auto origin = fields.find("origin")) {
    options.origin = origin->vector();
  }
  if (const auto threads = fields.find("threads")) {
    options.threads = threads->whole32(0, 1024);
  }
  if (const auto events = fields.find("events")) {
    options.events = 0;
    for (const Node& kind : events->list("events: " + listed(event_kinds))) {
      options.events |= kind.choice(event_kinds);
    }
  }
  fields.done();
}

void read_names(Fields& fields, Scene& scene) {
  scene.layers.read(fields.find("layers"));
  scene.exclusions.read(fields.find("exclusions"));
  scene.labels.read(fields.find("labels"));
  scene.tags.read(fields.find("tags"));
  scene.materials.read(fields.find("materials"));
}

Scene read(const Json& document, const std::filesystem::path& folder) {
  Fields fields(Node(document, ""));
  if (const Node version = fields.need("version"); version.json() != 1) {
    version.refuse("1, the version of the format that this program reads");
  }
  Scene scene(folder);
  read_units(fields.find("units"), scene);
  read_universe(fields.find("universe"), scene);
  if (const auto steps = fields.find("steps")) {
    scene.steps = steps->whole(1, 1'000'000'000);
  }
  if (const auto dt = fields.find("dt")) {
    scene.dt = dt->not_negative();
  }
  read_names(fields, scene);
  scene.shapes.read(fields.find("shapes"));
  const PartRanges ranges = read_parts(fields.need("parts"), scene);
  read_rules(fields.find("rules"), ranges, scene);
  read_policies(fields.find("policies"), scene);
  read_focus(fields.find("focus"), scene);
  read_material_pairs(fields.find("material_pairs"), scene);
  read_response(fields.find("response"), scene);
  fields.done();
  scene.shapes.forget_document();
  return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& path) {
  try {
    const Json document = read_document(path);
    return read(document, path.parent_path());
  } catch (const BadInput& failure) {
    throw BadInput(shown_name(path) + ": " + failure.what());
  }
}

}  // namespace cli
