// SPDX-License-Identifier: Apache-2.0
#include "known_cases.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

namespace bench {
namespace {

using Json = nlohmann::json;

template <std::size_t count>
std::array<double, count> numbers_of(const Json& list) {
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    numbers.at(i) = list.at(i).get<double>();
  }
  return numbers;
}

std::optional<Kind> kind_of(const std::string& type) {
  if (type == "convex") {
    return Kind::hull;
  }
  for (const Kind kind : {Kind::sphere, Kind::box, Kind::capsule, Kind::cylinder, Kind::ellipsoid, Kind::triangle}) {
    if (type == kind_name(kind)) {
      return kind;
    }
  }
  return std::nullopt;
}

std::optional<Solid> solid_of(const Json& json) {
  const std::optional<Kind> kind = kind_of(json.value("type", ""));
  if (!kind) {
    return std::nullopt;
  }
  Solid solid{*kind, {}, {}, {}};
  if (*kind == Kind::box) {
    solid.sizes = numbers_of<3>(json.at("half"));
  } else if (*kind == Kind::ellipsoid) {
    solid.sizes = numbers_of<3>(json.at("radii"));
  } else if (*kind == Kind::hull || *kind == Kind::triangle) {
    for (const Json& point : json.at("vertices")) {
      solid.points.push_back(numbers_of<3>(point));
    }
  } else {
    solid.sizes = {json.at("radius").get<double>(), json.value("half_length", 0.0), 0};
  }
  return solid;
}

// The file has axes along x and y too, which are turned from z.
Quaternion from_z(const std::string& axis) {
  const double half = std::sqrt(0.5);
  if (axis == "x") {
    return {half, 0, half, 0};
  }
  return axis == "y" ? Quaternion{half, -half, 0, 0} : Quaternion{1, 0, 0, 0};
}

Placement placement_of(const Json& pose, const Json& shape) {
  return {numbers_of<3>(pose.at("p")), product(numbers_of<4>(pose.at("q_wxyz")), from_z(shape.value("axis", "z")))};
}

}  // namespace

std::vector<KnownCase> read_known_cases(const std::string& path) {
  std::ifstream file(path);
  if (!file) {
    throw std::runtime_error(path + " cannot be read");
  }
  std::vector<KnownCase> cases;
  for (std::string line; std::getline(file, line);) {
    const Json json = Json::parse(line);
    const Json reference = json.value("reference", json.value("reference_at_start_pose", Json()));
    if (!reference.is_object()) {
      continue;
    }
    std::optional<Solid> a = solid_of(json.at("a")), b = solid_of(json.at("b"));
    if (a && b) {
      const Case placed{0, 0, placement_of(json.at("pose_a"), json.at("a")),
                        placement_of(json.at("pose_b"), json.at("b"))};
      cases.push_back({json.at("id"), std::move(*a), std::move(*b), placed, reference.at("signed_distance")});
    }
  }
  return cases;
}

}  // namespace bench
