// SPDX-License-Identifier: Apache-2.0
// Reads vertices and faces from a PLY file.
#pragma once

#include <filesystem>

#include "triangles.hpp"

namespace tools {

/// Text, or binary of either byte order, with numbers of any type. Faces with more than three corners become fans. All
/// but positions and faces is passed over; a file without faces is a list of points. Throws Failure.
[[nodiscard]] Triangles read_ply(const std::filesystem::path& path);

}  // namespace tools
