// SPDX-License-Identifier: Apache-2.0
#include "wavefront.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "owners.hpp"

namespace tools {
namespace {

// A corner is the number of a vertex, then perhaps slashes and numbers of other things. Numbers count from one;
// negative ones count back from the last vertex so far. Answers a number past the end for what is none.
std::size_t corner_of(const std::string& word, std::size_t vertices) {
  const std::string number = word.substr(0, word.find('/'));
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(number.data(), std::to_address(number.end()), index);
  const auto count = static_cast<std::int64_t>(vertices);
  if (error != std::errc{} || end != std::to_address(number.end()) || index == 0 || index < -count || index > count) {
    return vertices;
  }
  return static_cast<std::size_t>(index > 0 ? index - 1 : count + index);
}

bool read_vertex(std::istream& fields, Triangles& out) {
  abut_vec3 v{};
  fields >> v.x >> v.y >> v.z;
  out.vertices.push_back(v);
  return !fields.fail() && std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool read_face(std::istream& fields, Triangles& out) {
  std::vector<std::uint32_t> corners;
  for (std::string word; fields >> word;) {
    const std::size_t corner = corner_of(word, out.vertices.size());
    if (corner >= out.vertices.size()) {
      return false;
    }
    corners.push_back(static_cast<std::uint32_t>(corner));
  }
  add_fan(out, corners);
  return corners.size() >= 3;
}

}  // namespace

Triangles read_wavefront(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) {
    throw Failure("cannot open the model " + path.string());
  }
  Triangles result;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream fields(line);
    std::string tag;
    fields >> tag;
    if ((tag == "v" && !read_vertex(fields, result)) || (tag == "f" && !read_face(fields, result))) {
      throw Failure(path.string() + " has a line that cannot be read, " + std::to_string(number) + ": " + line);
    }
  }
  if (result.vertices.empty()) {
    throw Failure(path.string() + " holds no vertices");
  }
  return result;
}

}  // namespace tools
