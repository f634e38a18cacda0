// SPDX-License-Identifier: Apache-2.0
#include "geometry_reader.hpp"

#include <algorithm>
#include <array>

#include "pose_reader.hpp"

namespace cli {
namespace {

constexpr std::array<Choice, 3> parkings{
    {{"none", ABUT_PARKING_NONE}, {"short_term", ABUT_PARKING_SHORT_TERM}, {"long_term", ABUT_PARKING_LONG_TERM}}};

constexpr std::array<Choice, 4> flags{{{"fast", ABUT_GEOMETRY_FAST},
                                       {"speculative", ABUT_GEOMETRY_SPECULATIVE},
                                       {"keeps_side", ABUT_GEOMETRY_KEEPS_SIDE},
                                       {"self_pairs", ABUT_GEOMETRY_SELF_PAIRS}}};

// {"files": [...], "scale": 1, "repeat": false}: where the vertices of a mesh are in each step.
std::size_t read_sequence(const Node& node, Scene& scene) {
  Fields fields(node);
  const std::vector<Node> files = fields.need("files").list("files of a sequence, one for each step");
  const auto scale = fields.find("scale");
  const auto repeat = fields.find("repeat");
  fields.done();
  if (files.empty()) {
    node.refuse("at least one file");
  }
  Sequence sequence{node.path(), {}, repeat && repeat->flag()};
  for (const Node& file : files) {
    std::vector<double> vertices = scene.shapes.vertices_of(file);
    const double factor = scale ? scale->positive() : 1.0;
    std::ranges::transform(vertices, vertices.begin(), [&](double each) { return each * factor; });
    if (!sequence.vertices.empty() && vertices.size() != sequence.vertices[0].size()) {
      file.refuse("a file with as many vertices as the first one, which has " +
                  std::to_string(sequence.vertices[0].size() / 3));
    }
    sequence.vertices.push_back(std::move(vertices));
  }
  scene.sequences.push_back(std::move(sequence));
  return scene.sequences.size() - 1;
}

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
  for (const Choice& flag : flags) {
    if (const auto chosen = fields.find(std::string(flag.name)); chosen && chosen->flag()) {
      geometry.options.flags |= flag.value;
    }
  }
  if (const auto sequence = fields.find("sequence")) {
    geometry.sequence = read_sequence(*sequence, scene);
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
