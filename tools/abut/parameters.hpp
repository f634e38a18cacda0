// SPDX-License-Identifier: Apache-2.0
// The scalar parameters of a shape, under the names that the library gives them.
#pragma once

#include <string>
#include <vector>

#include "node.hpp"
#include "shape_arrays.hpp"

namespace cli {

/// One number for each parameter of the kind. Three parameters p_x, p_y and p_z may also be given as "p": [x, y, z].
[[nodiscard]] std::vector<double> read_parameters(Fields& fields, const std::string& kind, const ShapeArrays& arrays);

/// Whether a parameter is 0 where a scene does not name it.
[[nodiscard]] bool is_optional(std::string_view kind, std::string_view parameter);

}  // namespace cli
