// SPDX-License-Identifier: Apache-2.0
#include "table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

#include <nlohmann/json.hpp>

namespace cli {
namespace {

void append_real(std::string& out, double value) {
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), std::to_address(digits.end()), value);
  out.append(digits.data(), result.ptr);
}

void append_vector(std::string& out, const abut_vec3& value, std::string_view separator) {
  append_real(out, value.x);
  out += separator;
  append_real(out, value.y);
  out += separator;
  append_real(out, value.z);
}

// As RFC 4180 has it.
void append_csv_text(std::string& out, std::string_view value) {
  if (value.find_first_of(",\"\r\n") == std::string_view::npos) {
    out += value;
    return;
  }
  out += '"';
  for (const char c : value) {
    out += c == '"' ? "\"\"" : std::string(1, c);
  }
  out += '"';
}

}  // namespace

Format format_of(const std::string& path) { return path.ends_with(".json") ? Format::json : Format::csv; }

Table::Table(const std::string& path, Format format, std::span<const Column> columns)
    : file_(path), format_(format), columns_(columns) {
  if (format_ == Format::json) {
    file_.write("[");
    return;
  }
  for (const Column& column : columns) {
    const std::string name(column.name);
    row_ += (row_.empty() ? "" : ",") + (column.is_vector ? name + "_x," + name + "_y," + name + "_z" : name);
  }
  row_ += '\n';
  file_.write(row_);
  row_.clear();
}

void Table::begin_value() {
  if (format_ == Format::csv) {
    row_ += column_ > 0 ? "," : "";
  } else {
    row_ += column_ > 0 ? ", \"" : "{\"";
    row_ += columns_[column_].name;
    row_ += "\": ";
  }
  ++column_;
}

Table& Table::text(std::string_view value) {
  begin_value();
  if (format_ == Format::csv) {
    append_csv_text(row_, value);
  } else {
    row_ += nlohmann::json(value).dump();
  }
  return *this;
}

Table& Table::whole(std::uint64_t value) {
  begin_value();
  row_ += std::to_string(value);
  return *this;
}

Table& Table::real(double value) {
  begin_value();
  append_real(row_, value);
  return *this;
}

Table& Table::vector(const abut_vec3& value) {
  begin_value();
  row_ += format_ == Format::csv ? "" : "[";
  append_vector(row_, value, format_ == Format::csv ? "," : ", ");
  row_ += format_ == Format::csv ? "" : "]";
  return *this;
}

Table& Table::flag(bool value) {
  begin_value();
  row_ += format_ == Format::csv ? (value ? "1" : "0") : (value ? "true" : "false");
  return *this;
}

void Table::end_row() {
  if (format_ == Format::json) {
    file_.write(first_row_ ? "\n" : ",\n");
    row_ += '}';
  } else {
    row_ += '\n';
  }
  file_.write(row_);
  row_.clear();
  column_ = 0;
  first_row_ = false;
}

void Table::finish() {
  if (format_ == Format::json) {
    file_.write(first_row_ ? "]\n" : "\n]\n");
  }
  file_.finish();
}

}  // namespace cli
