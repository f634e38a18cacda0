// SPDX-License-Identifier: Apache-2.0
// Prints docs/pairs.md: the table of all pairs as this build answers them.
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

import abut.pairs.any_shape;

namespace {

std::string text_of(std::size_t a, std::size_t b) {
  const auto [low, high] = std::minmax(a, b);
  return abut::is_supported(low, high) ? std::string(abut::describe_route(low, high).reason) : "**unsupported**";
}

}  // namespace

int main() {
  std::printf(
      "# What meets what\n\nMade from the registry of shapes. Distances and contacts have the same table "
      "(`abut_pair_support` answers from it);\neach pair is listed once.\n\n|");
  for (std::size_t column = 0; column < abut::shape_kind_count; ++column) {
    std::printf(" | %s", std::string(abut::kind_name(column)).c_str());
  }
  std::printf(" |\n|---");
  for (std::size_t column = 0; column < abut::shape_kind_count; ++column) {
    std::printf("|---");
  }
  std::printf("|\n");
  for (std::size_t row = 0; row < abut::shape_kind_count; ++row) {
    std::printf("| **%s**", std::string(abut::kind_name(row)).c_str());
    for (std::size_t column = 0; column < abut::shape_kind_count; ++column) {
      std::printf(" | %s", column < row ? "" : text_of(row, column).c_str());
    }
    std::printf(" |\n");
  }
  return 0;
}
