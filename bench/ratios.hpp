// SPDX-License-Identifier: Apache-2.0
// Runs the registered benchmarks with repetitions in random order and prints a table of ratios.
#pragma once
#include <set>
#include <string>
#include <vector>

namespace bench {

// Names are "<cell>/<contender>": the time of a cell is that of its median repetition.
struct Comparison {
  std::string ours;                 // the contender that the others are compared with
  std::vector<std::string> judged;  // the best of these over ours is the ratio
  std::vector<std::string> others;  // printed, not judged
  double items = 1;                 // the time is divided by this
  std::string unit;                 // of the time that is left, such as "ns"
  double seconds = 1e-9;            // that unit in seconds
  std::set<std::string> unlike{};   // names with other answers than ours: starred, and not in the second ratio
  bool has_summary = false;         // median and 90th percentile of each contender over its cells
};

// The main of a suite: reads the flags of Google Benchmark, runs the suite and prints what it throws. Without flags
// there are five short repetitions in random order. Returns what main returns, as the suite does.
[[nodiscard]] int run_suite(int argument_count, char** arguments, int (*suite)());

// Whether --benchmark_filter selects this name: what it leaves out need not be made ready.
[[nodiscard]] bool is_selected(const std::string& name);

// Runs what was registered and prints the table. Returns what main returns.
[[nodiscard]] int run_and_compare(const Comparison& comparison);

}  // namespace bench
