// SPDX-License-Identifier: Apache-2.0
#include "stl.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <sstream>

#include "bytes.hpp"

namespace tools {
namespace {

constexpr std::size_t header_size = 84;  // 80 bytes of any kind, and the count of facets
constexpr std::size_t facet_size = 50;   // a normal, three corners, and two bytes of any kind

class Corners {
 public:
  void add(double x, double y, double z) {
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
      throw Failure("it holds a coordinate that is no finite number");
    }
    const auto next = static_cast<std::uint32_t>(triangles_.vertices.size());
    const auto [found, is_new] = places_.try_emplace({x, y, z}, next);
    if (is_new) {
      triangles_.vertices.push_back({x, y, z});
    }
    triangles_.indices.push_back(found->second);
  }

  [[nodiscard]] Triangles take() { return std::move(triangles_); }

 private:
  Triangles triangles_;
  std::map<std::array<double, 3>, std::uint32_t> places_;
};

bool is_binary(const std::string& bytes) {
  return bytes.size() >= header_size &&
         bytes.size() ==
             header_size + facet_size * number_at<std::uint32_t>(bytes, header_size - 4, std::endian::little);
}

Triangles read_binary(const std::string& bytes) {
  Corners corners;
  const auto real = [&](std::size_t at) {
    return static_cast<double>(number_at<float>(bytes, at, std::endian::little));
  };
  for (std::size_t facet = header_size; facet < bytes.size(); facet += facet_size) {
    for (std::size_t corner = facet + 12; corner < facet + 48; corner += 12) {
      corners.add(real(corner), real(corner + 4), real(corner + 8));
    }
  }
  return corners.take();
}

void expect(std::istream& words, std::initializer_list<const char*> expected) {
  for (const char* each : expected) {
    std::string word;
    words >> word;
    if (word != each) {
      throw Failure("it holds '" + word + "' where '" + each + "' is expected");
    }
  }
}

double read_number(std::istream& words) {
  std::string word;
  words >> word;
  std::istringstream one(word);
  double number = 0.0;
  if (!(one >> number) || !one.eof()) {
    throw Failure("it holds '" + word + "' where a number is expected");
  }
  return number;
}

Triangles read_text(const std::string& bytes) {
  std::istringstream words(bytes);
  std::string name;
  std::getline(words, name);
  Corners corners;
  for (std::string word; words >> word && word != "endsolid";) {
    if (word != "facet") {
      throw Failure("it holds '" + word + "' where 'facet' or 'endsolid' is expected");
    }
    expect(words, {"normal"});
    for (int i = 0; i < 3; ++i) {
      static_cast<void>(read_number(words));
    }
    expect(words, {"outer", "loop"});
    for (int i = 0; i < 3; ++i) {
      expect(words, {"vertex"});
      const double x = read_number(words), y = read_number(words), z = read_number(words);
      corners.add(x, y, z);
    }
    expect(words, {"endloop", "endfacet"});
  }
  if (!words) {
    throw Failure("it ends before 'endsolid'");
  }
  return corners.take();
}

}  // namespace

Triangles read_stl(const std::filesystem::path& path) {
  const std::string bytes = bytes_of(path);
  try {
    if (!is_binary(bytes) && !bytes.starts_with("solid")) {
      throw Failure("it does not begin with 'solid', and is not as long as the count of its triangles says");
    }
    Triangles triangles = is_binary(bytes) ? read_binary(bytes) : read_text(bytes);
    if (triangles.vertices.empty()) {
      throw Failure("it holds no triangles");
    }
    return triangles;
  } catch (const Failure& failure) {
    throw Failure(path.string() + " is no STL file: " + failure.what());
  }
}

}  // namespace tools
