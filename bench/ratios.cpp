#include "ratios.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bench {
namespace {

// Repetitions of one benchmark in seconds.
using Times = std::vector<double>;

double median(Times times) {
  std::sort(times.begin(), times.end());
  const std::size_t middle = times.size() / 2;
  return times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
}

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
      if (!times_.contains(cell)) {
        order_.push_back(cell);
      }
      times_[cell][name.substr(slash + 1)].push_back(run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
  }

  void print(const Comparison& comparison) const {
    std::vector<std::string> columns{comparison.ours};
    columns.insert(columns.end(), comparison.judged.begin(), comparison.judged.end());
    columns.insert(columns.end(), comparison.others.begin(), comparison.others.end());
    std::printf("\n%s per item, median of the repetitions (spread: of ours, largest over smallest repetition)\n%-28s",
                comparison.unit.c_str(), "");
    for (const std::string& column : columns) {
      std::printf(" %12s", column.c_str());
    }
    std::printf(" %8s %8s\n", "ratio", "spread");
    for (const std::string& cell : order_) {
      print_row(cell, columns, comparison);
    }
  }

 private:
  void print_row(const std::string& cell, const std::vector<std::string>& columns, const Comparison& comparison) const {
    const auto& contenders = times_.at(cell);
    const auto time_of = [&](const std::string& name) {
      const auto found = contenders.find(name);
      return found == contenders.end() ? 0 : median(found->second) / (comparison.items * comparison.seconds);
    };
    std::printf("%-28s", cell.c_str());
    for (const std::string& column : columns) {
      if (const double time = time_of(column); time > 0) {
        std::printf(" %12.1f", time);
      } else {
        std::printf(" %12s", "-");
      }
    }
    double best = 0;
    for (const std::string& name : comparison.judged) {
      const double time = time_of(name);
      best = time > 0 && (best == 0 || time < best) ? time : best;
    }
    const double ours = time_of(comparison.ours);
    if (best > 0 && ours > 0) {
      const auto [least, most] = std::ranges::minmax(contenders.at(comparison.ours));
      std::printf(" %8.2f %8.2f", best / ours, most / least);
    }
    std::printf("\n");
  }

  std::vector<std::string> order_;
  std::map<std::string, std::map<std::string, Times>> times_;
};

}  // namespace

int run_and_compare(int argument_count, char** arguments, const Comparison& comparison) {
  std::vector<std::string> words{"benchmark", "--benchmark_repetitions=5", "--benchmark_enable_random_interleaving=true",
                                 "--benchmark_min_time=0.02"};
  std::vector<char*> defaults;
  for (std::string& word : words) {
    defaults.push_back(word.data());
  }
  int default_count = static_cast<int>(defaults.size());
  benchmark::Initialize(&default_count, defaults.data());
  // The flags of the caller come second and win.
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) {
    return 1;
  }
  Collector collector;
  if (benchmark::RunSpecifiedBenchmarks(&collector) == 0) {
    return 1;
  }
  collector.print(comparison);
  benchmark::Shutdown();
  return 0;
}

}  // namespace bench
