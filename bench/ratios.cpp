// SPDX-License-Identifier: Apache-2.0
#include "ratios.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "statistics.hpp"

namespace bench {
namespace {

// Repetitions of one benchmark in seconds.
using Times = std::vector<double>;

class Collector final : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override {
    PrintBasicContext(&GetErrorStream(), context);
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) {
        continue;
      }
      const std::string& name = run.run_name.function_name;
      const std::size_t slash = name.rfind('/');
      const std::string cell = name.substr(0, slash);
      const auto place = order_.try_emplace(cell, run.family_index).first;
      place->second = std::min(place->second, run.family_index);
      times_[cell][name.substr(slash + 1)].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
  }

  void print(const Comparison& comparison) const {
    std::vector<std::string> columns{comparison.ours};
    columns.insert(columns.end(), comparison.judged.begin(), comparison.judged.end());
    columns.insert(columns.end(), comparison.others.begin(), comparison.others.end());
    std::printf(
        "\n%s per item, median of the repetitions (spread: of ours, largest over smallest repetition;"
        " *: other answers)\n%-40s",
        comparison.unit.c_str(), "");
    for (const std::string& column : columns) {
      std::printf(" %12s ", column.c_str());
    }
    std::printf(" %8s %8s %8s\n", "ratio", "like", "spread");
    // Cells in the order of their registration: repetitions come in any order.
    std::vector<std::pair<std::int64_t, std::string>> cells;
    for (const auto& [cell, place] : order_) {
      cells.emplace_back(place, cell);
    }
    std::sort(cells.begin(), cells.end());
    for (const auto& [place, cell] : cells) {
      print_row(cell, columns, comparison);
    }
    if (comparison.has_summary) {
      print_summary(columns, comparison);
    }
  }

 private:
  void print_summary(const std::vector<std::string>& columns, const Comparison& comparison) const {
    std::printf("\nOver the cells of each\n%-12s %8s %10s %10s %10s\n", "", "cells", "median", "90th", "90th/median");
    for (const std::string& column : columns) {
      Times times;
      for (const auto& [cell, contenders] : times_) {
        if (const auto found = contenders.find(column); found != contenders.end()) {
          times.push_back(median(found->second) / (comparison.items * comparison.seconds));
        }
      }
      if (!times.empty()) {
        const double half = median(times), most = percentile(times, 90);
        std::printf("%-12s %8zu %10.1f %10.1f %10.2f\n", column.c_str(), times.size(), half, most, most / half);
      }
    }
  }

  void print_row(const std::string& cell, const std::vector<std::string>& columns, const Comparison& comparison) const {
    const auto& contenders = times_.at(cell);
    const auto time_of = [&](const std::string& name) {
      const auto found = contenders.find(name);
      return found == contenders.end() ? 0 : median(found->second) / (comparison.items * comparison.seconds);
    };
    const auto is_unlike = [&](const std::string& name) { return comparison.unlike.contains(cell + "/" + name); };
    std::printf("%-40s", cell.c_str());
    for (const std::string& column : columns) {
      if (const double time = time_of(column); time > 0) {
        std::printf(" %12.1f%c", time, is_unlike(column) ? '*' : ' ');
      } else {
        std::printf(" %12s ", "-");
      }
    }
    double best = 0, best_like = 0;
    for (const std::string& name : comparison.judged) {
      if (const double time = time_of(name); time > 0) {
        best = best == 0 ? time : std::min(best, time);
        if (!is_unlike(name)) {
          best_like = best_like == 0 ? time : std::min(best_like, time);
        }
      }
    }
    const double ours = time_of(comparison.ours);
    if (best > 0 && ours > 0) {
      const auto [least, most] = std::ranges::minmax(contenders.at(comparison.ours));
      std::printf(" %8.2f", best / ours);
      if (best_like > 0) {
        std::printf(" %8.2f", best_like / ours);
      } else {
        std::printf(" %8s", "-");
      }
      std::printf(" %8.2f", most / least);
    }
    std::printf("\n");
  }

  std::map<std::string, std::int64_t> order_;
  std::map<std::string, std::map<std::string, Times>> times_;
};

// False when one is unknown.
bool read_flags(int argument_count, char** arguments) {
  std::vector<std::string> words{"benchmark", "--benchmark_repetitions=5",
                                 "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.02"};
  std::vector<char*> defaults;
  for (std::string& word : words) {
    defaults.push_back(word.data());
  }
  int default_count = static_cast<int>(defaults.size());
  benchmark::Initialize(&default_count, defaults.data());
  // The flags of the caller come second and win.
  benchmark::Initialize(&argument_count, arguments);
  return !benchmark::ReportUnrecognizedArguments(argument_count, arguments);
}

}  // namespace

int run_suite(int argument_count, char** arguments, int (*suite)()) {
  if (!read_flags(argument_count, arguments)) {
    return 1;
  }
  try {
    return suite();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

bool is_selected(const std::string& name) {
  const std::string filter = benchmark::GetBenchmarkFilter();
  // A leading minus turns the filter round; such runs make everything ready.
  if (filter.empty() || filter == "all" || filter.front() == '-') {
    return true;
  }
  return std::regex_search(name, std::regex(filter, std::regex::extended));
}

int run_and_compare(const Comparison& comparison) {
  Collector collector;
  if (benchmark::RunSpecifiedBenchmarks(&collector) == 0) {
    return 1;
  }
  collector.print(comparison);
  benchmark::Shutdown();
  return 0;
}

}  // namespace bench
