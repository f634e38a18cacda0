// SPDX-License-Identifier: Apache-2.0
// Triangle meshes from the files in data/, whose README tells what they are.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace bench {

struct TriangleMesh {
  std::vector<double> xyz;
  std::vector<std::uint32_t> triangles;
};

// A terrain in a 16-bit binary PGM, around the origin; in metres.
[[nodiscard]] TriangleMesh read_terrain(const std::string& path);
// Vertices and triangles of a Wavefront OBJ.
[[nodiscard]] TriangleMesh read_obj(const std::string& path);
// Vertices and triangles of a PLY in ASCII.
[[nodiscard]] TriangleMesh read_ply(const std::string& path);
// Each triangle cut into four at the middles of its edges.
[[nodiscard]] TriangleMesh refined(const TriangleMesh& mesh);

}  // namespace bench
