// SPDX-License-Identifier: Apache-2.0
// Plays committed and random motions of features without a fuzzing engine.
// usage: abut_fuzz_touch <folder of fuzz> [random motions] [seed]
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>

#include "../files.hpp"
#include "touch.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

bool has_finding(const Bytes& bytes, const std::string& name) {
  return fuzz_files::report(name, touch_fuzzing::finding_of(bytes));
}

// Few different numbers, so that edges are parallel, faces have no area, and motions stay in a plane by chance.
Bytes random_motion(std::mt19937& random) {
  const auto flags = static_cast<std::uint8_t>(random() % 4);
  const auto kinds = 2 + random() % 8;
  Bytes bytes{flags};
  for (int i = 0; i < 24; ++i) {
    const auto choice = static_cast<std::uint8_t>(random() % kinds);
    if ((flags & 2U) != 0) {
      bytes.push_back(choice);
      continue;
    }
    // 1, then its neighbour, halves of it, and others.
    const double value = choice == 1 ? 1 : choice == 2 ? 1 + 0x1p-52 : choice == 0 ? 0 : -1.0 / choice;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned byte = 0; byte < 8; ++byte) {
      bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * byte)));
    }
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  std::copy_n(argv, argc, std::back_inserter(arguments));
  if (arguments.size() < 2) {
    std::puts("usage: abut_fuzz_touch <folder of fuzz> [random motions] [seed]");
    return 2;
  }
  const std::size_t count = arguments.size() > 2 ? std::stoul(arguments[2]) : 0;
  const std::size_t seed = arguments.size() > 3 ? std::stoul(arguments[3]) : 1;
  std::size_t files = 0, findings = 0;
  for (const char* folder : {"corpus/touch", "regress/touch"}) {
    for (const std::filesystem::path& path : fuzz_files::files_in(std::filesystem::path(arguments[1]) / folder)) {
      ++files;
      findings += has_finding(fuzz_files::bytes_of(path), path.filename().string()) ? 1 : 0;
    }
  }
  std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
  for (std::size_t i = 0; i < count; ++i) {
    findings += has_finding(random_motion(random), "motion " + std::to_string(i)) ? 1 : 0;
  }
  std::printf("%zu findings in %zu files and %zu random motions of seed %zu\n", findings, files, count, seed);
  return files == 0 || findings > 0 ? 1 : 0;
}
