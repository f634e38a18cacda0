// SPDX-License-Identifier: Apache-2.0
#include "steadiness_grounds.hpp"

#include <array>
#include <cstdint>

namespace bench {
namespace {

constexpr double half = 4;

abut::Pose at(double x, double y, double z) { return abut::pose(abut::Vec3{x, y, z}); }

abut::Shape sheet(std::uint32_t cells) {
  std::vector<abut::Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i) {
      vertices.push_back({half * (2.0 * i / cells - 1), half * (2.0 * j / cells - 1), 0});
    }
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t first = j * (cells + 1) + i, last = first + cells + 2;
      triangles.push_back({first, first + 1, last});
      triangles.push_back({first, last, last - 1});
    }
  }
  return abut::Shape::mesh(vertices, triangles);
}

abut::Shape heights(std::uint32_t side) {
  return abut::Shape::height_field(side, side, 2 * half / (side - 1), 2 * half / (side - 1),
                                   std::vector<double>(std::size_t{side} * side));
}

// Of the half-space below, as far as its samples go.
abut::Shape field() {
  constexpr std::uint32_t side = 17, layers = 9;
  constexpr double spacing = 2 * half / (side - 1), low = -2;
  std::vector<double> values;
  for (std::uint32_t k = 0; k < layers; ++k) {
    for (std::uint32_t i = 0; i < side * side; ++i) {
      values.push_back(low + spacing * k);
    }
  }
  return abut::Shape::distance_field(side, side, layers, {spacing, spacing, spacing}, {-half, -half, low}, values);
}

std::vector<abut::Pose> tiles(std::uint32_t side) {
  const double size = 2 * half / side;
  std::vector<abut::Pose> poses;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    poses.push_back(at((i % side + 0.5) * size - half, (i / side + 0.5) * size - half, -0.5));
  }
  return poses;
}

}  // namespace

std::vector<Ground> flat_grounds() {
  constexpr std::uint32_t side = 8;
  const std::vector<abut::Pose> places = tiles(side);
  const abut::Shape tile = abut::Shape::box(half / side, half / side, 0.5);
  const std::vector<abut::Shape> copies(places.size(), tile);
  std::vector<abut::Vec3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.push_back({i % 2 == 0 ? -half : half, i / 2 % 2 == 0 ? -half : half, i < 4 ? -1.0 : 0.0});
  }
  return {{"plane", {abut::Shape::plane({0, 0, 1}, 0)}, {at(0, 0, 0)}},
          {"box", {abut::Shape::box(half, half, 0.5)}, {at(0, 0, -0.5)}},
          {"hull", {abut::Shape::hull(corners)}, {at(0, 0, 0)}},
          {"triangle",
           {abut::Shape::triangle({-4 * half, -2 * half, 0}, {4 * half, -2 * half, 0}, {0, 4 * half, 0})},
           {at(0, 0, 0)}},
          {"mesh of 2", {sheet(1)}, {at(0, 0, 0)}},
          {"mesh of 2,048", {sheet(32)}, {at(0, 0, 0)}},
          {"height field", {heights(33)}, {at(-half, -half, 0)}},
          {"distance field", {field()}, {at(0, 0, 0)}},
          {"composite of 64 boxes", {abut::Shape::composite(copies, places)}, {at(0, 0, 0)}},
          {"64 boxes", copies, places}};
}

}  // namespace bench
