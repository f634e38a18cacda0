// SPDX-License-Identifier: Apache-2.0
// A scene as it was read: plain data, and the shapes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "abut/abut.h"
#include "abut/response.h"
#include "names.hpp"
#include "script.hpp"
#include "shapes.hpp"

namespace cli {

struct Part {
  static constexpr std::size_t no_script = std::numeric_limits<std::size_t>::max();

  std::string name;
  abut_motion motion = ABUT_MOTION_DYNAMIC;
  abut_pose pose{};
  std::size_t script = no_script;
  std::optional<abut_sleep> sleep;
  std::optional<abut_velocity> velocity;
  bool is_measured = false;       // its velocity follows from its poses
  std::optional<double> density;  // of a body
  std::optional<double> mass;     // in place of the density
};

/// Vertices that a mesh has one step after the other.
struct Sequence {
  std::string path;                           // in the scene
  std::vector<std::vector<double>> vertices;  // of each step; x, y, z
  bool repeat = false;

  [[nodiscard]] const std::vector<double>& at(std::uint64_t step) const {
    const std::uint64_t count = vertices.size();
    return vertices[repeat ? (step - 1) % count : std::min(step, count) - 1];
  }
};

struct Geometry {
  std::size_t part;
  std::string name;  // within its part
  const abut_shape* shape;
  abut_geometry_options options;
  std::size_t sequence = Part::no_script;
};

/// What a rule speaks of: of a geometry or a part its index in the scene, of a label its number.
struct Collidable {
  abut_collidable_kind kind;
  std::size_t index;
};

struct Rule {
  std::string path;
  Collidable a;
  Collidable b;
  abut_rule rule;
};

struct Policy {
  std::string path;
  std::uint32_t tag_a;
  std::uint32_t tag_b;
  abut_policy policy;
};

struct Focus {
  abut_focus focus{};
  std::vector<abut_vec3> centres;
};

/// What two materials do where they touch.
struct MaterialPair {
  std::string path;
  std::uint32_t a;
  std::uint32_t b;
  abut_contact_material material;
};

/// How bodies move; what is not given is as the response library has it.
struct Response {
  abut_vec3 gravity{0, 0, -9.81};
  std::optional<double> tolerance;
  std::optional<double> slop;
  abut_solver solver = ABUT_SOLVER_NEWTON;
  bool has_impacts = false;
};

struct Scene {
  explicit Scene(std::filesystem::path folder) : shapes(std::move(folder)) {}

  std::string length_unit = "m";
  std::string time_unit = "s";
  abut_universe_options universe{};
  std::uint64_t steps = 1;
  double dt = 0.01;
  Shapes shapes;
  Names layers{"layer", 63};
  Names exclusions{"exclusion", 63};
  Names labels{"label", UINT32_MAX};
  Names tags{"tag", 63};
  Names materials{"material", UINT32_MAX};
  std::vector<Part> parts;
  std::vector<Geometry> geometries;
  std::vector<Script> scripts;
  std::vector<Sequence> sequences;
  bool follows_islands = false;
  std::vector<Rule> rules;
  std::vector<Policy> policies;
  std::vector<MaterialPair> material_pairs;
  std::optional<Focus> focus;
  std::optional<Response> response;
};

/// Reads and checks a scene, from the standard input for "-". Files that it names lie beside it, or else in the working
/// folder. Throws BadInput.
[[nodiscard]] Scene read_scene(const std::filesystem::path& path);

}  // namespace cli
