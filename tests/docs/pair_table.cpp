// SPDX-License-Identifier: Apache-2.0
// Prints the table of docs/pairs.md: which search answers each pair of kinds in this build, as a colour and a letter.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

import abut.pairs.any_shape;

namespace {

struct Sign {
  std::string_view algorithm;  // as the library tells it
  std::string_view sign;       // as the legend of docs/pairs.md explains it
};
constexpr std::array signs{
    Sign{"closed form", "🟢 F"},
    Sign{"support point", "🟢 S"},
    Sign{"closed form apart, SAT in overlap", "🔵 B"},
    Sign{"GJK apart, SAT in overlap", "🔵 A"},
    Sign{"GJK apart, SAT over facets in overlap", "🔵 H"},
    Sign{"GJK apart, SAT over facets and rims in overlap", "🟡 R"},
    Sign{"GJK apart, EPA in overlap", "🟠 E"},
    Sign{"nearest triangle apart, separating translation in overlap", "🟠 T"},
    Sign{"descent of the field", "🟠 D"},
    Sign{"points of the surface", "🟠 P"},
    Sign{"walls, one by one", "🟣 W"},
    Sign{"as for the children, pair by pair", "🟣 C"},
};

// Each ball of particles, and each triangle beside a field or a hole, is a pair by itself.
constexpr std::array part_by_part{std::string_view("many solids of one kind"),
                                  std::string_view("a sampled solid against a surface"),
                                  std::string_view("a hole against a surface")};

std::string sign_of(std::size_t a, std::size_t b) {
  if (!abut::is_supported(a, b)) {
    return "⚪";
  }
  const abut::RouteDescription route = abut::describe_route(a, b);
  const auto* const found = std::ranges::find(signs, route.algorithm, &Sign::algorithm);
  if (found == signs.end()) {
    std::fprintf(stderr, "pair_table: no sign for \"%s\"; the legend of docs/pairs.md needs one\n",
                 std::string(route.algorithm).c_str());
    std::exit(1);
  }
  const bool has_parts = std::ranges::find(part_by_part, route.reason) != part_by_part.end();
  return std::string(found->sign) + (has_parts ? "+" : "");
}

}  // namespace

int main() {
  std::printf("| |");
  for (std::size_t column = 0; column < abut::shape_kind_count; ++column) {
    std::printf(" %s |", std::string(abut::kind_name(column)).c_str());
  }
  std::printf("\n|---|");
  for (std::size_t column = 0; column < abut::shape_kind_count; ++column) {
    std::printf(":-:|");
  }
  std::printf("\n");
  for (std::size_t row = 0; row < abut::shape_kind_count; ++row) {
    std::printf("| **%s** |", std::string(abut::kind_name(row)).c_str());
    for (std::size_t column = 0; column < abut::shape_kind_count; ++column) {
      std::printf(" %s |", sign_of(row, column).c_str());
    }
    std::printf("\n");
  }
  return 0;
}
