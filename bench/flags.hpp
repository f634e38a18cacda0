// SPDX-License-Identifier: Apache-2.0
// Flags of the benchmarks that measure errors: pairs of --name value. A later one wins.
#pragma once
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {

[[noreturn]] inline void refuse(const std::string& flag, const char* usage) {
  throw std::runtime_error("'" + flag + "' makes no sense here\n" + usage);
}

// Those of Google Benchmark, which scripts/bench hands to all suites, mean nothing here.
[[nodiscard]] inline std::vector<std::pair<std::string, std::string>> flags_of(std::vector<std::string> words,
                                                                               const char* usage) {
  std::erase_if(words, [](const std::string& word) { return word.starts_with("--benchmark_"); });
  std::vector<std::pair<std::string, std::string>> flags;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    if (!words[i].starts_with("--")) {
      refuse(words[i], usage);
    }
    flags.emplace_back(words[i], i + 1 < words.size() ? words[i + 1] : "");
  }
  return flags;
}

[[nodiscard]] inline std::size_t count_of(const std::string& flag, const std::string& text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), std::to_address(text.end()), value);
  if (error != std::errc{} || end != std::to_address(text.end()) || value < 1 || value > 10'000) {
    throw std::runtime_error(flag + " takes a whole number from 1 to 10000, not '" + text + "'");
  }
  return value;
}

// Runs a program that throws where something is wrong; the exit status.
template <class Run>
[[nodiscard]] int main_of(int count, char** words, const char* usage, const Run& run) {
  try {
    const std::vector<std::string> all(words, std::next(words, count)), given(all.begin() + 1, all.end());
    if (!given.empty() && (given.front() == "--help" || given.front() == "-h")) {
      std::printf("%s", usage);
      return 0;
    }
    run(given);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace bench
