// SPDX-License-Identifier: Apache-2.0
#include "mesh_files.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {

// The spacing is that of data/README.md.
TriangleMesh read_terrain(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string header;
  std::vector<std::size_t> numbers;
  std::getline(file, header);
  while (numbers.size() < 3 && std::getline(file, header)) {
    if (header.starts_with('#')) continue;
    std::istringstream line(header);
    for (std::size_t number = 0; line >> number;) numbers.push_back(number);
  }
  if (numbers.size() < 3) {
    throw std::runtime_error(path + " is not a PGM file");
  }
  const std::size_t columns = numbers[0];
  const std::size_t rows = numbers[1];
  std::string bytes(2 * columns * rows, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto byte = [&](std::size_t i) { return static_cast<double>(static_cast<unsigned char>(bytes[i])); };
  TriangleMesh mesh;
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t at = 2 * (j * columns + i);
      const double x = 74.4 * (static_cast<double>(i) - 0.5 * static_cast<double>(columns));
      const double y = 92.6 * (static_cast<double>(j) - 0.5 * static_cast<double>(rows));
      mesh.xyz.insert(mesh.xyz.end(), {x, y, 256 * byte(at) + byte(at + 1)});
    }
  }
  for (std::size_t j = 0; j + 1 < rows; ++j) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * columns + i);
      const auto c = static_cast<std::uint32_t>(a + columns);
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, c + 1, a, c + 1, c});
    }
  }
  return mesh;
}

TriangleMesh read_obj(const std::string& path) {
  std::ifstream file(path);
  TriangleMesh mesh;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      double x = 0;
      double y = 0;
      double z = 0;
      words >> x >> y >> z;
      mesh.xyz.insert(mesh.xyz.end(), {x, y, z});
    } else if (kind == "f") {
      for (std::string corner; words >> corner;) {
        mesh.triangles.push_back(static_cast<std::uint32_t>(std::stoul(corner)) - 1);
      }
    }
  }
  return mesh;
}

// Every vertex has three numbers, every face its count of corners and these.
TriangleMesh read_ply(const std::string& path) {
  std::ifstream file(path);
  std::size_t vertices = 0, faces = 0;
  std::string line;
  while (std::getline(file, line) && line != "end_header") {
    std::istringstream words(line);
    std::string first, what;
    std::size_t count = 0;
    words >> first >> what >> count;
    vertices = what == "vertex" ? count : vertices;
    faces = what == "face" ? count : faces;
  }
  TriangleMesh mesh;
  mesh.xyz.resize(3 * vertices);
  for (double& coordinate : mesh.xyz) {
    file >> coordinate;
  }
  for (std::size_t i = 0; i < faces; ++i) {
    std::size_t corners = 0;
    std::array<std::uint32_t, 3> its{};
    file >> corners >> its[0] >> its[1] >> its[2];
    mesh.triangles.insert(mesh.triangles.end(), its.begin(), its.end());
  }
  if (!file || faces == 0) {
    throw std::runtime_error(path + " is not a PLY file of triangles");
  }
  return mesh;
}

TriangleMesh refined(const TriangleMesh& mesh) {
  TriangleMesh fine{mesh.xyz, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.xyz.size() / 3));
    for (std::size_t axis = 0; is_new && axis < 3; ++axis) {
      fine.xyz.push_back((mesh.xyz[3 * a + axis] + mesh.xyz[3 * b + axis]) / 2);
    }
    return found->second;
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const std::uint32_t a = mesh.triangles[i], b = mesh.triangles[i + 1], c = mesh.triangles[i + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.insert(fine.triangles.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  return fine;
}

}  // namespace bench
