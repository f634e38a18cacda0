// SPDX-License-Identifier: Apache-2.0
#include "record.hpp"

#include <algorithm>
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

bool Record::fails_as_known(const std::string& row, double size, std::span<const Shortfall> known) {
  ++failures_;
  ++rows_[row].failures;
  Offences& offences = offences_[row];
  ++offences.cases;
  if (!(size <= offences.most)) offences.most = size;
  const auto found = std::ranges::find(known, row, &Shortfall::row);
  return found != known.end() && offences.cases <= found->cases && size <= (1 + headroom) * found->most;
}

bool Record::is_as_known(std::span<const Shortfall> known) const {
  bool is_same = true;
  const auto print = [&](const std::string& row, const Offences& offences) {
    is_same = false;
    std::printf("shortfalls should say {\"%s\", %llu, %.2g},\n", row.c_str(),
                static_cast<unsigned long long>(offences.cases), offences.most);
  };
  for (const auto& [row, offences] : offences_) {
    const auto listed = std::ranges::find(known, row, &Shortfall::row);
    if (listed == known.end() || listed->cases != offences.cases || offences.most > (1 + headroom) * listed->most ||
        offences.most < listed->most / 2) {
      print(row, offences);
    }
  }
  for (const Shortfall& listed : known) {
    const std::string row(listed.row);
    if (!offences_.contains(row)) print(row, {});
  }
  return is_same;
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
