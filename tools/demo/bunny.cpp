#include "bunny.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "owned.hpp"

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
  std::ifstream in(path);
  if (!in) {
    throw Failure("cannot open the model " + path.string());
  }
  Triangles result;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    std::string tag;
    fields >> tag;
    if (tag == "v") {
      Vec3 v{};
      fields >> v.x >> v.y >> v.z;
      result.vertices.push_back({v.x, -v.z, v.y});
    } else if (tag == "f") {
      for (int corner = 0; corner < 3; ++corner) {
        std::uint32_t index = 0;
        fields >> index;
        result.indices.push_back(index - 1);  // the file counts from one; zero wraps and is refused below
      }
    }
    if (fields.fail() && (tag == "v" || tag == "f")) {
      throw Failure(path.string() + " has a line that cannot be read: " + line);
    }
  }
  const bool in_range = std::all_of(result.indices.begin(), result.indices.end(),
                                    [&](std::uint32_t index) { return index < result.vertices.size(); });
  if (result.indices.empty() || !in_range) {
    throw Failure(path.string() + " holds no triangles, or one whose corners do not exist");
  }
  rest_on_ground(result.vertices);
  return result;
}

}  // namespace demo
