// The live target of one pair. ABUT_FUZZ_A and ABUT_FUZZ_B name its kinds.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>
#include "core/check.hpp"
import abut.any_shape;
import abut.fuzz;

extern "C" {
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed);
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
}

namespace {

std::size_t place_a() { return abut::find_kind(std::string_view(ABUT_FUZZ_A)).value(); }
std::size_t place_b() { return abut::find_kind(std::string_view(ABUT_FUZZ_B)).value(); }

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // SAFETY: libFuzzer hands over `size` bytes.
  ABUT_UNSAFE_BEGIN
  const std::span bytes(data, size);
  ABUT_UNSAFE_END
  if (const abut::fuzz::Verdict verdict = abut::fuzz::judge(place_a(), place_b(), abut::fuzz::read_record(bytes))) {
    std::fprintf(stderr, "%s %s: %s\n", ABUT_FUZZ_A, ABUT_FUZZ_B, verdict->c_str());
    std::abort();
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  if (seed % 4 == 0 || max_size < abut::fuzz::record_size) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  // SAFETY: libFuzzer hands over a buffer of `max_size` bytes, `size` of them filled.
  ABUT_UNSAFE_BEGIN
  const std::span<std::uint8_t> bytes(data, max_size);
  ABUT_UNSAFE_END
  abut::fuzz::Record record = abut::fuzz::read_record(bytes.first(size));
  abut::fuzz::mutate(place_a(), place_b(), record, seed);
  std::ranges::copy(abut::fuzz::bytes_of(record), bytes.begin());
  return abut::fuzz::record_size;
}
