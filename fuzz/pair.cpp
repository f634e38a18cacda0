// The live target of one pair. ABUT_FUZZ_A and ABUT_FUZZ_B name its kinds.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
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

abut::fuzz::Record record_at(const std::uint8_t* data, std::size_t size) {
  std::array<std::uint8_t, abut::fuzz::record_size> bytes{};
  std::copy_n(data, std::min(size, bytes.size()), bytes.begin());
  return abut::fuzz::read_record(bytes);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const abut::fuzz::Verdict verdict = abut::fuzz::judge(place_a(), place_b(), record_at(data, size))) {
    std::fprintf(stderr, "%s %s: %s\n", ABUT_FUZZ_A, ABUT_FUZZ_B, verdict->c_str());
    std::abort();
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned int seed) {
  if (seed % 4 == 0 || max_size < abut::fuzz::record_size) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  abut::fuzz::Record record = record_at(data, size);
  abut::fuzz::mutate(place_a(), place_b(), record, seed);
  std::ranges::copy(abut::fuzz::bytes_of(record), data);
  return abut::fuzz::record_size;
}
