// SPDX-License-Identifier: Apache-2.0
// Numbers for people, with as many digits as it takes to read the same number back.
#pragma once

#include <string>

#include "common/vector.hpp"

namespace cli {

/// The sign of a zero is left out.
[[nodiscard]] std::string digits(double number);

/// Such as "[1, 0, 0.5]".
[[nodiscard]] std::string digits(const abut_vec3& vector);

/// Such as "1 pair" or "2 pairs".
[[nodiscard]] std::string counted(std::size_t count, const std::string& what);

}  // namespace cli
