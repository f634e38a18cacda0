// SPDX-License-Identifier: Apache-2.0
// Reads heights from a picture in grey (PGM).
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tools {

struct HeightMap {
  std::uint32_t columns;
  std::uint32_t rows;
  std::vector<double> heights;  // X fastest; the last row of the picture comes first, so that +Y is its top
};

/// A binary PGM (P5) of 8 or 16 bits a sample. Throws Failure.
[[nodiscard]] HeightMap read_height_map(const std::filesystem::path& path);

}  // namespace tools
