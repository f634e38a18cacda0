// SPDX-License-Identifier: Apache-2.0
#include "ply.hpp"

#include <cmath>
#include <sstream>

#include "bytes.hpp"

namespace tools {
namespace {

using ReadNumber = double (*)(const std::string&, std::size_t, std::endian);

template <class Number>
double read_as(const std::string& bytes, std::size_t position, std::endian order) {
  return static_cast<double>(number_at<Number>(bytes, position, order));
}

struct Type {
  std::string_view name;
  std::string_view other_name;
  std::size_t size;
  ReadNumber read;
};

constexpr std::array<Type, 8> types{{{"char", "int8", 1, read_as<std::int8_t>},
                                     {"uchar", "uint8", 1, read_as<std::uint8_t>},
                                     {"short", "int16", 2, read_as<std::int16_t>},
                                     {"ushort", "uint16", 2, read_as<std::uint16_t>},
                                     {"int", "int32", 4, read_as<std::int32_t>},
                                     {"uint", "uint32", 4, read_as<std::uint32_t>},
                                     {"float", "float32", 4, read_as<float>},
                                     {"double", "float64", 8, read_as<double>}}};

Type type_named(const std::string& name) {
  const auto found =
      std::ranges::find_if(types, [&](const Type& type) { return type.name == name || type.other_name == name; });
  if (found == types.end()) {
    throw Failure("it has the type '" + name + "'; expected one such as float or uchar");
  }
  return *found;
}

struct Property {
  std::string name;
  Type type;
  bool is_list;
  Type count_type;  // of a list
};

struct Element {
  std::string name;
  std::size_t count;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
};

std::size_t read_count(std::istream& words) {
  std::size_t count = 0;
  if (!(words >> count) || count > UINT32_MAX) {
    throw Failure("its header has an element without a count below 2^32");
  }
  return count;
}

Property read_property(std::istream& words) {
  std::string type, count_type, name;
  words >> type;
  const bool is_list = type == "list";
  if (is_list) {
    words >> count_type >> type;
  }
  words >> name;
  return {name, type_named(type), is_list, type_named(is_list ? count_type : type)};
}

// Leaves the stream at the first byte of the body.
Header read_header(std::istream& in) {
  Header header;
  std::string line;
  if (!std::getline(in, line) || !line.starts_with("ply")) {
    throw Failure("it does not begin with 'ply'");
  }
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "end_header") {
      return header;
    }
    if (word == "format") {
      words >> header.format;
    } else if (word == "element") {
      Element element{};
      words >> element.name;
      element.count = read_count(words);
      header.elements.push_back(std::move(element));
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(words));
    } else if (word != "comment" && word != "obj_info") {
      throw Failure("its header holds '" + word + "'; expected format, element, property, comment or end_header");
    }
  }
  throw Failure("its header has no end");
}

// The numbers of the body, one after the other.
class Body {
 public:
  Body(const std::string& bytes, std::size_t begin, const std::string& format)
      : bytes_(bytes),
        position_(begin),
        is_text_(format == "ascii"),
        order_(format == "binary_big_endian" ? std::endian::big : std::endian::little) {
    if (!is_text_ && format != "binary_little_endian" && format != "binary_big_endian") {
      throw Failure("its format is '" + format + "'; expected ascii, binary_little_endian or binary_big_endian");
    }
  }

  double next(const Type& type) { return is_text_ ? next_word() : next_bytes(type); }

 private:
  double next_bytes(const Type& type) {
    if (bytes_.size() - position_ < type.size) {
      throw Failure("it ends too early");
    }
    const double number = type.read(bytes_, position_, order_);
    position_ += type.size;
    return number;
  }

  double next_word() {
    constexpr const char* space = " \t\r\n";
    const std::size_t begin = std::min(bytes_.find_first_not_of(space, position_), bytes_.size());
    position_ = std::min(bytes_.find_first_of(space, begin), bytes_.size());
    const std::string word = bytes_.substr(begin, position_ - begin);
    if (word.empty()) {
      throw Failure("it ends too early");
    }
    std::istringstream one(word);
    double number = 0.0;
    if (!(one >> number) || !one.eof()) {
      throw Failure("it holds '" + word + "' where a number is expected");
    }
    return number;
  }

  std::string bytes_;
  std::size_t position_;
  bool is_text_;
  std::endian order_;
};

std::uint32_t whole(double number, double below, const char* what) {
  if (!(number >= 0.0) || !(number < below) || number != std::floor(number)) {
    std::ostringstream text;
    text << "it has " << what << " " << number << "; expected a whole number below " << below;
    throw Failure(text.str());
  }
  return static_cast<std::uint32_t>(number);
}

void read_vertex(const Element& element, Body& body, Triangles& out) {
  abut_vec3 place{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  for (const Property& property : element.properties) {
    if (property.is_list) {
      throw Failure("its vertices have a list, '" + property.name + "', which is not supported");
    }
    const double number = body.next(property.type);
    place.x = property.name == "x" ? number : place.x;
    place.y = property.name == "y" ? number : place.y;
    place.z = property.name == "z" ? number : place.z;
  }
  if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z)) {
    throw Failure("a vertex has no finite x, y and z");
  }
  out.vertices.push_back(place);
}

// Any other element, and all of a face but its corners, is read and forgotten.
void read_other(const Element& element, Body& body, Triangles& out) {
  const auto vertices = static_cast<double>(out.vertices.size());
  for (const Property& property : element.properties) {
    const double count = property.is_list ? body.next(property.count_type) : 1.0;
    const bool is_face = property.is_list && element.name == "face" &&
                         (property.name == "vertex_indices" || property.name == "vertex_index");
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = whole(count, 4294967296.0, "a list with the count"); i > 0; --i) {
      const double number = body.next(property.type);
      if (is_face) {
        corners.push_back(whole(number, vertices, "a face with the vertex"));
      }
    }
    add_fan(out, corners);
  }
}

Triangles read(const std::string& bytes) {
  std::istringstream in(bytes);
  const Header header = read_header(in);
  const auto begin = in.tellg();
  Body body(bytes, begin < 0 ? bytes.size() : static_cast<std::size_t>(begin), header.format);
  Triangles triangles;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) {
      throw Failure("its element '" + element.name + "' has no properties");
    }
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex") {
        read_vertex(element, body, triangles);
      } else {
        read_other(element, body, triangles);
      }
    }
  }
  if (triangles.vertices.empty()) {
    throw Failure("it holds no vertices");
  }
  return triangles;
}

}  // namespace

Triangles read_ply(const std::filesystem::path& path) {
  const std::string bytes = bytes_of(path);
  try {
    return read(bytes);
  } catch (const Failure& failure) {
    throw Failure(path.string() + " is no PLY file that can be read: " + failure.what());
  }
}

}  // namespace tools
