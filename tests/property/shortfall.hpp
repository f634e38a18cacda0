// A row of the tables of the property tests and the number of its cases in which the library falls short.
#pragma once

#include <cstdint>
#include <string_view>

namespace property {

struct Shortfall {
  std::string_view row;
  std::uint64_t cases;
};

}  // namespace property
