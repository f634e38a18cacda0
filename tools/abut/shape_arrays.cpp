// SPDX-License-Identifier: Apache-2.0
#include "shape_arrays.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

#include <nlohmann/json.hpp>

#include "common/height_map.hpp"
#include "common/ply.hpp"
#include "common/stl.hpp"
#include "common/wavefront.hpp"

namespace cli {
namespace {

// What a kind calls its points; kinds without a line take "reals" and "indices", if anything.
struct Points {
  std::string_view kind;
  std::string_view field;
};
constexpr std::array<Points, 5> points_of_kinds{{{"hull", "points"},
                                                 {"mesh", "vertices"},
                                                 {"uv_grid", "vertices"},
                                                 {"particles", "centres"},
                                                 {"height_field", "heights"}}};

bool has_triangles(const std::string& kind) { return kind == "mesh" || kind == "uv_grid"; }

std::string points_of(const std::string& kind) {
  const auto is_kind = [&](const Points& points) { return points.kind == kind; };
  const auto found = std::find_if(points_of_kinds.begin(), points_of_kinds.end(), is_kind);
  return found == points_of_kinds.end() ? "" : std::string(found->field);
}

// Adds numbers of a list, each of which must be a number.
void add_numbers(const Node& node, std::vector<double>& out) {
  const Json& json = node.json();
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (!json[i].is_number()) {
      Node(json[i], node.path() + "[" + std::to_string(i) + "]").refuse("a number");
    }
    out.push_back(json[i].get<double>());
  }
}

// A list of points; particles may have a radius each.
std::vector<double> read_points(const Node& node, bool with_radius) {
  std::vector<double> reals;
  for (const Node& point : node.list("points, [x, y, z] each")) {
    const std::size_t wanted = with_radius ? 4 : 3;
    if (!point.is_list() || point.size() != wanted) {
      point.refuse(with_radius ? "four numbers, [x, y, z, radius], as the shape has no radius"
                               : "three numbers, [x, y, z]");
    }
    add_numbers(point, reals);
  }
  return reals;
}

std::vector<std::uint32_t> read_indices(const Node& node) {
  std::vector<std::uint32_t> indices;
  for (const Node& triangle : node.list("triangles, three indices each")) {
    if (!triangle.is_list() || triangle.size() != 3) {
      triangle.refuse("three indices of vertices, from 0");
    }
    for (const Node& index : triangle.list("indices")) {
      indices.push_back(index.whole32(0));
    }
  }
  return indices;
}

// Rows of heights, the first along the X axis.
void read_heights(const Node& node, ShapeArrays& out) {
  for (const Node& row : node.list("rows of heights")) {
    if (!row.is_list() || row.size() < 2 || (out.rows > 0 && row.size() != out.columns)) {
      row.refuse("a row of at least two heights, as many as in the row before");
    }
    out.columns = static_cast<std::uint32_t>(row.size());
    ++out.rows;
    add_numbers(row, out.reals);
  }
}

// Numbers with white space or commas between them.
std::vector<double> read_numbers(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) {
    throw Failure("cannot open " + path.string());
  }
  std::string text{std::istreambuf_iterator<char>(in), {}};
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    std::istringstream one(word);
    double number = 0.0;
    if (!(one >> number) || !one.eof()) {
      throw Failure(path.string() + " holds '" + word + "' where a number is expected");
    }
    numbers.push_back(number);
  }
  return numbers;
}

bool is_model(const std::string& suffix) { return suffix == ".obj" || suffix == ".stl" || suffix == ".ply"; }

Triangles read_model(const std::filesystem::path& path, const std::string& suffix) {
  return suffix == ".stl" ? read_stl(path) : suffix == ".ply" ? read_ply(path) : read_wavefront(path);
}

void load_file(const Node& file, const std::filesystem::path& folder, const std::string& kind, ShapeArrays& out) {
  const std::filesystem::path path = folder / file.text();
  std::string suffix = path.extension().string();
  std::ranges::transform(suffix, suffix.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::filesystem::is_directory(path)) {
    throw Failure(path.string() + " is a folder");
  }
  if (suffix == ".pgm" && kind == "height_field") {
    HeightMap map = read_height_map(path);
    out.columns = map.columns;
    out.rows = map.rows;
    out.reals = std::move(map.heights);
  } else if (is_model(suffix) && kind != "height_field") {
    const Triangles triangles = read_model(path, suffix);
    for (const abut_vec3& v : triangles.vertices) {
      out.reals.insert(out.reals.end(), {v.x, v.y, v.z});
    }
    if (has_triangles(kind)) {
      out.indices = triangles.indices;
    }
  } else if (suffix == ".txt" || suffix == ".csv" || suffix == ".xyz") {
    out.reals = read_numbers(path);
  } else {
    file.refuse(
        "a file beside the scene: .obj, .stl or .ply for hulls, meshes and particles, .pgm for height fields, .txt for "
        "plain numbers");
  }
}

// Numbers from a file are multiplied by the scale.
void read_file(const Node& file, Fields& fields, const std::filesystem::path& folder, const std::string& kind,
               ShapeArrays& out) {
  const auto scale = fields.find("scale");
  const double factor = scale ? scale->positive() : 1.0;
  try {
    load_file(file, folder, kind, out);
  } catch (const BadInput&) {
    throw;
  } catch (const Failure& failure) {
    file.refuse("a file that can be read: " + printable(failure.what()));
  }
  for (double& real : out.reals) {
    real *= factor;
  }
}

}  // namespace

ShapeArrays read_arrays(Fields& fields, const std::string& kind, const std::filesystem::path& folder) {
  ShapeArrays out;
  const bool is_field = kind == "height_field";
  const std::string own = points_of(kind);
  const bool is_known = !own.empty();
  const std::string points = is_known ? own : "reals";
  const auto file = is_known ? fields.find("file") : std::nullopt;
  // Kinds without an array of their own do not offer one, so that a message lists what they have.
  const auto inline_points = is_known || fields.node().has(points) ? fields.find(points) : std::nullopt;
  if (file && inline_points) {
    fields.node().refuse("either a file or " + points + ", not both");
  }
  if (file) {
    read_file(*file, fields, folder, kind, out);
  } else if (is_field) {
    read_heights(fields.need(points), out);
  } else if (is_known) {
    out.reals = read_points(fields.need(points), kind == "particles" && !fields.find("radius"));
  } else if (inline_points) {
    if (!inline_points->is_list()) {
      inline_points->refuse("a list of numbers");
    }
    add_numbers(*inline_points, out.reals);
  }
  if (has_triangles(kind) && out.indices.empty()) {
    out.indices = read_indices(fields.need("triangles"));
  } else if (!is_known && fields.node().has("indices")) {
    for (const Node& index : fields.need("indices").list("indices")) {
      out.indices.push_back(index.whole32(0));
    }
  }
  return out;
}

std::vector<double> read_vertices(const Node& file, const std::filesystem::path& folder) {
  ShapeArrays out;
  try {
    load_file(file, folder, "particles", out);
  } catch (const BadInput&) {
    throw;
  } catch (const Failure& failure) {
    file.refuse("a file that can be read: " + printable(failure.what()));
  }
  return std::move(out.reals);
}

std::vector<std::string> arrays_of(const std::string& kind) {
  if (kind == "composite") {
    return {"children"};
  }
  const std::string points = points_of(kind);
  if (points.empty()) {
    return {};
  }
  return has_triangles(kind) ? std::vector<std::string>{points, "triangles", "file"}
                             : std::vector<std::string>{points, "file"};
}

}  // namespace cli
