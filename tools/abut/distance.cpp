// SPDX-License-Identifier: Apache-2.0
#include "distance.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "algorithms.hpp"
#include "commands.hpp"
#include "digits.hpp"
#include "document.hpp"
#include "encounter.hpp"
#include "output_file.hpp"
#include "pose_reader.hpp"

namespace cli {
namespace {

struct Found {
  std::string a, b;  // names with kinds
  abut_distance distance;
};

nlohmann::ordered_json list_of(const abut_vec3& v) { return {v.x, v.y, v.z}; }

std::string text_of(const Found& found) {
  const abut_distance& its = found.distance;
  return found.a + " and " + found.b + "\n  distance    " + digits(its.distance) +
         (its.upper < 0.0 ? ", a depth" : "") + "\n  interval    [" + digits(its.lower) + ", " + digits(its.upper) +
         "]" + (std::isinf(its.upper) ? ", as holes have left nothing to be met" : "") + "\n  normal      " +
         digits(its.normal) + " from A to B\n  point of A  " + digits(its.point_a) + "\n  point of B  " +
         digits(its.point_b) + "\n  found by    " + algorithm_name(its.algorithm) + " in " +
         counted(its.iterations, "step") + "\n";
}

std::string json_of(const Found& found) {
  const abut_distance& its = found.distance;
  const nlohmann::ordered_json json{{"a", found.a},
                                    {"b", found.b},
                                    {"distance", its.distance},
                                    {"lower", its.lower},
                                    {"upper", its.upper},
                                    {"normal", list_of(its.normal)},
                                    {"point_a", list_of(its.point_a)},
                                    {"point_b", list_of(its.point_b)},
                                    {"by", algorithm_name(its.algorithm)},
                                    {"steps", its.iterations}};
  return json.dump(2) + "\n";
}

// The least one of all geometries of two parts.
Found nearest_of(const Arguments& arguments) {
  const World world = world_at_last_step(arguments);
  const std::vector<Placed> a = find_placed(world, arguments.operands[1]);
  const std::vector<Placed> b = find_placed(world, arguments.operands[2]);
  std::optional<Found> least;
  for (const Placed& one : a) {
    for (const Placed& other : b) {
      const auto distance = distance_between(one.shape, one.pose, other.shape, other.pose);
      if (distance && (!least || distance->distance < least->distance.distance)) {
        least = {shown(one), shown(other), *distance};
      }
    }
  }
  if (!least) {
    throw BadInput(shown(a.front()) + " and " + shown(b.front()) +
                   " have no distance; abut pairs lists which kinds have one");
  }
  return *least;
}

struct Written {
  const abut_shape* shape;
  abut_pose pose;
};

// A shape as JSON, or an object with a shape and a pose.
Written read_written(Shapes& shapes, const std::string& text, const std::string& name) {
  if (!text.starts_with('{')) {
    throw BadInput(
        name + " is '" + printable(text) +
        "'; expected a shape as JSON, such as {\"kind\": \"sphere\", \"radius\": 1}, or a scene before A and B");
  }
  try {
    const Json json = read_text(text);
    const Node node(json, name);
    if (!node.has("shape")) {
      return {shapes.resolve(node), identity_pose};
    }
    Fields fields(node);
    const Written its{shapes.resolve(fields.need("shape")), read_pose(fields.find("pose"))};
    fields.done();
    return its;
  } catch (const BadInput& failure) {
    throw BadInput("the command line: " + std::string(failure.what()));
  }
}

Found of_written(const Arguments& arguments) {
  Shapes shapes{std::filesystem::path()};
  const Written a = read_written(shapes, arguments.operands[0], "A");
  const Written b = read_written(shapes, arguments.operands[1], "B");
  const auto distance = distance_between(a.shape, a.pose, b.shape, b.pose);
  if (!distance) {
    throw BadInput(kind_name(a.shape) + " and " + kind_name(b.shape) +
                   " have no distance; abut pairs lists which kinds have one");
  }
  return {"A (" + kind_name(a.shape) + ")", "B (" + kind_name(b.shape) + ")", *distance};
}

}  // namespace

void print_distance(const Arguments& arguments) {
  const Found found = arguments.operands.size() == 2 ? of_written(arguments) : nearest_of(arguments);
  print(arguments.json ? json_of(found) : text_of(found));
}

}  // namespace cli
