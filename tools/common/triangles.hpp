// SPDX-License-Identifier: Apache-2.0
// What files of models hold.
#pragma once

#include <cstdint>
#include <vector>

#include "abut/abut.h"

namespace tools {

struct Triangles {
  std::vector<abut_vec3> vertices;
  std::vector<std::uint32_t> indices;  // three a triangle
};

/// A face of three or more corners as a fan of triangles.
inline void add_fan(Triangles& out, const std::vector<std::uint32_t>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    out.indices.insert(out.indices.end(), {corners[0], corners[i - 1], corners[i]});
  }
}

}  // namespace tools
