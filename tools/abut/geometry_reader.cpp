// SPDX-License-Identifier: Apache-2.0
#include "geometry_reader.hpp"

#include <algorithm>
#include <array>

#include "pose_reader.hpp"

namespace cli {
namespace {

constexpr std::array<Choice, 3> parkings{
    {{"none", ABUT_PARKING_NONE}, {"short_term", ABUT_PARKING_SHORT_TERM}, {"long_term", ABUT_PARKING_LONG_TERM}}};

// Whom it meets: layers, mask, exclusion, label and parking.
void read_filters(Fields& fields, const Scene& scene, abut_geometry_options& options) {
  if (const auto layers = fields.find("layers")) {
    options.layers = scene.layers.bits(*layers);
  }
  if (const auto mask = fields.find("mask")) {
    options.mask = scene.layers.bits(*mask);
  }
  if (const auto exclusion = fields.find("exclusion")) {
    options.exclusion = scene.exclusions.bits(*exclusion);
  }
  if (const auto label = fields.find("label")) {
    options.label = scene.labels.number(*label);
  }
  if (const auto parking = fields.find("parking")) {
    options.parking = parking->choice(parkings);
  }
}

Geometry read_geometry(const Node& node, Scene& scene) {
  Fields fields(node);
  Geometry geometry{};
  abut_geometry_options_init(&geometry.options, sizeof geometry.options);
  geometry.shape = scene.shapes.resolve(fields.need("shape"));
  geometry.options.pose = read_pose(fields.find("pose"));
  if (const auto name = fields.find("name")) {
    geometry.name = name->name();
  }
  if (const auto tolerance = fields.find("tolerance")) {
    geometry.options.tolerance = tolerance->not_negative();
  }
  if (const auto sensor = fields.find("sensor"); sensor && sensor->flag()) {
    geometry.options.flags |= ABUT_GEOMETRY_SENSOR;
  }
  if (const auto tag = fields.find("tag")) {
    geometry.options.tag = scene.tags.number(*tag);
  }
  if (const auto material = fields.find("material")) {
    geometry.options.material = scene.materials.number(*material);
  }
  read_filters(fields, scene, geometry.options);
  fields.done();
  return geometry;
}

}  // namespace

std::vector<Geometry> read_geometries(const Node& node, Scene& scene) {
  std::vector<Geometry> geometries;
  for (const Node& element : node.list("geometries, each with a shape")) {
    Geometry geometry = read_geometry(element, scene);
    if (geometry.name.empty()) {
      geometry.name = std::to_string(geometries.size());
    }
    const auto has_name = [&](const Geometry& other) { return other.name == geometry.name; };
    if (std::any_of(geometries.begin(), geometries.end(), has_name)) {
      element.refuse("a name that no other geometry of the part has; without one it is its number, from 0");
    }
    geometries.push_back(std::move(geometry));
  }
  return geometries;
}

}  // namespace cli
