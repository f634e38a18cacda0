// SPDX-License-Identifier: Apache-2.0
// Reads vertices and faces from a Wavefront OBJ file.
#pragma once

#include <filesystem>

#include "triangles.hpp"

namespace tools {

/// Faces with more than three corners become fans; everything but vertices and faces is passed over. A file without
/// faces is a list of points. Throws Failure.
[[nodiscard]] Triangles read_wavefront(const std::filesystem::path& path);

}  // namespace tools
