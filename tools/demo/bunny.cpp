// SPDX-License-Identifier: Apache-2.0
#include "bunny.hpp"

#include <algorithm>
#include <string>

namespace demo {
namespace {

void rest_on_ground(std::vector<Vec3>& vertices) {
  Vec3 low = vertices.front();
  Vec3 high = low;
  for (const Vec3& v : vertices) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  const Vec3 foot{0.5 * (low.x + high.x), 0.5 * (low.y + high.y), low.z};
  const double scale = high.z > low.z ? 1.0 / (high.z - low.z) : 1.0;
  for (Vec3& v : vertices) {
    v = (v - foot) * scale;
  }
}

}  // namespace

Triangles load_obj(const std::filesystem::path& path) {
  Triangles result = read_wavefront(path);
  if (result.indices.empty()) {
    throw Failure(path.string() + " holds no triangles");
  }
  for (Vec3& v : result.vertices) {
    v = {v.x, -v.z, v.y};
  }
  rest_on_ground(result.vertices);
  return result;
}

}  // namespace demo
