// SPDX-License-Identifier: Apache-2.0
// Rows of values, as CSV with a header or as a JSON list of objects. Numbers are written with as many digits as it
// takes to read the same bits back.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "common/vector.hpp"
#include "output_file.hpp"

namespace cli {

enum class Format { csv, json };

/// JSON for names that end in ".json", else CSV.
[[nodiscard]] Format format_of(const std::string& path);

struct Column {
  std::string_view name;
  bool is_vector = false;  // three columns name_x, name_y, name_z of a CSV; a list in JSON
};

/// Values are given in the order of the columns.
class Table {
 public:
  Table(const std::string& path, Format format, std::span<const Column> columns);

  Table& text(std::string_view value);
  Table& whole(std::uint64_t value);
  Table& real(double value);
  Table& vector(const abut_vec3& value);
  Table& flag(bool value);
  void end_row();
  void finish();

 private:
  void begin_value();

  OutputFile file_;
  Format format_;
  std::span<const Column> columns_;
  std::size_t column_ = 0;
  bool first_row_ = true;
  std::string row_;
};

}  // namespace cli
