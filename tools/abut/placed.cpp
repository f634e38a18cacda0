// SPDX-License-Identifier: Apache-2.0
#include "placed.hpp"

#include "failures.hpp"
#include "nearest.hpp"

namespace cli {
namespace {

std::string whole_name(const Scene& scene, const Geometry& geometry) {
  return scene.parts[geometry.part].name + "/" + geometry.name;
}

// All parts, or what the part has if the word names one of them.
[[noreturn]] void refuse(const Scene& scene, const std::string& word) {
  const std::string part = word.substr(0, word.find('/'));
  std::vector<std::string> parts, geometries;
  for (const Part& each : scene.parts) {
    parts.push_back(each.name);
  }
  for (const Geometry& each : scene.geometries) {
    if (scene.parts[each.part].name == part) {
      geometries.push_back(whole_name(scene, each));
    }
  }
  const std::string there =
      geometries.empty() ? what_there_is("part", part, parts) : what_there_is("geometry", word, geometries);
  throw BadInput("there is no geometry '" + word + "'; expected PART or PART/GEOMETRY" + there);
}

}  // namespace

Placed placed(const World& world, std::size_t index) {
  const Geometry& geometry = world.scene().geometries.at(index);
  return {index, whole_name(world.scene(), geometry), world.shape_of(index), world.pose_of(index)};
}

std::vector<Placed> find_placed(const World& world, const std::string& name) {
  std::vector<Placed> found;
  for (std::size_t i = 0; i < world.scene().geometries.size(); ++i) {
    const Geometry& geometry = world.scene().geometries[i];
    if (name == world.scene().parts[geometry.part].name || name == whole_name(world.scene(), geometry)) {
      found.push_back(placed(world, i));
    }
  }
  if (found.empty()) {
    refuse(world.scene(), name);
  }
  return found;
}

std::string kind_name(const abut_shape* shape) { return abut_shape_kind_name(abut_shape_kind_of(shape)); }

std::string shown(const Placed& its) { return its.name + " (" + kind_name(its.shape) + ")"; }

}  // namespace cli
