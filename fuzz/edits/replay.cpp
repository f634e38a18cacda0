// SPDX-License-Identifier: Apache-2.0
// Plays the committed edits and random ones, without a fuzzing engine.
// usage: abut_fuzz_edits <folder of fuzz> [random sequences] [first seed]
#include <cstdio>
#include <iterator>
#include <random>

#include "../files.hpp"
#include "record.hpp"

namespace {

using namespace edit_fuzzing;

std::vector<std::uint8_t> random_bytes(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> bytes(record_size * (1 + random() % most_edits));
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(random());
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments;
  std::copy_n(argv, argc, std::back_inserter(arguments));
  if (arguments.size() < 2) {
    std::puts("usage: abut_fuzz_edits <folder of fuzz> [random sequences] [first seed]");
    return 2;
  }
  const std::size_t sequences = arguments.size() > 2 ? std::stoul(arguments[2]) : 0;
  const std::uint64_t first = arguments.size() > 3 ? std::stoull(arguments[3]) : 1;
  Counts counts;
  std::size_t findings = 0;
  const auto play = [&](const std::string& name, const std::vector<std::uint8_t>& bytes) {
    findings += fuzz_files::report(name, finding_of(bytes, counts)) ? 1 : 0;
  };
  for (const char* folder : {"corpus/edits", "regress/edits"}) {
    for (const std::filesystem::path& path : fuzz_files::files_in(std::filesystem::path(arguments[1]) / folder)) {
      play(path.filename().string(), fuzz_files::bytes_of(path));
    }
  }
  for (std::uint64_t seed = first; seed < first + sequences; ++seed) {
    play("seed " + std::to_string(seed), random_bytes(seed));
  }
  std::printf("%zu findings: %zu edits, %zu refused, %zu rays, %zu distances and %zu touches judged, %zu excused\n",
              findings, counts.edits, counts.refused, counts.rays, counts.distances, counts.touches, counts.excused);
  const bool has_judged = counts.rays > 0 && counts.distances > 0 && counts.touches > 0 && counts.refused > 0;
  constexpr std::size_t touches_of_an_excuse = 2000;
  return findings == 0 && has_judged && counts.excused * touches_of_an_excuse <= counts.touches ? 0 : 1;
}
