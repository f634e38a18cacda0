// SPDX-License-Identifier: Apache-2.0
// Worst errors per row, printed and written as CSV at the end of a program.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "shortfall.hpp"

namespace property {

struct Worst {
  std::uint64_t cases = 0;
  std::uint64_t failures = 0;
  double error = 0;  // largest relative error
  double gap = 0;    // largest upper - lower, relative
  std::uint32_t iterations = 0;
  std::string where;  // the case of the largest error
};

// Rows by name, such as "box/hull touching".
class Record {
 public:
  void add(const std::string& row, const std::string& where, double error, double gap, std::uint32_t iterations);

  // Counts an offence of a size against a fact; true while there are no more than the known ones and none is larger.
  [[nodiscard]] bool fails_as_known(const std::string& row, double size, std::span<const Shortfall> known);

  // Prints the rows of a list that are no longer as they are listed, as they should be; true where there are none.
  [[nodiscard]] bool is_as_known(std::span<const Shortfall> known) const;

  // Of all rows so far, known ones included.
  [[nodiscard]] std::uint64_t failures() const { return failures_; }

  // Counts a case of a row in which anything failed.
  void mark_failed(const std::string& row) { ++rows_[row].failures; }

  // What was added to a row; zeros where nothing was.
  [[nodiscard]] Worst worst_of(const std::string& row) const;

  void print() const;
  void write_csv(const std::string& path) const;

 private:
  struct Offences {
    std::uint64_t cases = 0;
    double most = 0;
  };

  std::map<std::string, Worst> rows_;
  std::map<std::string, Offences> offences_;
  std::uint64_t failures_ = 0;
};

// The record of this program.
[[nodiscard]] Record& record();

}  // namespace property
