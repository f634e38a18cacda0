// SPDX-License-Identifier: Apache-2.0
// Judges the committed contact problems and random ones, without a fuzzing engine.
// usage: abut_fuzz_response <folder of fuzz> [random problems] [seed]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "../files.hpp"
#include "problem.hpp"

namespace {

bool has_finding(const std::vector<std::uint8_t>& bytes, const std::string& name) {
  return fuzz_files::report(name, response_fuzzing::finding_of(bytes));
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  std::copy_n(argv, argc, std::back_inserter(arguments));
  if (arguments.size() < 2) {
    std::puts("usage: abut_fuzz_response <folder of fuzz> [random problems] [seed]");
    return 2;
  }
  const std::size_t count = arguments.size() > 2 ? std::stoul(arguments[2]) : 0;
  const std::size_t seed = arguments.size() > 3 ? std::stoul(arguments[3]) : 1;
  std::size_t files = 0, findings = 0;
  for (const char* folder : {"corpus/response", "regress/response"}) {
    for (const std::filesystem::path& path : fuzz_files::files_in(std::filesystem::path(arguments[1]) / folder)) {
      ++files;
      findings += has_finding(fuzz_files::bytes_of(path), path.filename().string()) ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed + i));
    std::vector<std::uint8_t> bytes(400);
    std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random()); });
    findings += has_finding(bytes, "random problem " + std::to_string(seed + i)) ? 1 : 0;
  }
  std::printf("%zu files, %zu random problems from seed %zu, %zu findings\n", files, count, seed, findings);
  return findings > 0 ? 1 : 0;
}
