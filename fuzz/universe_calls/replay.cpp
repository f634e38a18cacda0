// SPDX-License-Identifier: Apache-2.0
// Plays the committed sequences and random ones, without a fuzzing engine.
// usage: abut_fuzz_universe <folder with corpus/ and regress/> [random sequences] [calls of each] [first seed]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "../files.hpp"
#include "play.hpp"

namespace {

using namespace universe_calls;

class Replay {
 public:
  void play(const std::string& name, const Sequence& sequence) {
    Play play(sequence);
    if (const std::optional<std::string> finding = play.run()) {
      std::printf("%s: %s\n", name.c_str(), finding->c_str());
      ++findings_;
    }
    ++sequences_;
    const Counts& counts = play.counts();
    sum_.calls += counts.calls;
    sum_.detections += counts.detections;
    sum_.contacts += counts.contacts;
    sum_.events += counts.events;
    sum_.refusals += counts.refusals;
    sum_.filtered += counts.filtered;
    sum_.switched += counts.switched;
    sum_.sleeps += counts.sleeps;
  }

  void play_files(const std::filesystem::path& folder) {
    for (const std::filesystem::path& path : fuzz_files::files_in(folder)) {
      play(path.filename().string(), read_sequence(fuzz_files::bytes_of(path)));
    }
  }

  int report() const {
    std::printf(
        "%zu findings in %zu sequences: %zu calls, %zu detections, %zu "
        "contacts, %zu events, %zu refused calls, %zu questions to filters, "
        "%zu switches of tags, %zu times asleep\n",
        findings_, sequences_, sum_.calls, sum_.detections, sum_.contacts, sum_.events, sum_.refusals, sum_.filtered,
        sum_.switched, sum_.sleeps);
    return findings_ == 0 && sequences_ > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

 private:
  Counts sum_;
  std::size_t findings_ = 0, sequences_ = 0;
};

}  // namespace

int main(int count, char** values) {
  std::vector<std::string> arguments;
  std::copy_n(values, count, std::back_inserter(arguments));
  if (arguments.size() < 2) {
    std::fprintf(stderr,
                 "usage: abut_fuzz_universe <folder> [random "
                 "sequences] [calls of each] [first seed]\n");
    return 2;
  }
  const auto number = [&](std::size_t place, std::size_t otherwise) {
    return arguments.size() > place ? std::stoul(arguments[place]) : otherwise;
  };
  Replay replay;
  const std::filesystem::path folder = arguments[1];
  replay.play_files(folder / "corpus" / "universe");
  replay.play_files(folder / "regress" / "universe");
  const std::size_t calls = number(3, 200), first = number(4, 0);
  for (std::size_t seed = first; seed < first + number(2, 0); ++seed) {
    replay.play("seed " + std::to_string(seed), random_sequence(seed, calls));
  }
  return replay.report();
}
