// SPDX-License-Identifier: Apache-2.0
// The frames of a cloth on a ball of the repository Continuous-Collision-Detection/Sample-Scalable-CCD-Data, in binary
// PLY.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut_bench {

struct ClothFrame {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};

inline std::uint32_t read_big_endian(std::istream& in) {
  std::array<char, 4> bytes{};
  in.read(bytes.data(), bytes.size());
  std::uint32_t value = 0;
  for (const char byte : bytes) {
    value = value << 8 | static_cast<std::uint8_t>(byte);
  }
  return value;
}

// Vertices as single numbers, and triangles after the number 3 in one byte.
inline ClothFrame read_cloth_frame(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw std::runtime_error("cannot read " + path);
  }
  std::size_t vertices = 0, triangles = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    const auto count = [&](const std::string& name) {
      return line.starts_with(name) ? std::stoul(line.substr(name.size())) : 0;
    };
    vertices = std::max(vertices, count("element vertex "));
    triangles = std::max(triangles, count("element face "));
  }
  ClothFrame frame;
  for (std::size_t i = 0; i < 3 * vertices; ++i) {
    frame.xyz.push_back(static_cast<double>(std::bit_cast<float>(read_big_endian(in))));
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    in.get();
    for (int corner = 0; corner < 3; ++corner) {
      frame.triangles.push_back(read_big_endian(in));
    }
  }
  if (!in) {
    throw std::runtime_error(path + " ends early");
  }
  return frame;
}

}  // namespace abut_bench
