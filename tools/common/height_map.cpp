// SPDX-License-Identifier: Apache-2.0
#include "height_map.hpp"

#include <fstream>
#include <limits>
#include <string>

#include "owners.hpp"

namespace tools {
namespace {

// The next number of the header; comments run from '#' to the end of the line.
std::uint32_t header_number(std::istream& in) {
  while ((in >> std::ws) && in.peek() == '#') {
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  std::uint32_t number = 0;
  in >> number;
  return number;
}

}  // namespace

HeightMap read_height_map(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw Failure("cannot open the elevation grid " + path.string());
  }
  std::string magic;
  in >> magic;
  const std::uint32_t columns = header_number(in);
  const std::uint32_t rows = header_number(in);
  const std::uint32_t maximum = header_number(in);
  in.get();  // the single white space that ends the header
  constexpr std::uint32_t most = 20'000;
  if (!in || magic != "P5" || columns < 2 || rows < 2 || columns > most || rows > most || maximum < 1 ||
      maximum > 65535) {
    throw Failure(path.string() + " is not a binary PGM of 2 x 2 to 20000 x 20000 samples");
  }
  const std::size_t wide = maximum > 255 ? 2 : 1;
  std::vector<char> bytes(wide * columns);
  std::vector<double> heights(std::size_t{columns} * rows);
  for (std::size_t row = rows; row-- > 0;) {
    if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
      throw Failure(path.string() + " ends too early");
    }
    for (std::size_t column = 0; column < columns; ++column) {
      double height = 0.0;
      for (std::size_t byte = 0; byte < wide; ++byte) {
        height = 256.0 * height + static_cast<unsigned char>(bytes[wide * column + byte]);
      }
      heights[row * columns + column] = height;
    }
  }
  return {columns, rows, std::move(heights)};
}

}  // namespace tools
