// SPDX-License-Identifier: Apache-2.0
// Reads vertices and faces from a Wavefront OBJ file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "abut/abut.h"

namespace tools {

struct Triangles {
  std::vector<abut_vec3> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
};

/// Faces with more than three corners become fans; everything but vertices and faces is passed over. A file without
/// faces is a list of points. Throws Failure.
[[nodiscard]] Triangles read_wavefront(const std::filesystem::path& path);

}  // namespace tools
