// SPDX-License-Identifier: Apache-2.0
// The Stanford bunny, put upright.
#pragma once

#include <filesystem>

#include "common/wavefront.hpp"
#include "owned.hpp"

namespace demo {

/// Vertices and triangles only. The +Y of the file becomes +Z. The box around the model is centred over the origin,
/// rests on the plane z = 0 and is one unit high. Throws Failure.
[[nodiscard]] Triangles load_obj(const std::filesystem::path& path);

}  // namespace demo
