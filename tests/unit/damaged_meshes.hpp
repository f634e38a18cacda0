// SPDX-License-Identifier: Apache-2.0
// Closed surfaces of triangles, and what damages them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace test {

// Numbers as shapes take them.
struct Surface {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;

  [[nodiscard]] std::size_t triangle_count() const { return triangles.size() / 3; }
  [[nodiscard]] std::array<double, 3> corner(std::size_t triangle, std::size_t i) const {
    const std::size_t vertex = 3 * std::size_t{triangles[3 * triangle + i]};
    return {xyz[vertex], xyz[vertex + 1], xyz[vertex + 2]};
  }
};

// A torus around Z: a tube of radius `thin` around a circle of radius `wide`.
inline Surface torus(double wide, double thin, std::uint32_t around, std::uint32_t across) {
  Surface out;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (std::uint32_t j = 0; j < across; ++j) {
      const double v = 2 * std::numbers::pi * j / across, reach = wide + thin * std::cos(v);
      out.xyz.insert(out.xyz.end(), {reach * std::cos(u), reach * std::sin(u), thin * std::sin(v)});
      const std::uint32_t next_i = (i + 1) % around, next_j = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = next_i * across + j, c = next_i * across + next_j,
                          d = i * across + next_j;
      out.triangles.insert(out.triangles.end(), {a, b, c, a, c, d});
    }
  }
  return out;
}

// Vertices and triangles of a Wavefront file.
inline Surface read_obj(const std::string& path) {
  Surface out;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    for (int i = 0; i < 3 && kind == "v"; ++i) {
      words >> out.xyz.emplace_back();
    }
    for (int i = 0; i < 3 && kind == "f"; ++i) {
      std::string corner;
      words >> corner;
      out.triangles.push_back(static_cast<std::uint32_t>(std::stoul(corner) - 1));
    }
  }
  return out;
}

// A share of the triangles is turned over, another one left out, another one doubled; and a share of the corners is
// moved onto another corner of their triangle, as welding by mistake does.
inline Surface damaged(const Surface& whole, double share, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> chance(0, 1);
  Surface out{whole.xyz, {}};
  for (std::size_t i = 0; i < whole.triangle_count(); ++i) {
    std::array<std::uint32_t, 3> corners{whole.triangles[3 * i], whole.triangles[3 * i + 1],
                                         whole.triangles[3 * i + 2]};
    const double way = chance(random) / share;
    if (way < 1) {
      std::swap(corners[0], corners[1]);
    } else if (way < 2) {
      continue;
    } else if (way < 3) {
      out.triangles.insert(out.triangles.end(), corners.begin(), corners.end());
    } else if (way < 4) {
      corners[0] = corners[1];
    }
    out.triangles.insert(out.triangles.end(), corners.begin(), corners.end());
  }
  return out;
}

}  // namespace test
