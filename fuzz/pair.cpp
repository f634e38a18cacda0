// SPDX-License-Identifier: Apache-2.0
// The live target of all pairs, as a shared library. The name of the program that loads it says which: fuzz_<a>_<b>,
// or fuzz_motion_<a>_<b> for their times of impact.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>
import abut.fuzz;
import abut.pairs.any_shape;

// The engine calls all but the first, which it has.
extern "C" {
[[gnu::visibility("default")]] std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
[[gnu::visibility("default")]] std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                                                   std::size_t max_size, unsigned int seed);
[[gnu::visibility("default")]] int LLVMFuzzerInitialize(int* count, char*** arguments);
[[gnu::visibility("default")]] int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
}

namespace {

// Places of the kinds among the registered ones.
struct Pair {
  std::size_t a = 0, b = 0;
  bool moves = false;
};

Pair& pair() {
  static Pair chosen;
  return chosen;
}

// Names of kinds have underscores of their own.
std::optional<Pair> pair_named(std::string_view program) {
  constexpr std::string_view prefix = "fuzz_", motion = "motion_";
  program.remove_prefix(program.rfind('/') + 1);
  if (!program.starts_with(prefix)) {
    return std::nullopt;
  }
  std::string_view kinds = program.substr(prefix.size());
  const bool moves = kinds.starts_with(motion);
  kinds.remove_prefix(moves ? motion.size() : 0);
  for (std::size_t end = kinds.find('_'); end != std::string_view::npos; end = kinds.find('_', end + 1)) {
    const auto a = abut::find_kind(kinds.substr(0, end)), b = abut::find_kind(kinds.substr(end + 1));
    if (a && b) {
      return Pair{*a, *b, moves};
    }
  }
  return std::nullopt;
}

abut::fuzz::Verdict judge(std::span<const std::uint8_t> bytes) {
  using namespace abut::fuzz;
  return pair().moves ? judge_motion(pair().a, pair().b, read_moving_record(bytes))
                      : judge(pair().a, pair().b, read_record(bytes));
}

template <class Record>
std::size_t mutate(Record record, std::uint8_t* data, unsigned int seed) {
  abut::fuzz::mutate(pair().a, pair().b, record, seed);
  const auto bytes = abut::fuzz::bytes_of(record);
  std::ranges::copy(bytes, data);
  return bytes.size();
}

}  // namespace

int LLVMFuzzerInitialize(int*, char*** arguments) {
  const std::optional<Pair> named = pair_named((*arguments)[0]);
  if (!named) {
    std::fprintf(stderr,
                 "%s: run this program under the name fuzz_<a>_<b> or fuzz_motion_<a>_<b> of two kinds of shapes\n",
                 (*arguments)[0]);
    std::exit(2);
  }
  pair() = *named;
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const abut::fuzz::Verdict verdict = judge({data, size})) {
    std::fprintf(stderr, "finding: %s\n", verdict->c_str());
    std::abort();
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  const bool moves = pair().moves;
  if (seed % 4 == 0 || max_size < (moves ? abut::fuzz::moving_record_size : abut::fuzz::record_size)) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  const std::span<const std::uint8_t> bytes{data, size};
  return moves ? mutate(abut::fuzz::read_moving_record(bytes), data, seed)
               : mutate(abut::fuzz::read_record(bytes), data, seed);
}
