// Worst errors per row, printed and written as CSV at the end of a program.
#pragma once

#include <cstdint>
#include <map>
#include <string>

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

  // Counts a failure of a row; true while there are no more than the known ones.
  [[nodiscard]] bool fails_as_known(const std::string& row);

  // Of all rows so far, known ones included.
  [[nodiscard]] std::uint64_t failures() const { return failures_; }

  // Counts a case of a row in which anything failed.
  void mark_failed(const std::string& row) { ++rows_[row].failures; }

  // What was added to a row; zeros where nothing was.
  [[nodiscard]] Worst worst_of(const std::string& row) const;

  void print() const;
  void write_csv(const std::string& path) const;

 private:
  std::map<std::string, Worst> rows_;
  std::uint64_t failures_ = 0;
};

// The record of this program.
[[nodiscard]] Record& record();

}  // namespace property
