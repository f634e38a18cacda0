// SPDX-License-Identifier: Apache-2.0
#include "lean.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "output_file.hpp"
#include "scene.hpp"

namespace cli {
namespace {

// Of the build, in the order of the library. A grid is a mesh there.
std::vector<std::string> shapes_of(const Scene& scene) {
  const auto is_named = [&](const char* kind) { return scene.shapes.kinds().contains(kind); };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < abut_shape_kind_count(); ++i) {
    const std::string name = abut_shape_kind_name(abut_shape_kind_at(i));
    if (name != "uv_grid" && (is_named(name.c_str()) || (name == "mesh" && is_named("uv_grid")))) {
      names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> features_of(const Scene& scene) {
  std::vector<std::string> names{"universe"};
  if (std::ranges::any_of(scene.policies,
                          [](const Policy& one) { return one.policy.detail == ABUT_DETAIL_ELEMENTS; })) {
    names.emplace_back("deforming");
  }
  constexpr abut_geometry_flags ahead = ABUT_GEOMETRY_FAST | ABUT_GEOMETRY_SPECULATIVE;
  if (std::ranges::any_of(scene.geometries, [](const Geometry& one) { return (one.options.flags & ahead) != 0; }) ||
      (scene.response && scene.response->has_impacts)) {
    names.emplace_back("motion");
  }
  const auto asks_for_libccd = [](const Policy& one) {
    return one.policy.algorithm == ABUT_ALGORITHM_LIBCCD_GJK || one.policy.algorithm == ABUT_ALGORITHM_LIBCCD_MPR;
  };
  if (std::ranges::any_of(scene.policies, asks_for_libccd)) {
    names.emplace_back("libccd");
  }
  if (scene.shapes.kinds().contains("hull")) {
    names.emplace_back("hull");
  }
  if (scene.response) {
    names.emplace_back("response");
  }
  if (scene.universe.threads != 1) {
    names.emplace_back("threads");
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ";") + name;
  }
  return text;
}

}  // namespace

void print_lean_build(const Arguments& arguments) {
  const Scene scene = read_scene(arguments.operands[0]);
  const std::vector<std::string> shapes = shapes_of(scene), features = features_of(scene);
  if (shapes.empty()) {
    throw BadInput(arguments.operands[0] + ": the scene has no shapes; expected one");
  }
  const std::string line = "cmake --preset release -B build/lean-scene -D \"ABUT_SHAPES=" + joined(shapes) +
                           "\" -D \"ABUT_FEATURES=" + joined(features) +
                           "\" -D ABUT_WARNINGS=OFF -D ABUT_TESTS=OFF -D ABUT_TOOLS=OFF -D ABUT_BENCH=OFF";
  const nlohmann::ordered_json json{{"shapes", shapes}, {"features", features}, {"line", line}};
  print(arguments.json ? json.dump(2) + "\n" : line + "\n");
}

}  // namespace cli
