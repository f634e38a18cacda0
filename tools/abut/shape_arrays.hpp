// SPDX-License-Identifier: Apache-2.0
// The arrays of shapes that are made of many numbers: inline in the scene, or from a file beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "node.hpp"

namespace cli {

struct ShapeArrays {
  std::vector<double> reals;
  std::vector<std::uint32_t> indices;
  std::uint32_t columns = 0;  // of a height field, where the array tells; else 0
  std::uint32_t rows = 0;
};

/// Reads what a kind takes; `folder` is that of the scene.
[[nodiscard]] ShapeArrays read_arrays(Fields& fields, const std::string& kind, const std::filesystem::path& folder);

/// Names of the fields that a kind takes besides its parameters; none for most.
[[nodiscard]] std::vector<std::string> arrays_of(const std::string& kind);

/// x, y, z of the vertices in an .obj, .stl or .ply file, or in one of plain numbers.
[[nodiscard]] std::vector<double> read_vertices(const Node& file, const std::filesystem::path& folder);

}  // namespace cli
