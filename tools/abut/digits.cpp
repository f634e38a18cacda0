// SPDX-License-Identifier: Apache-2.0
#include "digits.hpp"

#include <array>
#include <charconv>
#include <memory>

namespace cli {

std::string digits(double number) {
  std::array<char, 32> text{};
  const double without_sign = number == 0.0 ? 0.0 : number;
  const auto result = std::to_chars(text.data(), std::to_address(text.end()), without_sign);
  return {text.data(), result.ptr};
}

std::string digits(const abut_vec3& vector) {
  return "[" + digits(vector.x) + ", " + digits(vector.y) + ", " + digits(vector.z) + "]";
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace cli
