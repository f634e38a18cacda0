// SPDX-License-Identifier: Apache-2.0
#include "parameters.hpp"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

namespace cli {
namespace {

// The number of the parameter: from its own field, from a component of a vector, or what the arrays tell.
double read_parameter(Fields& fields, const std::string& kind, const std::string& name, const ShapeArrays& arrays) {
  const bool is_size = kind == "height_field" && (name == "columns" || name == "rows");
  if (is_size && arrays.columns > 0) {
    return name == "columns" ? arrays.columns : arrays.rows;
  }
  if (const auto own = fields.find(name)) {
    if (is_size) {
      return own->whole32(2, 65535);
    }
    return own->json().is_boolean() ? (own->flag() ? 1.0 : 0.0) : own->number();
  }
  const std::size_t stem = name.size() >= 2 ? name.size() - 2 : 0;
  const std::size_t axis = std::string_view("xyz").find(name.back());
  if (name[stem] == '_' && axis != std::string_view::npos) {
    if (const auto vector = fields.find(name.substr(0, stem))) {
      static_cast<void>(vector->vector());
      return vector->json()[axis].get<double>();
    }
  }
  if (name == "axis_v") {
    return 1.0;
  }
  return is_optional(kind, name) ? 0.0 : fields.need(name).number();
}

}  // namespace

bool is_optional(std::string_view kind, std::string_view parameter) {
  // All but one are 0 then: the second axis of a grid is Y.
  constexpr std::array<std::string_view, 15> with_defaults{
      "interpolation", "lattice_columns", "lattice_rows", "lattice_layers", "offset",
      "one_sided",     "sides",           "solid_below",  "open_ends",      "open_faces",
      "diagonal",      "axis_u",          "axis_v",       "cells_u",        "cells_v"};
  return std::find(with_defaults.begin(), with_defaults.end(), parameter) != with_defaults.end() ||
         (kind == "particles" && parameter == "radius");
}

std::vector<double> read_parameters(Fields& fields, const std::string& kind, const ShapeArrays& arrays) {
  const abut_shape_kind number = abut_shape_kind_by_name(kind.c_str());
  std::vector<double> parameters;
  for (std::size_t i = 0; i < abut_shape_kind_parameter_count(number); ++i) {
    parameters.push_back(read_parameter(fields, kind, abut_shape_kind_parameter_name(number, i), arrays));
  }
  return parameters;
}

}  // namespace cli
