// SPDX-License-Identifier: Apache-2.0
// Judges the committed motions of all pairs, and random ones, without a fuzzing engine.
// usage: abut_fuzz_replay_motions <folder with corpus/ and regress/> [random motions per pair] [seed] [only pairs with
// this kind]
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "files.hpp"

import abut.fuzz;
import abut.pairs.any_shape;

namespace {

using namespace abut::fuzz;

// Of these the motions of the corpus are judged; with all pairs that would take minutes.
constexpr std::array<std::string_view, 7> told_pairs{
    "motion_box_box",   "motion_capsule_capsule",      "motion_hull_hull", "motion_box_mesh", "motion_mesh_mesh",
    "motion_box_plane", "motion_distance_field_sphere"};

struct Counts {
  std::size_t judged = 0, findings = 0;
};

void judge_one(std::size_t a, std::size_t b, const MovingRecord& record, const std::string& name, Counts& counts) {
  Verdict verdict;
  try {
    verdict = judge_motion(a, b, record);
  } catch (const std::exception& error) {
    verdict = "exception: " + std::string(error.what());
  }
  ++counts.judged;
  if (verdict) {
    ++counts.findings;
    std::printf("%s: %s\n", name.c_str(), verdict->c_str());
  }
}

}  // namespace

int main(int count, char** values) {
  std::vector<std::string> arguments;
  std::copy_n(values, count, std::back_inserter(arguments));
  if (arguments.size() < 2) {
    std::fprintf(stderr, "usage: abut_fuzz_replay_motions <folder> [random motions per pair] [seed] [kind]\n");
    return 2;
  }
  const auto number = [&](std::size_t place) { return arguments.size() > place ? std::stoull(arguments[place]) : 0; };
  const std::filesystem::path root = arguments[1];
  const std::uint64_t random_count = number(2), seed = number(3);
  const std::string kind = arguments.size() > 4 ? arguments[4] : "";
  Counts counts;
  for (std::size_t a = 0; a < abut::shape_kind_count; ++a) {
    for (std::size_t b = 0; b < abut::shape_kind_count; ++b) {
      const bool is_wanted = kind.empty() || abut::kind_name(a) == kind || abut::kind_name(b) == kind;
      if (!is_wanted || abut::kind_name(a) > abut::kind_name(b)) {
        continue;
      }
      const std::string pair = "motion_" + std::string(abut::kind_name(a)) + "_" + std::string(abut::kind_name(b));
      std::vector<std::filesystem::path> files = fuzz_files::files_in(root / "regress" / pair);
      if (std::ranges::find(told_pairs, pair) != told_pairs.end()) {
        std::ranges::copy(fuzz_files::files_in(root / "corpus" / "motions"), std::back_inserter(files));
      }
      for (const std::filesystem::path& path : files) {
        const MovingRecord record = read_moving_record(fuzz_files::bytes_of(path));
        judge_one(a, b, record, pair + " " + path.filename().string(), counts);
      }
      for (std::uint64_t i = 0; i < random_count; ++i) {
        judge_one(a, b, random_moving_record(seed + i), pair + " random motion " + std::to_string(seed + i), counts);
      }
    }
  }
  std::printf("%zu findings in %zu motions, seed %llu\n", counts.findings, counts.judged,
              static_cast<unsigned long long>(seed));
  return counts.findings == 0 && counts.judged > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
