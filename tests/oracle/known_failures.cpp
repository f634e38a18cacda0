// SPDX-License-Identifier: Apache-2.0
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

FailureShape read_shape(const Json& json) {
  FailureShape shape;
  shape.type = json["type"];
  for (const char* name : {"half", "radii"}) {
    for (const Json& length : json.value(name, Json::array())) shape.parameters.push_back(length.get<double>());
  }
  for (const char* name : {"radius", "half_length"}) {
    if (json.contains(name)) shape.parameters.push_back(json[name].get<double>());
  }
  shape.soup.points = points_of(json.value("vertices", Json::array()));
  for (const Json& t : json.value("triangles", Json::array())) {
    shape.soup.triangles.push_back({t[0].get<std::uint32_t>(), t[1].get<std::uint32_t>(), t[2].get<std::uint32_t>()});
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

Point point_of(const Json& json) { return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()}; }

Point scaled(const Point& p, double factor) { return {p[0] * factor, p[1] * factor, p[2] * factor}; }

void read_distance(const Json& json, KnownFailure& row) {
  for (const char* name : {"reference", "reference_at_start_pose"}) {
    if (json.contains(name)) row.distance = parse(json[name]["signed_distance_q"].get<std::string>());
  }
  const Json& expected = json["expected"];
  if (!row.distance && expected.contains("signed_distance")) {
    row.distance = quad(expected["signed_distance"].get<double>());
  }
  if (!row.distance && expected.contains("exact_signed_distance")) {
    row.distance = quad(expected["exact_signed_distance"].get<double>());
  }
}

// A direction with a distance is cast twice as far.
void read_cast(const Json& json, KnownFailure& row) {
  const Json& expected = json["expected"];
  FailureCast cast{{}, row.distance && *row.distance < 0, std::nullopt};
  if (cast.touches) cast.fraction = 0;
  if (expected.contains("vel_a")) {
    cast.displacement = point_of(expected["vel_a"]);
  } else if (expected.contains("cast_dir")) {
    cast.displacement = point_of(expected["cast_dir"]);
  } else if (expected.contains("to")) {
    const Point end = point_of(expected["to"]);
    for (std::size_t i = 0; i < 3; ++i) cast.displacement.at(i) = end.at(i) - row.pose_a.position.at(i);
  } else {
    return;
  }
  if (expected.contains("toi")) cast.fraction = expected["toi"].get<double>();
  if (expected.contains("cast_dir") && expected.contains("distance")) {
    cast.displacement = scaled(cast.displacement, 2 * expected["distance"].get<double>());
    cast.fraction = 0.5;
  }
  cast.touches = cast.fraction.has_value();
  row.cast = cast;
}

void read_contacts(const Json& json, KnownFailure& row) {
  row.asks_contacts = row.query == "penetration" || row.query.ends_with("+manifold");
  for (const char* name : {"contact_count", "upstream_test_contact_count"}) {
    if (json["expected"].contains(name)) row.contacts = json["expected"][name].get<std::size_t>();
  }
}

void read_motion(const Json& json, KnownFailure& row) {
  FailureMotion motion;
  motion.is_vertex_face = row.query == "ccd_vertex_face";
  for (std::size_t i = 0; i < 4; ++i) {
    motion.start[i] = point_of(json["t0"][i]);
    motion.end[i] = point_of(json["t1"][i]);
  }
  row.motion = motion;
}

void read_hull(const Json& json, KnownFailure& row) {
  const Json& expected = json["expected"];
  FailureHull hull{points_of(json["points"]), expected["hull_vertices"].get<std::size_t>(), std::nullopt};
  if (expected.contains("volume")) hull.volume = expected["volume"].get<double>();
  row.hull = hull;
}

KnownFailure read_row(const Json& json) {
  KnownFailure row;
  row.id = json["id"];
  row.query = json["query"];
  if (json.contains("a")) {
    row.a = read_shape(json["a"]);
    row.pose_a = read_pose(json["pose_a"], json["a"]);
  }
  if (json.contains("b")) {
    row.b = read_shape(json["b"]);
    row.pose_b = read_pose(json["pose_b"], json["b"]);
    read_distance(json, row);
    read_cast(json, row);
    read_contacts(json, row);
  }
  if (json.contains("ray_origin")) {
    row.ray = FailureRay{point_of(json["ray_origin"]), point_of(json["ray_dir"]), json["expected"]["hits_t"]};
  }
  if (json.contains("points")) read_hull(json, row);
  if (json.contains("t0")) read_motion(json, row);
  return row;
}

}  // namespace

std::vector<KnownFailure> read_known_failures(const std::string& path) {
  std::vector<KnownFailure> rows;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) rows.push_back(read_row(Json::parse(line)));
  return rows;
}

std::optional<Solid> solid_of(const FailureShape& shape) {
  const auto& p = shape.parameters;
  if (shape.type == "sphere") return solid_of(make_sphere(p[0]));
  if (shape.type == "box") return solid_of(make_box(p[0], p[1], p[2]));
  if (shape.type == "capsule") return solid_of(make_capsule(p[0], p[1]));
  if (shape.type == "cylinder") return solid_of(Cylinder{p[0], p[1]});
  if (shape.type == "disc") return solid_of(Cylinder{p[0], 0});
  if (shape.type == "ellipsoid") return solid_of(Ellipsoid{{p[0], p[1], p[2]}});
  if (shape.type == "convex" || shape.type == "triangle") return solid_of(make_hull(shape.soup.points));
  return std::nullopt;
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
