// SPDX-License-Identifier: Apache-2.0
#include "accuracy_tables.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "agreement.hpp"
#include "statistics.hpp"

namespace bench {
namespace {

constexpr std::array questions{Query::distance, Query::depth};

std::string count_text(const std::optional<Broken>& broken, std::size_t Broken::* which) {
  return broken ? std::to_string((*broken).*which) : "-";
}

std::string number(const char* format, double value) {
  std::array<char, 32> text{};
  const int length = std::snprintf(text.data(), text.size(), format, value);
  return {text.data(), static_cast<std::size_t>(std::max(length, 0))};
}

struct Errors {
  std::string median = "-", tail = "-", worst = "-";
};

Errors errors_of(const Row& row) {
  if (row.errors.empty()) {
    return {};
  }
  return {number("%.1e", median(row.errors)), number("%.1e", percentile(row.errors, 99)),
          number("%.1e", *std::max_element(row.errors.begin(), row.errors.end()))};
}

void print_row(const Row& row) {
  const auto& [middle, tail, worst] = errors_of(row);
  const std::string name(entrants()[row.entrant].name);
  std::printf("%-16s %6zu %6zu %10.1f %9s %9s %9s %7zu %8s %7s %6s\n", name.c_str(), row.pairs, row.cases,
              row.nanoseconds, middle.c_str(), tail.c_str(), worst.c_str(), row.failed.total(),
              count_text(row.broken, &Broken::outside).c_str(), count_text(row.broken, &Broken::beyond).c_str(),
              count_text(row.broken, &Broken::wide).c_str());
}

void print_table(std::span<const Row> rows, Query query, Condition condition) {
  bool has_head = false;
  for (std::size_t entrant = 0; entrant < entrants().size(); ++entrant) {
    const std::vector<Row> of_pairs = selected(rows, query, condition, entrant);
    if (of_pairs.empty()) {
      continue;
    }
    if (!has_head) {
      std::printf("\n%s, %s\n%-16s %6s %6s %10s %9s %9s %9s %7s %8s %7s %6s\n", std::string(query_name(query)).c_str(),
                  std::string(condition_title(condition)).c_str(), "", "pairs", "cases", "ns", "median", "99 %",
                  "worst", "failed", "outside", "beyond", "wide");
      has_head = true;
    }
    print_row(together(of_pairs));
  }
}

}  // namespace

std::vector<Row> selected(std::span<const Row> rows, Query query, Condition condition, std::size_t entrant) {
  std::vector<Row> list;
  std::ranges::copy_if(rows, std::back_inserter(list), [&](const Row& row) {
    return row.query == query && row.condition == condition && row.entrant == entrant;
  });
  return list;
}

void print_tables(std::span<const Row> rows) {
  std::printf("Errors by the sum of the diameters; times per query, median of the pairs\n");
  for (const Query query : questions) {
    for (const Condition condition : all_conditions) {
      print_table(rows, query, condition);
    }
  }
}

void print_prices(std::span<const Row> rows) {
  for (const Query query : questions) {
    std::printf("\nns of abut for each error bound, %s, ordinary\n%-20s", std::string(query_name(query)).c_str(), "");
    for (std::size_t i = first_bound; i < first_bound + bound_count; ++i) {
      std::printf(" %11s", std::string(entrants()[i].name).c_str());
    }
    std::printf("  last/first\n");
    std::array<std::vector<Row>, bound_count> columns;
    for (std::size_t i = 0; i < bound_count; ++i) {
      columns.at(i) = selected(rows, query, Condition::ordinary, first_bound + i);
    }
    for (std::size_t pair = 0; pair < columns.front().size(); ++pair) {
      std::printf("%-20s", columns.front()[pair].pair.c_str());
      for (const std::vector<Row>& column : columns) {
        std::printf(" %11.1f", column[pair].nanoseconds);
      }
      std::printf(" %11.2f\n", columns.back()[pair].nanoseconds / columns.front()[pair].nanoseconds);
    }
  }
}

void write_rows(const std::filesystem::path& path, std::span<const Row> rows) {
  std::ofstream file(path);
  file << "question,condition,pair,contender,nanoseconds,median_error,error_of_99_percent,worst_error,cases,failed,"
          "outside,"
          "beyond,wide\n";
  const auto or_nothing = [](const std::string& text) { return text == "-" ? std::string() : text; };
  for (const Row& row : rows) {
    const Errors errors = errors_of(row);
    file << query_name(row.query) << ',' << condition_name(row.condition) << ',' << row.pair << ','
         << entrants()[row.entrant].name << ',' << number("%.1f", row.nanoseconds) << ',' << or_nothing(errors.median)
         << ',' << or_nothing(errors.tail) << ',' << or_nothing(errors.worst) << ',' << row.cases << ','
         << row.failed.total();
    for (const auto which : {&Broken::outside, &Broken::beyond, &Broken::wide}) {
      file << ',' << or_nothing(count_text(row.broken, which));
    }
    file << '\n';
  }
  if (!file.flush()) {
    throw std::runtime_error(path.string() + " cannot be written");
  }
}

}  // namespace bench
