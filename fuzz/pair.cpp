// SPDX-License-Identifier: Apache-2.0
// The live target of all pairs, as a shared library. The name of the program that loads it says which: fuzz_<a>_<b>.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
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
};

Pair& pair() {
  static Pair chosen;
  return chosen;
}

// Names of kinds have underscores of their own.
std::optional<Pair> pair_named(std::string_view program) {
  constexpr std::string_view prefix = "fuzz_";
  program.remove_prefix(program.rfind('/') + 1);
  if (!program.starts_with(prefix)) {
    return std::nullopt;
  }
  const std::string_view kinds = program.substr(prefix.size());
  for (std::size_t end = kinds.find('_'); end != std::string_view::npos; end = kinds.find('_', end + 1)) {
    const auto a = abut::find_kind(kinds.substr(0, end)), b = abut::find_kind(kinds.substr(end + 1));
    if (a && b) {
      return Pair{*a, *b};
    }
  }
  return std::nullopt;
}

abut::fuzz::Record record_at(const std::uint8_t* data, std::size_t size) {
  std::array<std::uint8_t, abut::fuzz::record_size> bytes{};
  std::copy_n(data, std::min(size, bytes.size()), bytes.begin());
  return abut::fuzz::read_record(bytes);
}

}  // namespace

int LLVMFuzzerInitialize(int*, char*** arguments) {
  const std::optional<Pair> named = pair_named((*arguments)[0]);
  if (!named) {
    std::fprintf(stderr, "%s: run this program under the name fuzz_<a>_<b> of two kinds of shapes\n", (*arguments)[0]);
    std::exit(2);
  }
  pair() = *named;
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const abut::fuzz::Verdict verdict = abut::fuzz::judge(pair().a, pair().b, record_at(data, size))) {
    std::fprintf(stderr, "finding: %s\n", verdict->c_str());
    std::abort();
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  if (seed % 4 == 0 || max_size < abut::fuzz::record_size) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  abut::fuzz::Record record = record_at(data, size);
  abut::fuzz::mutate(pair().a, pair().b, record, seed);
  std::ranges::copy(abut::fuzz::bytes_of(record), data);
  return abut::fuzz::record_size;
}
