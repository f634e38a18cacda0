#include "record.hpp"

#include "extreme_shortfalls.hpp"
#include "shortfalls.hpp"

#include <cstdio>
#include <fstream>

namespace property {

void Record::add(const std::string& row, const std::string& where, double error, double gap, std::uint32_t iterations) {
  Worst& worst = rows_[row];
  ++worst.cases;
  if (!(error <= worst.error)) {
    worst.error = error;
    worst.where = where;
  }
  if (!(gap <= worst.gap)) worst.gap = gap;
  if (iterations > worst.iterations) worst.iterations = iterations;
}

bool Record::fails_as_known(const std::string& row) {
  ++failures_;
  return ++rows_[row].failures <= known_shortfall(row) + known_extreme_shortfall(row);
}

Worst Record::worst_of(const std::string& row) const {
  const auto found = rows_.find(row);
  return found == rows_.end() ? Worst{} : found->second;
}

void Record::print() const {
  std::printf("%-44s %6s %6s %10s %10s %5s  %s\n", "row", "cases", "failed", "error", "gap", "steps", "worst case");
  for (const auto& [row, worst] : rows_) {
    std::printf("%-44s %6llu %6llu %10.2e %10.2e %5u  %s\n", row.c_str(), static_cast<unsigned long long>(worst.cases),
                static_cast<unsigned long long>(worst.failures), worst.error, worst.gap, worst.iterations,
                worst.where.c_str());
  }
}

void Record::write_csv(const std::string& path) const {
  std::ofstream file(path);
  file << "row,cases,failures,max_relative_error,max_relative_gap,max_iterations,worst_case\n";
  for (const auto& [row, worst] : rows_) {
    file << row << ',' << worst.cases << ',' << worst.failures << ',' << worst.error << ',' << worst.gap << ','
         << worst.iterations << ',' << worst.where << '\n';
  }
}

Record& record() {
  static Record instance;
  return instance;
}

}  // namespace property
