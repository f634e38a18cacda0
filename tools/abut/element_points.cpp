// SPDX-License-Identifier: Apache-2.0
#include "element_points.hpp"

#include <map>

#include "common/owners.hpp"
#include "common/vector.hpp"

namespace cli {
namespace {

using tools::operator+;
using tools::operator*;

// Vertices of a geometry in the world, by the numbers that stencils use.
std::vector<abut_vec3> vertices_of(const World& world, std::size_t geometry) {
  const abut_shape* shape = world.shape_of(geometry);
  std::size_t vertices = 0, triangles = 0;
  check(abut_shape_triangles(shape, nullptr, 0, &vertices, nullptr, 0, &triangles), "triangles of a geometry");
  std::vector<double> numbers(3 * vertices);
  std::vector<std::uint32_t> corners(3 * triangles);
  check(abut_shape_triangles(shape, numbers.data(), vertices, &vertices, corners.data(), triangles, &triangles),
        "triangles of a geometry");
  const abut_pose pose = world.pose_of(geometry);
  std::vector<abut_vec3> places;
  for (std::size_t i = 0; i < vertices; ++i) {
    const abut_vec3 local{numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    places.push_back(pose.position + tools::rotate(pose.orientation, local));
  }
  return places;
}

}  // namespace

std::vector<ElementPoint> element_points_of(const World& world) {
  std::map<std::size_t, std::vector<abut_vec3>> vertices;
  std::vector<ElementPoint> points;
  for (const abut_element_contact& contact : world.element_contacts()) {
    abut_vec3 middle{};
    for (std::uint32_t i = 0; i < 4; ++i) {
      const bool is_of_a = i < contact.stencil.of_a;
      const std::size_t geometry = world.number_of(is_of_a ? contact.geometry_a : contact.geometry_b);
      const auto [its, is_new] = vertices.try_emplace(geometry);
      if (is_new) {
        its->second = vertices_of(world, geometry);
      }
      // Weights of a have the sum -1.
      const double weight = (is_of_a ? -0.5 : 0.5) * contact.stencil.weights[i];
      middle = middle + its->second.at(contact.stencil.vertices[i]) * weight;
    }
    points.push_back({middle, contact.geometry_a, contact.geometry_b});
  }
  return points;
}

}  // namespace cli
