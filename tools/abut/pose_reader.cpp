// SPDX-License-Identifier: Apache-2.0
#include "pose_reader.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace cli {
namespace {

abut_quat read_quaternion(const Node& node) {
  const Json& json = node.json();
  const auto is_number = [](const Json& element) { return element.is_number(); };
  if (!json.is_array() || json.size() != 4 || !std::all_of(json.begin(), json.end(), is_number)) {
    node.refuse("four numbers, [w, x, y, z]");
  }
  const abut_quat q{json[0].get<double>(), json[1].get<double>(), json[2].get<double>(), json[3].get<double>()};
  // What the library takes as well.
  if (!(std::abs(norm(q) - 1.0) <= 1e-3)) {
    node.refuse("a unit quaternion [w, x, y, z], of length 1 within 0.001");
  }
  return unit(q);
}

}  // namespace

abut_pose read_pose_fields(Fields& fields) {
  abut_pose pose = identity_pose;
  if (const auto position = fields.find("position")) {
    pose.position = position->vector();
  }
  const auto quaternion = fields.find("quaternion");
  const auto axis = fields.find("axis");
  const auto degrees = fields.find("degrees");
  if (quaternion && (axis || degrees)) {
    fields.node().refuse("either a quaternion or an axis with degrees, not both");
  }
  if (quaternion) {
    pose.orientation = read_quaternion(*quaternion);
  } else if (axis || degrees) {
    pose.orientation = turn_by(fields.need("axis").direction(), fields.need("degrees").number());
  }
  return pose;
}

abut_pose read_pose(const std::optional<Node>& node) {
  if (!node) {
    return identity_pose;
  }
  Fields fields(*node);
  const abut_pose pose = read_pose_fields(fields);
  fields.done();
  return pose;
}

}  // namespace cli
