// Reads the triangles of a Wavefront OBJ file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "vector.hpp"

namespace demo {

struct Triangles {
  std::vector<Vec3> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
};

/// Vertices and triangles only; the +Y of the file becomes +Z, and the box around the model is centred over the
/// origin, rests on the plane z = 0 and is one unit high. Throws Failure.
[[nodiscard]] Triangles load_obj(const std::filesystem::path& path);

}  // namespace demo
