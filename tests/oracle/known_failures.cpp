#include "known_failures.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace oracle {

namespace {

using Json = nlohmann::json;

std::vector<Point> points_of(const Json& list) {
  std::vector<Point> points;
  for (const Json& p : list) points.push_back({p[0].get<double>(), p[1].get<double>(), p[2].get<double>()});
  return points;
}

std::optional<FailureShape> read_shape(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  FailureShape shape;
  shape.type = json.value("type", "");
  if (shape.type == "sphere") {
    shape.parameters = {json["radius"].get<double>()};
    shape.body = make_sphere(shape.parameters[0]);
  } else if (shape.type == "box") {
    for (const Json& half : json["half"]) shape.parameters.push_back(half.get<double>());
    shape.body = make_box(shape.parameters[0], shape.parameters[1], shape.parameters[2]);
  } else if (shape.type == "capsule") {
    shape.parameters = {json["radius"].get<double>(), json["half_length"].get<double>()};
    shape.body = make_capsule(shape.parameters[0], shape.parameters[1]);
  } else if (shape.type == "convex" || shape.type == "triangle") {
    shape.body = make_hull(points_of(json["vertices"]));
  } else {
    return std::nullopt;
  }
  return shape;
}

FailurePose read_pose(const Json& pose, const Json& shape) {
  FailurePose result;
  for (std::size_t i = 0; i < 3; ++i) result.position[i] = pose["p"][i].get<double>();
  for (std::size_t i = 0; i < 4; ++i) result.wxyz[i] = pose["q_wxyz"][i].get<double>();
  const std::string axis = shape.value("axis", "z");
  if (axis == "y") result.axis_wxyz = {1, -1, 0, 0};
  if (axis == "x") result.axis_wxyz = {1, 0, 1, 0};
  return result;
}

// A decimal number in 113 bits.
Quad parse(const std::string& text) {
  Quad mantissa = 0;
  int exponent = 0;
  bool after_point = false;
  std::size_t i = 0;
  const bool is_negative = !text.empty() && text[0] == '-';
  if (is_negative) i = 1;
  for (; i < text.size() && text[i] != 'e'; ++i) {
    if (text[i] == '.') {
      after_point = true;
      continue;
    }
    mantissa = mantissa * 10 + static_cast<Quad>(text[i] - '0');
    if (after_point) --exponent;
  }
  if (i < text.size()) exponent += std::stoi(text.substr(i + 1));
  for (; exponent > 0; --exponent) mantissa = mantissa * 10;
  for (; exponent < 0; ++exponent) mantissa = mantissa / 10;
  return is_negative ? -mantissa : mantissa;
}

}  // namespace

std::vector<KnownFailure> read_known_failures(const std::string& path) {
  std::vector<KnownFailure> rows;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    const Json json = Json::parse(line);
    const Json reference =
        json.contains("reference") ? json["reference"] : json.value("reference_at_start_pose", Json());
    if (!reference.is_object() || !json.contains("a") || !json.contains("b")) continue;
    const auto a = read_shape(json["a"]);
    const auto b = read_shape(json["b"]);
    if (!a || !b) continue;
    rows.push_back({json["id"], json["query"], *a, *b, read_pose(json["pose_a"], json["a"]),
                    read_pose(json["pose_b"], json["b"]), parse(reference["signed_distance_q"].get<std::string>())});
  }
  return rows;
}

Pose pose_of(const FailurePose& pose) {
  const Pose outer = Pose::from(pose.position, pose.wxyz);
  const Pose inner = Pose::from({0, 0, 0}, pose.axis_wxyz);
  const auto& p = outer.orientation;
  const auto& q = inner.orientation;
  Pose result = outer;
  result.orientation = {
      p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
      p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
  return result;
}

}  // namespace oracle
