// SPDX-License-Identifier: Apache-2.0
// Error against run time: signed distances of abut, Bullet, FCL and libccd beside the float128 oracle of the tests,
// under conditions from ordinary to extreme.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "accuracy_picture.hpp"
#include "accuracy_rows.hpp"
#include "accuracy_scenes.hpp"
#include "accuracy_tables.hpp"
#include "agreement.hpp"

namespace bench {
namespace {

constexpr std::array kinds{Kind::sphere, Kind::capsule, Kind::box, Kind::cylinder, Kind::hull32, Kind::hull200};

constexpr const char* usage = R"(usage: abut_bench_accuracy [--out FOLDER] [--cases N] [--repetitions N] [--only TEXT]

Prints tables of time and error, and writes accuracy.csv, distance.svg and depth.svg.
  --out FOLDER      where the files go (out/accuracy)
  --cases N         placed pairs for each pair of kinds, question and condition (32)
  --repetitions N   of each timing (5)
  --only TEXT       only what has this in its name, such as depth/ordinary/box-hull32
)";

struct Flags {
  std::filesystem::path out = "out/accuracy";
  std::size_t cases = 32, repetitions = 5;
  std::string only;
};

std::size_t count_of(const std::string& flag, const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), std::to_address(text.end()), value);
  if (error != std::errc{} || end != std::to_address(text.end()) || value < 1 || value > 10'000) {
    throw std::runtime_error(flag + " takes a whole number from 1 to 10000, not '" + text + "'");
  }
  return value;
}

// A later flag wins. Those of Google Benchmark, which scripts/bench hands to all suites, mean nothing here.
Flags flags_of(std::vector<std::string> words) {
  std::erase_if(words, [](const std::string& word) { return word.starts_with("--benchmark_"); });
  Flags flags;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const std::string value = i + 1 < words.size() ? words[i + 1] : "";
    if (words[i] == "--out" && !value.empty()) {
      flags.out = value;
    } else if (words[i] == "--cases") {
      flags.cases = count_of(words[i], value);
    } else if (words[i] == "--repetitions") {
      flags.repetitions = count_of(words[i], value);
    } else if (words[i] == "--only") {
      flags.only = value;
    } else {
      throw std::runtime_error("'" + words[i] + "' makes no sense here\n" + usage);
    }
  }
  return flags;
}

void add_rows(const Flags& flags, Query query, Condition condition, AccuracyScenes& scenes, std::vector<Row>& rows) {
  for (std::size_t b = 0; b < kinds.size(); ++b) {
    for (std::size_t a = 0; a <= b; ++a) {
      const std::string pair = std::string(kind_name(kinds[a])) + "-" + std::string(kind_name(kinds[b]));
      const std::string name =
          std::string(query_name(query)) + "/" + std::string(condition_name(condition)) + "/" + pair;
      if (name.find(flags.only) == std::string::npos) {
        continue;
      }
      if (const auto cell = scenes.make(query, condition, kinds[a], kinds[b], flags.cases)) {
        std::vector<Row> more = measured(query, condition, pair, *cell, flags.repetitions);
        std::ranges::move(more, std::back_inserter(rows));
      }
    }
  }
}

void run(const Flags& flags) {
  std::filesystem::create_directories(flags.out);
  AccuracyScenes scenes;
  std::vector<Row> rows;
  for (const Query query : {Query::distance, Query::depth}) {
    for (const Condition condition : all_conditions) {
      std::fprintf(stderr, "%s, %s\n", std::string(query_name(query)).c_str(),
                   std::string(condition_title(condition)).c_str());
      add_rows(flags, query, condition, scenes, rows);
    }
  }
  if (rows.empty()) {
    throw std::runtime_error("--only is '" + flags.only + "'; nothing that is asked has it in its name");
  }
  print_tables(rows);
  print_prices(rows);
  write_rows(flags.out / "accuracy.csv", rows);
  write_picture(flags.out / "distance.svg", rows, Query::distance);
  write_picture(flags.out / "depth.svg", rows, Query::depth);
}

}  // namespace
}  // namespace bench

int main(int argument_count, char** arguments) {
  try {
    const std::vector<std::string> all(arguments, std::next(arguments, argument_count)),
        words(all.begin() + 1, all.end());
    if (!words.empty() && (words.front() == "--help" || words.front() == "-h")) {
      std::printf("%s", bench::usage);
      return 0;
    }
    bench::run(bench::flags_of(words));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
