// SPDX-License-Identifier: Apache-2.0
// The live target of sequences of calls.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <vector>

#include "play.hpp"

extern "C" {
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed);
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size, const std::uint8_t* other,
                                      std::size_t other_size, std::uint8_t* out, std::size_t max_size,
                                      unsigned int seed);
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
}

namespace {

using namespace universe_calls;

Sequence sequence_at(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  std::copy_n(data, size, std::back_inserter(bytes));
  return read_sequence(bytes);
}

// Whole records as far as they fit.
std::size_t write(const Sequence& sequence, std::uint8_t* out, std::size_t max_size) {
  const std::vector<std::uint8_t> bytes = bytes_of(sequence);
  const std::size_t written = std::min(bytes.size(), max_size);
  std::copy_n(bytes.begin(), written, out);
  return written;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const std::optional<std::string> finding = Play(sequence_at(data, size)).run()) {
    std::fprintf(stderr, "universe: %s\n", finding->c_str());
    std::abort();
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  Sequence sequence = sequence_at(data, size);
  // Short inputs grow to sequences in which something happens.
  const unsigned int changes = sequence.calls.size() < 16 ? 16 : 1 + seed % 4;
  for (unsigned int i = 0; i < changes; ++i) {
    mutate(sequence, std::uint64_t{seed} * 64 + i, max_size / call_size);
  }
  return write(sequence, data, max_size);
}

// The beginning of one sequence and the end of the other.
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size, const std::uint8_t* other,
                                      std::size_t other_size, std::uint8_t* out, std::size_t max_size,
                                      unsigned int seed) {
  return write(spliced(sequence_at(data, size), sequence_at(other, other_size), seed), out, max_size);
}
