// SPDX-License-Identifier: Apache-2.0
#include "part_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry_reader.hpp"
#include "pose_reader.hpp"
#include "repetition.hpp"

namespace cli {
namespace {

constexpr std::array<Choice, 3> motions{
    {{"dynamic", ABUT_MOTION_DYNAMIC}, {"animated", ABUT_MOTION_ANIMATED}, {"static", ABUT_MOTION_STATIC}}};
constexpr std::array<std::pair<const char*, double abut_sleep::*>, 4> thresholds{
    {{"linear_speed", &abut_sleep::linear_speed},
     {"linear_acceleration", &abut_sleep::linear_acceleration},
     {"angular_speed", &abut_sleep::angular_speed},
     {"angular_acceleration", &abut_sleep::angular_acceleration}}};

// The default thresholds, or some of its own.
std::optional<abut_sleep> read_sleep(const std::optional<Node>& node) {
  if (!node || (!node->is_object() && !node->flag())) {
    return std::nullopt;
  }
  abut_sleep sleep;
  abut_sleep_init(&sleep, sizeof sleep);
  if (!node->is_object()) {
    return sleep;
  }
  Fields fields(*node);
  if (const auto steps = fields.find("steps")) {
    sleep.steps = steps->whole32(1);
  }
  for (const auto& [name, threshold] : thresholds) {
    if (const auto limit = fields.find(name)) {
      sleep.*threshold = limit->not_negative();
    }
  }
  fields.done();
  return sleep;
}

// {"linear": ..., "spin": ...}, or "measured".
void read_velocity(const Node& node, Part& part) {
  if (node.is_text()) {
    if (node.text() != "measured") {
      node.refuse("\"measured\", or an object with linear and spin");
    }
    part.is_measured = true;
    return;
  }
  Fields fields(node);
  abut_velocity velocity{};
  if (const auto linear = fields.find("linear")) {
    velocity.linear = linear->vector();
  }
  if (const auto spin = fields.find("spin")) {
    Fields turning(*spin);
    const abut_vec3 axis = turning.need("axis").direction();
    const double degrees = turning.need("degrees_per_second").number();
    turning.done();
    constexpr double radians_per_degree = 0.017453292519943295;
    velocity.angular =
        axis * (degrees * radians_per_degree / std::sqrt(axis.x * axis.x + axis.y * axis.y + axis.z * axis.z));
  }
  fields.done();
  part.velocity = velocity;
}

// Of a body, where the scene has a response.
void read_mass(Fields& fields, Part& part) {
  const auto density = fields.find("density"), mass = fields.find("mass");
  if (density) {
    part.density = density->positive();
  }
  if (mass) {
    part.mass = mass->positive();
    if (density) {
      mass->refuse("a mass or a density, not both");
    }
  }
}

void read_part(const Node& node, Scene& scene, PartRanges& ranges) {
  Fields fields(node);
  const std::size_t first = scene.parts.size();
  Part part;
  const auto name = fields.find("name");
  part.name = name ? name->name() : node.path();
  if (const auto motion = fields.find("motion")) {
    part.motion = motion->choice(motions);
  }
  part.sleep = read_sleep(fields.find("sleep"));
  if (const auto velocity = fields.find("velocity")) {
    read_velocity(*velocity, part);
  }
  read_mass(fields, part);
  const abut_pose pose = read_pose(fields.find("pose"));
  if (const auto script = fields.find("script")) {
    if (part.motion == ABUT_MOTION_STATIC) {
      script->refuse("no script on a static part; \"animated\" and \"dynamic\" ones may have one");
    }
    part.script = scene.scripts.size();
    scene.scripts.push_back(read_script(*script));
  }
  const std::vector<Geometry> geometries = read_geometries(fields.need("geometries"), scene);
  for (Copy& copy : read_copies(fields, pose)) {
    Part& made = scene.parts.emplace_back(part);
    made.name += copy.suffix;
    made.pose = copy.pose;
    for (const Geometry& geometry : geometries) {
      scene.geometries.push_back(geometry);
      scene.geometries.back().part = scene.parts.size() - 1;
    }
  }
  fields.done();
  if (name && !ranges.try_emplace(name->text(), first, scene.parts.size()).second) {
    name->refuse("a name that no other part has");
  }
}

}  // namespace

PartRanges read_parts(const Node& node, Scene& scene) {
  PartRanges ranges;
  for (const Node& part : node.list("parts")) {
    read_part(part, scene, ranges);
  }
  return ranges;
}

}  // namespace cli
