// SPDX-License-Identifier: Apache-2.0
// Numbers of a fixed size in the bytes of a file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "owners.hpp"

namespace tools {

/// A whole file. Throws Failure.
inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw Failure("cannot open the model " + path.string());
  }
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The number that stands at a position, which there must be room for.
template <class Number>
Number number_at(const std::string& bytes, std::size_t position, std::endian order) {
  std::array<char, sizeof(Number)> its{};
  std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(position), its.size(), its.begin());
  if (order != std::endian::native) {
    std::ranges::reverse(its);
  }
  return std::bit_cast<Number>(its);
}

}  // namespace tools
