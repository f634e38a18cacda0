// SPDX-License-Identifier: Apache-2.0
#include "dynamics_reader.hpp"

#include <array>
#include <utility>

namespace cli {
namespace {

constexpr std::array<Choice, 2> solvers{{{"newton", ABUT_SOLVER_NEWTON}, {"sweeps", ABUT_SOLVER_SWEEPS}}};
constexpr std::array<std::pair<const char*, double abut_contact_material::*>, 5> numbers{
    {{"restitution", &abut_contact_material::restitution},
     {"restitution_threshold", &abut_contact_material::restitution_threshold},
     {"compliance", &abut_contact_material::compliance},
     {"damping", &abut_contact_material::damping},
     {"static_scale", &abut_contact_material::static_scale}}};

}  // namespace

void read_response(const std::optional<Node>& node, Scene& scene) {
  if (!node) {
    return;
  }
  Fields fields(*node);
  Response its;
  if (const auto gravity = fields.find("gravity")) {
    its.gravity = gravity->vector();
  }
  if (const auto solver = fields.find("solver")) {
    its.solver = solver->choice(solvers);
  }
  if (const auto tolerance = fields.find("tolerance")) {
    its.tolerance = tolerance->not_negative();
  }
  if (const auto slop = fields.find("slop")) {
    its.slop = slop->not_negative();
  }
  if (const auto impacts = fields.find("impacts")) {
    its.has_impacts = impacts->flag();
  }
  fields.done();
  if (!(scene.dt > 0)) {
    node->refuse("a scene with a dt above 0");
  }
  scene.response = its;
}

void read_material_pairs(const std::optional<Node>& node, Scene& scene) {
  if (!node) {
    return;
  }
  for (const Node& pair : node->list("pairs of materials")) {
    Fields fields(pair);
    const Node materials = fields.need("materials");
    if (!materials.is_list() || materials.size() != 2) {
      materials.refuse("two materials");
    }
    const std::vector<Node> two = materials.list("materials");
    MaterialPair its{pair.path(), scene.materials.number(two[0]), scene.materials.number(two[1]), {}};
    abut_contact_material_init(&its.material, sizeof its.material);
    if (const auto friction = fields.find("friction")) {
      its.material.friction_primary = its.material.friction_secondary = friction->not_negative();
    }
    for (const auto& [name, number] : numbers) {
      if (const auto value = fields.find(name)) {
        its.material.*number = value->not_negative();
      }
    }
    fields.done();
    scene.material_pairs.push_back(its);
  }
}

}  // namespace cli
