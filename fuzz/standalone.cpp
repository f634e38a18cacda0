// SPDX-License-Identifier: Apache-2.0
// Judges the committed records of all pairs, and random ones, without a fuzzing engine.
// Findings named in open.txt of the folder are known defects: they are expected to be refused still, and to be off by
// no more than the list says.
// usage: abut_fuzz_replay <folder with corpus/ and regress/> [random records per pair] [seed] [only pairs with this
// kind]
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files.hpp"

import abut.fuzz;
import abut.pairs.any_shape;

namespace {

using namespace abut::fuzz;

struct Pair {
  std::size_t a, b;
  std::string name;
};

// All of them, or those with a kind.
std::vector<Pair> pairs_with(const std::string& kind) {
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < abut::shape_kind_count; ++a) {
    for (std::size_t b = 0; b < abut::shape_kind_count; ++b) {
      const bool is_wanted = kind.empty() || abut::kind_name(a) == kind || abut::kind_name(b) == kind;
      if (is_wanted && abut::kind_name(a) <= abut::kind_name(b)) {
        pairs.push_back({a, b, std::string(abut::kind_name(a)) + "_" + std::string(abut::kind_name(b))});
      }
    }
  }
  std::ranges::sort(pairs, {}, &Pair::name);
  return pairs;
}

Verdict judge_safely(const Pair& pair, const Record& record) {
  try {
    return judge(pair.a, pair.b, record);
  } catch (const std::exception& error) {
    return "exception: " + std::string(error.what());
  }
}

// Lines of "<pair> <file> <size>"; the size is by how much the first fact that does not hold is missed.
std::map<std::string, double> open_findings(const std::filesystem::path& root) {
  std::ifstream file(root / "open.txt");
  std::map<std::string, double> sizes;
  std::string pair, record;
  for (double size = 0; file >> pair >> record >> size;) {
    sizes[pair + " " + record] = size;
  }
  return sizes;
}

// The number after a word of a verdict.
double number_after(const std::string& verdict, std::string_view word) {
  const std::size_t at = verdict.find(word);
  return at == std::string::npos ? 0 : std::strtod(verdict.substr(at + word.size()).c_str(), nullptr);
}

// "got x, expected y" is off by their difference; verdicts without numbers are off by nothing.
double size_of(const std::string& verdict) {
  return std::fabs(number_after(verdict, "got ") - number_after(verdict, ", expected "));
}

// A known finding may grow by this part: what a compiler rounds differently.
constexpr double headroom = 0.1;

int replay(const std::filesystem::path& root, std::size_t random_count, std::uint64_t seed, const std::string& kind) {
  std::size_t judged = 0, files = 0, findings = 0;
  const std::map<std::string, double> open = open_findings(root);
  const auto report = [&](const Pair& pair, const std::string& record, const Verdict& verdict) {
    ++judged;
    const auto listed = open.find(pair.name + " " + record);
    const bool is_open = listed != open.end();
    if (verdict && is_open && size_of(*verdict) > (1 + headroom) * listed->second) {
      ++findings;
      std::printf("%s %s has grown, now %.2g: %s\n", pair.name.c_str(), record.c_str(), size_of(*verdict),
                  verdict->c_str());
    } else if (verdict) {
      findings += is_open ? 0 : 1;
      std::printf("%s%s %s: %s\n", is_open ? "(open) " : "", pair.name.c_str(), record.c_str(), verdict->c_str());
    } else if (is_open) {
      ++findings;
      std::printf("%s %s is answered well now: take it out of open.txt\n", pair.name.c_str(), record.c_str());
    }
  };
  for (const Pair& pair : pairs_with(kind)) {
    const std::string a(abut::kind_name(pair.a)), b(abut::kind_name(pair.b));
    for (const std::filesystem::path& path : fuzz_files::files_of_pair(root, a, b)) {
      ++files;
      report(pair, path.filename().string(), judge_safely(pair, read_record(fuzz_files::bytes_of(path))));
    }
    for (std::uint64_t i = 0; i < random_count; ++i) {
      Record record = random_record(seed + i);
      // Every third one touches, the most telling place.
      if (i % 3 == 0) {
        snap_to_touching(pair.a, pair.b, record);
      }
      report(pair, "random record " + std::to_string(seed + i), judge_safely(pair, record));
    }
  }
  std::printf("%zu findings in %zu records (%zu files), seed %llu\n", findings, judged, files,
              static_cast<unsigned long long>(seed));
  // A kind may have no files yet, but then has random records.
  const bool is_empty = kind.empty() ? files == 0 : judged == 0;
  if (is_empty) {
    std::printf("nothing to judge below %s%s%s\n", root.c_str(), kind.empty() ? "" : " for the kind ", kind.c_str());
  }
  return findings == 0 && !is_empty ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** values) {
  std::vector<std::string> arguments;
  std::copy_n(values, count, std::back_inserter(arguments));
  if (arguments.size() < 2) {
    std::fprintf(stderr, "usage: abut_fuzz_replay <folder> [random records per pair] [seed] [kind]\n");
    return 2;
  }
  const auto number = [&](std::size_t place) { return arguments.size() > place ? std::stoull(arguments[place]) : 0; };
  return replay(arguments[1], number(2), number(3), arguments.size() > 4 ? arguments[4] : "");
}
