// SPDX-License-Identifier: Apache-2.0
// Reads triangles from an STL file.
#pragma once

#include <filesystem>

#include "triangles.hpp"

namespace tools {

/// Text or binary. Vertices at one place become one; normals are passed over. Throws Failure.
[[nodiscard]] Triangles read_stl(const std::filesystem::path& path);

}  // namespace tools
